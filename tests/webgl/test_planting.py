"""Which mistakes are planted: seen at enough pixels, in one line, each in another."""

from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.language import stage, vec2, vec4
from sss_ref.language.pipeline import CLIP_POSITION
from sss_ref.webgl import planting
from sss_ref.webgl.allowed import Allowed
from sss_ref.webgl.planting import MOST, TRIED, WrongLine, wrong_lines

F = np.float32
RIGHT = ["a", "b", "c"]


class Two(NamedTuple):
    first: float
    second: float


@stage(source="a test")
def two_lines(x: float, y: float) -> Two:
    """Two lines with a few places each."""
    first = x * 2.0 + y
    second = x - y
    return Two(first, second)


def allowed(middle, reach):
    middle = np.array(middle, F)
    state = np.ones(middle.shape[:2], np.uint8)
    return Allowed(middle, (middle - F(reach)).astype(F), (middle + F(reach)).astype(F), state)


@pytest.mark.parametrize(
    ("value", "is_far"),
    [(1.5, False), (2.0, False), (2.25, True), (0.0, False), (-0.25, True), (np.nan, False), (np.inf, False)],
)
def test_far_off_is_twice_as_far_as_is_right(value, is_far):
    """Right is 1 from 0.5 to 1.5."""
    right, where = allowed([[1.0, 1.0]], 0.5), np.array([[False, True]])
    assert planting._far_off(right, 0, np.array([value], F), where).tolist() == [is_far]


def test_each_channel_has_its_own_bounds():
    right, where = allowed([[(1, 5)]], 0.5), np.array([[True]])
    assert [planting._far_off(right, channel, np.array([5], F), where).item() for channel in (0, 1)] == [True, False]


@pytest.mark.parametrize(("wrong", "is_seen"), [(0, False), (4, False), (5, True), (100, True)])
def test_a_mistake_shows_at_one_of_twenty_pixels(wrong, is_seen):
    """Of a hundred that are judged; others do not count."""
    where = np.zeros((10, 20), bool)
    where[:, :10] = True
    right = {"lit": allowed(np.zeros((10, 20, 2)), 0.25), "other": allowed(np.zeros((10, 20)), 0.25)}
    exam = SimpleNamespace(where=where, right=right)
    off = np.zeros(100, F)
    off[:wrong] = 9
    for results in ({"lit": vec2(np.zeros(100, F), off)}, {"other": off, "unknown": np.full(100, F(9))}):
        assert planting._is_seen(exam, results) == is_seen
    assert planting._is_seen(exam, {"lit": vec2(F(0), F(9))}), "one value for all"


@pytest.mark.parametrize(
    ("moved", "by", "elsewhere"),
    [(2, 1.0, True), (1, 1.0, False), (4, 0.04, False), (4, 0.06, True), (2, np.nan, False), (2, np.inf, False)],
)
def test_half_of_the_vertices_move_by_a_twentieth_of_what_all_reach_over(moved, by, elsewhere):
    right = np.array([(0, 0), (1, 4), (0, 4), (1, 0)], float)
    wrong = right.copy()
    wrong[:moved, 0] += by
    assert planting._is_elsewhere(right, wrong) == elsewhere
    wrong = right.copy()
    wrong[:moved, 1] += 4 * by
    assert planting._is_elsewhere(right, wrong) == elsewhere
    assert planting._moves([right, right], [right, wrong]) == elsewhere


def test_by_exactly_a_twentieth_no_vertex_moves():
    right = np.array([(0, 0), (0, 0), (0, 0), (1, 4)], float)
    assert not planting._is_elsewhere(right, np.add(right, (0.05, 0.2)))
    assert planting._is_elsewhere(right, np.add(right, (0.05, 0.2001)))


def test_vertices_lie_where_w_brings_them():
    """What is shown follows, by its name; what is not shown is left out."""
    clip = vec4(F([2, 4]), F([6, 8]), F([1, 1]), F([2, 4]))
    varyings = {"uv": vec2(F([1, 2]), F([3, 4])), "b": F([5, 6]), "left_out": F([0, 0])}
    found = planting._of_vertices({**varyings, CLIP_POSITION: clip}, ["uv", "absent", "b"])
    window, second, third = (each.tolist() for each in found)
    assert window == [[1, 3, 0.5], [1, 2, 0.25]] and third == [[1, 3], [2, 4]] and np.ravel(second).tolist() == [5, 6]


@pytest.mark.parametrize(
    ("wrong", "expected"),
    [
        (["a", "x", "c"], WrongLine("words", 2, "x")),
        (["x", "b", "c"], WrongLine("words", 1, "x")),
        (["a", "b", "x"], WrongLine("words", 3, "x")),
        (["a", "b", "c"], None),
        (["x", "b", "x"], None),
        (["a", "x", "c", "d"], None),
        (["a", "x"], None),
    ],
)
def test_a_mistake_is_one_line(wrong, expected):
    assert planting._only_line(SimpleNamespace(description="words"), RIGHT, wrong) == expected


def test_the_first_mistake_of_each_line_comes_before_all_second_ones():
    found = [each.line for each in planting._other_lines(two_lines)]
    lines = list(dict.fromkeys(found))
    assert len(lines) >= 2 and found[: len(lines)] == lines and len(found) > 2 * len(lines)
    turns = [found[:k].count(line) for k, line in enumerate(found)]
    assert turns == sorted(turns)


def chosen(is_seen, shader=None):
    """The wrong lines of the stage, and how many mutants were looked at."""
    looked = []

    def seen(results):
        looked.append(results)
        return is_seen

    text = shader or (lambda each: f"{each.body is two_lines.body}\nsame")
    found = planting._chosen(two_lines, text, seen, [F([1, 2]), F([3, 5])])
    return found, len(looked)


def test_two_lines_at_most_are_planted_no_two_in_one():
    """Each shader after the right one differs from it in the next of four lines; or all of them in the first."""
    texts = ["a\nb\nc\nd", "x\nb\nc\nd", "a\nx\nc\nd", "a\nb\nx\nd"]
    given = iter(texts)
    found, looked = chosen(True, lambda each: next(given))
    assert [(each.line, each.text) for each in found] == [(1, "x"), (2, "x")] and looked == 2 == MOST
    found, looked = chosen(True)
    assert [(each.line, each.text) for each in found] == [(1, "False")] and 2 < looked <= TRIED == 40


def test_none_is_planted_that_is_not_seen():
    found, looked = chosen(False)
    assert found == [] and 0 < looked <= TRIED


@pytest.mark.parametrize(("rounds", "where"), [(2, [[True]]), (1, [[False]])])
def test_a_pass_that_is_fed_back_or_judged_nowhere_has_none(rounds, where):
    exam = SimpleNamespace(of=SimpleNamespace(rounds=rounds), where=np.array(where))
    assert wrong_lines(exam, {}, str) == []


def test_what_reads_beside_a_texture_gives_nothing():
    def beside(*_):
        raise IndexError

    assert planting._results(beside, []) == {} and planting._results(lambda x: {"a": x}, [1]) == {"a": 1}
