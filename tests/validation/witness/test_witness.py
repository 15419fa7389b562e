"""The verdict on a single pixel, on witnesses put together by hand."""

from typing import NamedTuple

import numpy as np
import pytest
from painted_witness import F, painted_witness

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.language import Texture, nearest_texel, select, size, stage, texel, vec2
from sss_ref.numerics.interval import Interval
from sss_ref.validation.witness.situation import Situation
from sss_ref.validation.witness.witness import DrawnValue, Witness, as_value

PLAIN = DrawnValue("camera", "shade", (0, 0))
RIGHT = F([-27, 42.25, 189.5])


class Shade(NamedTuple):
    """A number."""

    shade: float


@stage(source="a test")
def chosen(value: float, limit: float) -> Shade:
    """One of two numbers."""
    return Shade(select(value < limit, 2.0, 2.5))


class Pair(NamedTuple):
    """Two numbers."""

    pair: vec2


@stage(source="a test")
def turned(values: vec2) -> Pair:
    """Two numbers, the other way round."""
    return Pair(vec2(values.y, values.x))


@stage(source="a test")
def looked_up(picture: Texture[float], uv: vec2) -> Shade:
    """One of several texels."""
    return Shade(texel(picture, nearest_texel(size(picture), uv)))


def between(low, high):
    return Interval(F([low]), F([high]))


def witness_of(stage, got, given, drawn=PLAIN, **bounds):
    return Witness(Situation(stage, given, given | bounds), "shade", F([got]), drawn, PROFILES["ieee"])


def chosen_of(got, **bounds):
    return witness_of(chosen, got, {"value": F(1), "limit": F(3)}, **bounds)


def test_what_is_given_exactly_has_one_right_value():
    assert painted_witness("tinted", RIGHT).outcome == "certain"
    for channel in range(3):
        wrong = RIGHT.copy()
        wrong[channel] = np.nextafter(wrong[channel], F(0))
        assert painted_witness("tinted", wrong).outcome == "fail"
    assert painted_witness("steps", np.int32([0])).outcome == "certain"
    assert painted_witness("steps", np.int32([1])).outcome == "fail"


@pytest.mark.parametrize(("got", "outcome"), [((2, 1), "certain"), ((2, 2), "fail"), ((1, 2), "fail")])
def test_two_components_are_judged_each(got, outcome):
    given = {"values": vec2(F(1), F(2))}
    assert Witness(Situation(turned, given, given), "pair", F(got), PLAIN, PROFILES["ieee"]).outcome == outcome


def test_what_does_not_come_through_widens_nothing():
    """`flat` is 1 to 3, and what is mixed by the larger of it and 9.75."""
    witness = painted_witness("tinted", RIGHT, flat=between(1, 3))
    assert witness.reach.tolist() == [0, 0, 0]


def test_storage_adds_to_the_reach():
    """A texture of bytes keeps 0.5 as 127/255 or 128/255, a step of 1/255 at most beside it."""
    stored = DrawnValue("camera", "shade", (0, 0), "unorm8")
    texture = DrawnValue("camera", "shade", (0, 0), "float32", "unorm8")
    given = {"value": F(1), "limit": F(3)}
    for drawn in (stored, texture):
        assert witness_of(chosen, 2, given, drawn).reach[0] > 0
    low, high = witness_of(chosen, 2 + 1 / 255, given, texture).allowed
    assert low < 2 < high and witness_of(chosen, 2 + 0.9 / 255, given, texture).outcome == "certain"
    assert witness_of(chosen, 2 + 1.1 / 255, given, texture).outcome == "fail"


def test_the_least_and_the_greatest_right_value():
    low, high = chosen_of(2, value=between(1, 4)).allowed
    assert (low.tolist(), high.tolist()) == ([1.5], [2.5]) and low.dtype == high.dtype == np.float32


def test_an_undecided_condition_leaves_two_values():
    undecided = chosen_of(2.5, value=between(1, 4))
    assert undecided.outcome == "ambiguous" and undecided.doubts == ["a condition may hold or not"]
    assert chosen_of(2.5).outcome == "fail" and chosen_of(2.5).doubts == []
    assert chosen_of(2).outcome == "certain" and chosen_of(2.625, value=between(1, 4)).outcome == "fail"


def test_an_undecided_texel_leaves_several():
    picture = Texture(F([[1, 2, 2.5, 8]]))
    given = {"picture": picture, "uv": vec2(F(0.3), F(0.5))}  # of texel 1
    sure, either = vec2(between(0.3, 0.4), between(0.5, 0.5)), vec2(between(0.3, 0.6), between(0.5, 0.5))
    assert witness_of(looked_up, 2, given, uv=sure).outcome == "certain"
    assert witness_of(looked_up, 2, given, uv=sure).doubts == []
    found = witness_of(looked_up, 2.5, given, uv=either)
    assert found.outcome == "ambiguous" and found.doubts == ["one of several texels may be read"]
    assert witness_of(looked_up, 8, given, uv=either).outcome == "fail"


@pytest.mark.parametrize("got", [np.nan, np.inf])
def test_what_is_no_number_is_wrong(got):
    assert chosen_of(got).outcome == "fail"


def test_a_value_of_one_component_is_that():
    value = as_value(float, F([3, 4]))
    assert value == 3 and isinstance(value, np.float32)
    assert [*as_value(vec2, F([1, 2]))] == [1, 2]
