"""Every stage of the package, on random and degenerate fragments: naive loop, array code and kernel give one result."""

import ast
from pathlib import Path
from types import FunctionType

import naive_published
import naive_stages
import numpy as np
import pytest
from one_stage import assert_same_bits, run, run_naively
from retyped_stages import once_a_channel
from stage_cases import CASES, FRAGMENT_STAGES, inputs_of

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.methods.stages import all_stages

NAIVE = {
    name: value
    for module in (naive_stages, naive_published)
    for name, value in vars(module).items()
    if isinstance(value, FunctionType) and value.__module__ == module.__name__ and not name.startswith("_")
}


@pytest.mark.parametrize(("stage", "overrides", "size", "seed"), CASES)
def test_array_code_gives_the_bits_of_the_naive_loop(stage, overrides, size, seed):
    inputs = inputs_of(overrides, size, seed)
    expected = run_naively(once_a_channel(NAIVE[stage.name], stage), stage, inputs)
    assert all(np.isfinite(buffer).all() for buffer in expected.values())  # rule A6, degenerate fragments included
    assert_same_bits(run(arrays, stage, inputs), expected)


@pytest.mark.parametrize(("stage", "overrides", "size", "seed"), CASES)
def test_kernel_gives_the_bits_of_array_code(stage, overrides, size, seed):
    inputs = inputs_of(overrides, size, seed)
    assert_same_bits(run(kernel, stage, inputs), run(arrays, stage, inputs))


@pytest.mark.parametrize("stage", [stage for stage in FRAGMENT_STAGES if bool in stage.outputs.values()])
def test_fragments_decide_both_ways(stage):
    """Else the comparisons above would say little about stages that answer yes or no."""
    written = run(arrays, stage, inputs_of({}, (24, 16), 1))
    for name, kind in stage.outputs.items():
        assert kind is not bool or set(np.unique(written[name])) == {0, 1}


def test_every_stage_has_its_naive_namesake():
    assert set(NAIVE) == set(all_stages())


@pytest.mark.parametrize("stage", all_stages().values(), ids=lambda stage: stage.name)
def test_every_stage_is_worked_by_hand(stage):
    """In the test file that lies as the stage's module does."""
    _, *rooms, module = stage.python.__module__.split(".")
    tests = Path(__file__).parents[1].joinpath(*rooms, f"test_{module}.py")
    assert f"test_{stage.name}" in {node.name for node in ast.parse(tests.read_text()).body if hasattr(node, "name")}
