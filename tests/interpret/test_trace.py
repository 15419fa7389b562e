"""The trace of a stage: its lines, the calls in them, and the bits of the array interpreter."""

from typing import NamedTuple

import numpy as np
import pytest
from fragments import random_inputs
from one_stage import run, stages_by_module

from sss_ref.interpret import arrays
from sss_ref.interpret.trace import Step, trace
from sss_ref.interpret.work import buffer_value, uniform_value
from sss_ref.language import Array, constant, function, pow, select, stage, vec2
from sss_ref.language.pipeline import CLIP_POSITION, PIXEL
from sss_ref.language.types import Vector, components, ivec2

F = np.float32
THIRD = constant(1 / 3)
STAGES = [s for stages in stages_by_module().values() for s in stages if CLIP_POSITION not in s.outputs]


class Sum(NamedTuple):
    total: float
    flag: bool


@function
def twice(v: float) -> float:
    """V + v."""
    doubled = v + v
    return doubled


@stage(source="test")
def summed(start: float, offset: vec2, numbers: Array[float], count: int) -> Sum:
    """A loop with a call in it."""
    total = start
    for k in range(0, count):
        total = total + twice(numbers[k]) * offset.y
    scaled = select(total > 2.0, pow(total, 2.0), -total) * THIRD
    return Sum(scaled, total != 0.0)


def line(step):
    return step.name, step.text, step.value


def test_lines_calls_and_turns():
    steps, results = trace(summed, [F(0.5), vec2(F(7), F(2)), Array(F([0.25, 1])), 2])
    assert results == {"total": F(30.25) * F(1 / 3), "flag": True}
    assert line(steps[0]) == ("total", "start", 0.5)
    loop = steps[1]
    assert (loop.text, loop.value, [turn.text for turn in loop.inner]) == ("for k in range(0, count)", None, ["0", "1"])
    for turn, total, element in zip(loop.inner, (1.5, 5.5), (0.25, 1), strict=True):
        (inside,) = turn.inner
        assert line(inside) == ("total", "total + twice(numbers[k]) * offset.y", total)
        assert [line(call) for call in inside.inner] == [
            ("", "numbers[k]", element),
            ("", "twice(numbers[k])", 2 * element),
        ]
        assert [line(own) for own in inside.inner[1].inner] == [
            ("doubled", "v + v", 2 * element),
            ("", "doubled", 2 * element),
        ]
    assert line(steps[2]) == ("scaled", "select(total > 2.0, pow(total, 2.0), -total) * THIRD", F(30.25) * F(1 / 3))
    assert [line(call) for call in steps[2].inner] == [("", "pow(total, 2.0)", 30.25)]
    assert [line(step) for step in steps[3:]] == [("total", "scaled", results["total"]), ("flag", "total != 0.0", True)]


def scalar(value):
    if isinstance(value, Vector):
        return type(value)(*map(scalar, value))
    return value[0] if isinstance(value, np.ndarray) else value


def inputs_at(stage_, inputs, row, column):
    """What a stage reads at one pixel, as scalars."""
    at = np.array([row]), np.array([column])
    for name, kind in stage_.parameters.items():
        if name == PIXEL:
            yield ivec2(np.int32(column), np.int32(row))
        elif name in inputs.buffers:
            yield scalar(buffer_value(kind, inputs.buffers[name], *at))
        else:
            yield uniform_value(kind, inputs.uniforms[name])


@pytest.mark.parametrize("stage_", STAGES, ids=lambda s: s.name)
def test_values_have_the_bits_of_array_code(stage_):
    inputs = random_inputs(np.random.default_rng(5), 12, 8)
    expected = run(arrays, stage_, inputs)
    for row in range(0, 8, 2):
        for column in range(12):
            steps, results = trace(stage_, list(inputs_at(stage_, inputs, row, column)))
            assert all(isinstance(step, Step) for step in steps)
            for name, value in results.items():
                buffer = expected[name]
                got = np.array(components(value), buffer.dtype)
                assert got.tobytes() == np.atleast_1d(buffer[row, column]).tobytes(), name
