"""Which lines make an interval wide, on lines put together by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.interpret.trace import Step
from sss_ref.language import tree, vec3
from sss_ref.validation.witness import widening

ULP = 2.0**-23  # of 1


def line(name, *reads, bounds=None):
    """A line that assigns a name and reads others."""
    parts = [tree.Variable(float, read) for read in reads] or [tree.Literal(float, 1.0)]
    return Step(name, parts[0] if len(parts) == 1 else tree.Operation(float, "+", tuple(parts)), None, bounds=bounds)


def steepest(lines, read):
    return [told.partition(" = ")[0] for told in widening._steepest(lines, read)]


def test_the_three_lines_that_widen_most_are_told_in_order():
    """By how many times each is wider than the widest that it reads; less than a unit counts as one."""
    lines = [
        (line("a", "x"), 40.0),  # 10 times
        (line("b", "x", "a"), 80.0),  # twice
        (line("c", "y"), 3.0),  # 3 times
        (line("d", "z"), 4.0),  # 8 times: of 0.5, as of 1
        (line("e", "nothing"), 7.0),
    ]
    read = {"x": 4.0, "y": 1.0, "z": 0.5}
    assert steepest(lines, read) == ["a", "d", "e"]
    assert steepest(lines[:3], read) == ["a", "b", "c"]
    assert steepest([(line("a", "x"), 0.0), (line("b", "x"), 1.0)], read) == ["b"]


def test_where_bounds_are_lost_is_told_once():
    lines = [(line("a", "x"), np.inf), (line("b", "a"), np.inf), (line("c", "x"), 2.0)]
    assert steepest(lines, {"x": 4.0}) == ["a", "c"]


def test_a_line_is_told_with_its_width():
    wide, lost = widening._told(line("a", "x"), 12.0), widening._told(line("a", "x"), np.inf)
    assert (wide, lost) == ("a = x: 12 ulp", "a = x: unbounded")


@pytest.mark.parametrize(("length", "shortened"), [(48, False), (49, True)])
def test_a_long_line_is_shortened(length, shortened):
    step = SimpleNamespace(name="a", text="b" * (length - 4))
    told = widening._told(step, 2.0)
    assert told == ("a = " + "b" * 41 + "...: 2 ulp" if shortened else "a = " + "b" * 44 + ": 2 ulp")


def test_of_a_loop_the_lines_of_its_last_turn_are_meant():
    turns = [
        Step("", f"turn {k}", None, inner=(line("a", bounds=(np.float32(1), np.float32(1 + k * ULP))),))
        for k in range(4)
    ]
    loop, empty = Step("", "for", None, inner=tuple(turns)), Step("", "for", None)
    unbounded = line("b")
    assert [(step.name, width) for step, width in widening._lines([loop, empty, unbounded])] == [("a", 3.0)]


def test_a_width_is_in_units_of_the_vectors_greatest_number():
    def width(low, high):
        return widening._width((low, high))

    one, few = np.float32(1), np.float32(1 + 5 * ULP)
    assert width(one, few) == 5 and width(one, one) == 0 and width(np.int32(1), np.int32(4)) == 0
    assert width(vec3(one, one, np.float32(4)), vec3(few, one, np.float32(4))) == 5 / 4
    assert width(vec3(-np.float32(4), one, one), vec3(-np.float32(4), one, few)) == 5 / 4
    assert width(one, np.float32(np.inf)) == np.inf and width(-np.float32(np.inf), one) == np.inf
