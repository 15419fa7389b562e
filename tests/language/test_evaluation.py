"""A tree that is run gives what the function gives that it came from."""

import numpy as np
import pytest
from fragments import random_inputs
from one_stage import run
from stage_cases import FRAGMENT_STAGES
from traced import inputs_at, summed

from sss_ref.interpret import arrays
from sss_ref.interpret.trace import trace
from sss_ref.language import Array, vec2
from sss_ref.language.evaluation import run_body
from sss_ref.language.types import components

F = np.float32


def test_a_body_gives_what_its_trace_does():
    given = [F(0.5), vec2(F(7), F(2)), Array(F([0.25, 1])), 2]
    assert run_body(summed.body, dict(zip(summed.parameters, given, strict=True))) == trace(summed, given)[1]


@pytest.mark.parametrize("stage", FRAGMENT_STAGES, ids=lambda s: s.name)
def test_values_have_the_bits_of_array_code(stage):
    inputs = random_inputs(np.random.default_rng(7), 6, 4)
    expected = run(arrays, stage, inputs)
    for row, column in ((0, 0), (1, 4), (3, 5)):
        given = dict(zip(stage.parameters, inputs_at(stage, inputs, row, column), strict=True))
        with np.errstate(all="ignore"):
            results = run_body(stage.body, given)
        for own, value in results.items():
            buffer = expected[stage.writes[own]]
            got = np.array(components(value), buffer.dtype)
            assert got.tobytes() == np.atleast_1d(buffer[row, column]).tobytes()
