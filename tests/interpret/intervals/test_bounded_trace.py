"""The bounds of every line of a stage: around what the oracle computes there, and as wide as the results' own."""

from typing import NamedTuple

import numpy as np
import pytest
from fragments import random_inputs
from stage_cases import FRAGMENT_STAGES
from traced import inputs_at, summed

from sss_ref.interpret.intervals.bounded_trace import bounds_of, with_bounds
from sss_ref.interpret.intervals.evaluate import run_intervals
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.trace import trace
from sss_ref.language import Array, Texture, fractional_part, size, stage, texel, texel_position, vec2, whole_part
from sss_ref.language.types import components, mat3
from sss_ref.numerics.interval import Interval

F = np.float32
PIXELS = [(0, 0), (0, 5), (0, 11), (3, 7), (5, 2), (7, 10)]  # rows, columns; the degenerate fragments come first


def traced(stage_, profile):
    """What a stage reads at some pixels, and its steps there with their bounds."""
    inputs = random_inputs(np.random.default_rng(5), 12, 8)
    for row, column in PIXELS:
        own = dict(zip(stage_.parameters, inputs_at(stage_, inputs, row, column), strict=True))
        steps, _ = trace(stage_, list(own.values()))
        yield own, with_bounds(steps, stage_, own, PROFILES[profile])


def told(steps):
    """Every line, and every call in one; of loops those of all turns."""
    for step in steps:
        if isinstance(step.source, str):
            yield from told(step.inner)
        else:
            yield from (*step.inner, step)


def parts(step):
    """Value, low and high of each component that is a number; NaN, which undefined operations give, may be anything."""
    rows = zip(*map(components, (step.value, *step.bounds)), strict=True)
    return [row for row in rows if row[0] == row[0]]


@pytest.mark.parametrize("profile", ["vulkan", "gl", "mediump"])
@pytest.mark.parametrize("stage_", FRAGMENT_STAGES, ids=lambda s: s.name)
def test_the_oracles_lines_lie_inside(stage_, profile):
    for _, steps in traced(stage_, profile):
        assert all(low <= value <= high for step in told(steps) for value, low, high in parts(step))


@pytest.mark.parametrize("stage_", FRAGMENT_STAGES, ids=lambda s: s.name)
def test_ieee_leaves_one_value_to_every_line(stage_):
    for _, steps in traced(stage_, "ieee"):
        assert all(low == value == high for step in told(steps) for value, low, high in parts(step))


@pytest.mark.parametrize("stage_", FRAGMENT_STAGES, ids=lambda s: s.name)
def test_the_last_lines_are_as_wide_as_the_results(stage_):
    for own, steps in traced(stage_, "vulkan"):
        results = run_intervals(stage_, own, PROFILES["vulkan"])
        for step, name in zip(steps[-len(stage_.outputs) :], stage_.writes.values(), strict=True):
            assert repr(step.bounds) == repr(bounds_of(results[name].value))


def bounded(stage_, *inputs):
    """The steps of a stage with their bounds."""
    steps, _ = trace(stage_, inputs)
    return with_bounds(steps, stage_, dict(zip(stage_.parameters, inputs, strict=True)), PROFILES["vulkan"])


def test_every_turn_of_a_loop_has_bounds_of_its_own():
    steps = bounded(summed, F(0.5), vec2(F(7), F(2)), Array(F([0.25, 1])), 2)
    lines = [inside for turn in steps[1].inner for inside in turn.inner]
    assert [line.value for line in lines] == [1.5, 5.5]
    assert [line.bounds for line in lines] == [(1.5, 1.5), (5.5, 5.5)]  # sums and products of few bits are exact
    assert [[call.bounds[0] for call in line.inner] for line in lines] == [[0.25, 0.5], [1, 2]]  # doubling is exact


class Corner(NamedTuple):
    value: float
    share: float


@stage(source="test")
def corner_of(picture: Texture[float], uv: vec2) -> Corner:
    """The lower left one of four neighbours, and how far from it a position lies."""
    at = texel_position(size(picture), uv)
    corner = whole_part(at)
    return Corner(texel(picture, corner), fractional_part(at).x)


def test_where_a_position_may_lie_in_two_cells_the_lines_of_both_count():
    picture = Texture(np.arange(12, dtype=F).reshape(3, 4))
    _, corner, value, share = bounded(corner_of, picture, vec2(F(0.625), F(0.6)))  # in texels 2, 1.3
    assert [(end.x, end.y) for end in corner.bounds] == [(1, 1), (2, 1)]
    assert (value.value, value.bounds) == (6, (5, 6)) and share.bounds == (0, 1)


def test_the_bounds_of_what_is_read():
    low, high = bounds_of(vec2(Interval(F([1]), F([2])), F([3])))
    assert ((low.x, low.y), (high.x, high.y)) == ((1, 3), (2, 3))
    assert bounds_of(np.array([True])) == (True, True)
    assert bounds_of(mat3(np.eye(3))) is None and bounds_of(Texture(np.zeros((2, 2), F))) is None
