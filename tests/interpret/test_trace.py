"""The trace of a stage: its lines, the calls in them, and the bits of the array interpreter."""

import numpy as np
import pytest
from fragments import random_inputs
from one_stage import run
from stage_cases import FRAGMENT_STAGES
from traced import inputs_at, summed

from sss_ref.interpret import arrays
from sss_ref.interpret.trace import Step, trace
from sss_ref.language import Array, vec2
from sss_ref.language.types import components

F = np.float32


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


@pytest.mark.parametrize("stage_", FRAGMENT_STAGES, ids=lambda s: s.name)
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
