"""How sure a place is among others, by scores that are given."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.capture.candidate import Candidate, _mean, _selections
from sss_ref.capture.rivalry import Rivalry, overlap, surest_first


def at(surface, name, score, close=0.0, channels=(0,)):
    return Candidate(surface, name, score, close, channels, "top", 1.0, 1.0)


def among(*candidates, contents="abcdef"):
    return Rivalry([SimpleNamespace(content=content) for content in contents], candidates)


def test_what_hardly_speaks_for_a_place_is_none():
    rivalry = among(at(0, "a", 0.15), at(1, "a", 0.149))
    assert [each.score for each in rivalry.candidates] == [0.15]


def test_a_place_without_another_is_as_sure_as_its_score():
    only = at(0, "a", 0.7)
    assert among(only).margin(only) == 0.7 and among(only).rivals(only) == []


@pytest.mark.parametrize(
    ("score", "close", "margin"),
    [
        (0.7, 0.5, 0.2),  # clearly less speaks for it
        (0.84, 0.5, 0.06),
        (0.86, 0.5, 0.0),  # as good: within .05
        (0.95, 0.5, 0.0),
        (0.7, 0.56, 0.0),  # its numbers alone are clearly better
        (0.7, 0.54, 0.2),
    ],
)
def test_another_surface_for_the_same_buffer(score, close, margin):
    first, other = at(0, "a", 0.9, close=0.5), at(1, "a", score, close=close)
    rivalry = among(first, other)
    assert rivalry.margin(first) == pytest.approx(margin)
    assert rivalry.rivals(first) == ([other] if margin < 0.05 else [])


@pytest.mark.parametrize(("score", "margin"), [(0.7, 0.2), (0.86, 0.0)])
def test_another_buffer_for_the_same_surface(score, margin):
    first, other = at(0, "a", 0.9), at(0, "b", score)
    assert among(first, other).margin(first) == pytest.approx(margin)
    elsewhere = at(0, "b", score, channels=(1,))  # another channel: no rival
    assert among(first, elsewhere).margin(first) == 0.9


@pytest.mark.parametrize(("use", "margin"), [(0.6, 0.65), (0.59, 0.0)])
def test_a_surface_that_is_as_good_but_has_a_use_of_its_own(use, margin):
    """.9 and what is left for the other, less .85."""
    first, other, own = at(0, "a", 0.9), at(1, "a", 0.851), at(1, "b", use)
    expected = pytest.approx(0.9 + use - 0.851) if margin else 0.0
    assert among(first, other, own).margin(first) == expected


def test_a_use_that_a_third_surface_has_a_better_claim_to_does_not_count():
    first, other, own = at(0, "a", 0.9), at(1, "a", 0.851), at(1, "b", 0.7)
    assert among(first, other, own, at(2, "b", 0.76)).margin(first) == 0.0
    assert among(first, other, own, at(2, "b", 0.74)).margin(first) == pytest.approx(0.9 + 0.7 - 0.851)


def test_a_buffer_that_has_another_surface():
    first, other, instead = at(0, "a", 0.9), at(0, "b", 0.88), at(1, "b", 0.8)
    assert among(first, other, instead).margin(first) == pytest.approx(0.9 + 0.8 - 0.88)
    claimed = at(1, "c", 0.86)  # that surface has a better place
    assert among(first, other, instead, claimed).margin(first) == 0.0


def test_two_surfaces_that_hold_the_same_are_no_rivals_where_each_has_a_place():
    first, twin = at(0, "a", 0.9), at(1, "a", 0.9)
    own, also = at(0, "b", 0.9), at(1, "b", 0.9)
    assert among(first, twin, own, also, contents="xx").margin(first) == 0.9
    assert among(first, twin, own, also, contents="xy").margin(first) < 0.9


def test_channels_that_are_shared_and_the_order_of_the_surest():
    assert overlap(at(0, "a", 1, channels=(0, 1)), at(0, "b", 1, channels=(1,)))
    assert not overlap(at(0, "a", 1, channels=(0, 1)), at(0, "b", 1, channels=(2,)))
    assert not overlap(at(0, "a", 1), at(1, "b", 1))
    assert [each.score for each in surest_first([at(0, "a", 0.2), at(0, "b", 0.9), at(0, "c", 0.5)])] == [0.9, 0.5, 0.2]


@pytest.mark.parametrize(
    ("channels", "close", "ordered", "sure"),
    [
        ((0, 1, 2), 0.0, 0.03, True),
        ((0, 1, 2), 0.0, 0.029, False),
        ((0, 1, 2), 0.0, 0.0, True),  # any order gives the same
        ((2, 1, 0), 0.0, 0.05, True),
        ((2, 1, 0), 0.0, 0.049, False),
        ((1, 0, 2), 0.85, 0.03, True),
        ((1, 0, 2), 0.849, 0.9, False),
        ((1, 0, 2), 0.9, 0.029, False),
        ((1, 0, 2), 0.0, -1e-10, True),
        ((0, 1, 2), 0.0, 1e-9, False),
    ],
)
def test_when_the_order_of_channels_is_sure(channels, close, ordered, sure):
    assert Candidate(0, "a", 1.0, close, channels, "top", 1.0, ordered).has_sure_order is sure


def test_of_many_channels_those_are_tried_that_are_among_the_best():
    few = np.array([[0.1], [0.9], [0.5], [0.3]])
    assert [*_selections(few, (0, 1, 2, 3))] == [(0,), (1,), (2,), (3,)]
    many = np.array([[0.1], [0.9], [0.5], [0.3], [0.8]])
    assert [*_selections(many, (0, 1, 2, 3, 4))] == [(1,), (2,), (4,)]
    two = np.array([[0.9, 0.1], [0.2, 0.8], [0.5, 0.4]])
    assert _mean(two, (0, 1)) == pytest.approx(0.85) and _mean(two, (2, 0)) == pytest.approx(0.3)
