"""Every mistake that a stage may have, by its lines."""

from typing import NamedTuple

import numpy as np

from sss_ref.language import Array, Texture, function, ivec2, length, max, select, stage, texel, vec2, vec3
from sss_ref.validation.cause.mutants import mutants


class One(NamedTuple):
    """A number."""

    one: float


@function
def twice(a: float, b: float) -> float:
    """A function of the test's own."""
    return a * b + 2.0


def wrong_lines(of):
    """The line and its mistake of every mutant, and the function that it is in."""
    return [(each.line, each.wrong, each.inside) for each in mutants(of)]


def of(line, *wrong, inside=""):
    return [(line, each, inside) for each in wrong]


@stage(source="a test")
def sums(a: float, b: float) -> One:
    """Operators of numbers."""
    c = a + b
    d = c - a
    e = -(d * b)
    return One(e / c)


def test_operators_and_operands():
    assert wrong_lines(sums) == [
        *of("c = a + b", "c = a - b", "c = a", "c = b"),
        *of("d = c - a", "d = c + a", "d = a - c", "d = c", "d = a"),
        *of("e = -(d * b)", "e = d * b", "e = -(d / b)", "e = -d", "e = -b"),
        *of("one = e / c", "one = e * c", "one = c / e", "one = e", "one = c"),
    ]


@stage(source="a test")
def chosen(a: float, b: float, c: bool) -> One:
    """Comparisons and choices."""
    near = (a < b) & c
    far = (a <= 0.0) | (b >= 1.0)
    return One(select(near & far, max(a, 0.5), 2.0))


def test_comparisons_literals_and_calls():
    assert wrong_lines(chosen) == [
        *of("near = (a < b) & c", "near = (a < b) | c", "near = a < b", "near = c", "near = (a >= b) & c"),
        *of("far = (a <= 0.0) | (b >= 1.0)", "far = (a <= 0.0) & (b >= 1.0)", "far = a <= 0.0", "far = b >= 1.0"),
        *of("far = (a <= 0.0) | (b >= 1.0)", "far = (a > 0.0) | (b >= 1.0)", "far = (a <= 1.0) | (b >= 1.0)"),
        *of("far = (a <= 0.0) | (b >= 1.0)", "far = (a <= 0.0) | (b < 1.0)", "far = (a <= 0.0) | (b >= 0.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = max(a, 0.5)", "one = 2.0"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, 2.0, max(a, 0.5))"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near | far, max(a, 0.5), 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near, max(a, 0.5), 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(far, max(a, 0.5), 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, a, 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, 0.5, 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, max(0.5, a), 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, max(a, 0.0), 2.0)"),
        *of("one = select(near & far, max(a, 0.5), 2.0)", "one = select(near & far, max(a, 0.5), 1.0)"),
    ]


class Many(NamedTuple):
    """A colour."""

    many: vec3


@stage(source="a test")
def summed(lit: Texture[vec3], pixel: ivec2, weight: Array[float], count: int, uv: vec2, axis: vec3) -> Many:
    """A loop, members, and a function of the test's own."""
    total = vec3(0.0, 0.0, 0.0)
    for tap in range(0, count):
        total = total + texel(lit, pixel) * weight[tap]
    scale = twice(uv.x, axis.z)
    return Many(total * scale)


def test_loops_members_and_functions():
    found = wrong_lines(summed)
    assert (
        "total = total + texel(lit, pixel) * weight[tap]",
        "total = total - texel(lit, pixel) * weight[tap]",
        "",
    ) in found
    turns = [wrong for line, wrong, _ in found if line == "total = total + texel(lit, pixel) * weight[tap]"]
    assert {"total = total - texel(lit, pixel) * weight[tap]", "total = total"} <= set(turns)
    scales = [wrong for line, wrong, _ in found if line.startswith("scale = ")]
    assert scales == [
        "scale = uv.x",
        "scale = axis.z",
        "scale = twice(axis.z, uv.x)",
        "scale = twice(uv.y, axis.z)",
        "scale = twice(uv.x, axis.x)",
    ]
    inside = ["a * b - 2.0", "a * b", "2.0", "a / b + 2.0", "a + 2.0", "b + 2.0", "a * b + 1.0"]
    assert [each for each in found if each[2]] == of("a * b + 2.0", *inside, inside="twice")


def test_a_mutant_computes_what_its_line_says():
    results = {each.wrong: each(np.float32(3), np.float32(4)) for each in mutants(sums)}
    assert results["c = a - b"] == {"one": np.float32(-(((3 - 4) - 3) * 4) / (3 - 4))}
    assert results["one = e * c"] == {"one": np.float32(-16 * 7)}
    assert results["e = d * b"] == {"one": np.float32(16 / 7)}


def test_a_mistake_in_a_function_is_wherever_it_is_called():
    @stage(source="a test")
    def both(a: float, b: float) -> One:
        """The function twice, once in itself."""
        return One(twice(twice(a, b), b))

    found = {each.wrong: each for each in mutants(both) if each.inside}
    assert found["a * b - 2.0"](np.float32(3), np.float32(4)) == {"one": np.float32((3 * 4 - 2) * 4 - 2)}
    assert found["a * b - 2.0"].description == "`a * b - 2.0` for `a * b + 2.0` in twice"
    (whole,) = (each for each in mutants(both) if each.wrong == "one = b")
    assert whole.description == "`one = b` for `one = twice(twice(a, b), b)`"


@stage(source="a test")
def alone(axis: vec3) -> One:
    """A call with one argument of another type, in which nothing can be mistaken."""
    return One(length(axis))


def test_a_call_with_one_argument_has_none_to_swap():
    assert wrong_lines(alone) == []
