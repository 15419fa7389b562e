"""Every stage of the package, on random and degenerate fragments: naive loop, array code and kernel give one result."""

from dataclasses import replace
from importlib import import_module
from types import FunctionType

import naive_published
import naive_stages
import numpy as np
import pytest
from fragments import VARIANTS, random_inputs
from one_stage import assert_same_bits, run, run_naively, stages_by_module

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import loops as kernel
from sss_ref.language.pipeline import CLIP_POSITION

MODULES = stages_by_module()
STAGES = {stage.name: stage for stages in MODULES.values() for stage in stages}
FRAGMENT_STAGES = [stage for stage in STAGES.values() if CLIP_POSITION not in stage.outputs]
NAIVE = {
    name: value
    for module in (naive_stages, naive_published)
    for name, value in vars(module).items()
    if isinstance(value, FunctionType) and value.__module__ == module.__name__ and not name.startswith("_")
}
CASES = [
    pytest.param(stage, overrides, size, seed, id=f"{stage.name}-{number}-{size[0]}x{size[1]}-seed{seed}")
    for stage in FRAGMENT_STAGES
    for number, overrides in enumerate([{}, *VARIANTS.get(stage.name, [])])
    for size, seed in (((24, 16), 1), ((1, 1), 2))
]


def inputs_of(overrides, size, seed):
    inputs = random_inputs(np.random.default_rng(seed), *size)
    return replace(inputs, uniforms={**inputs.uniforms, **overrides})


@pytest.mark.parametrize(("stage", "overrides", "size", "seed"), CASES)
def test_array_code_gives_the_bits_of_the_naive_loop(stage, overrides, size, seed):
    inputs = inputs_of(overrides, size, seed)
    expected = run_naively(NAIVE[stage.name], stage, inputs)
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
    assert set(NAIVE) == set(STAGES)


@pytest.mark.parametrize(("module", "stage"), [(module, s.name) for module, stages in MODULES.items() for s in stages])
def test_every_stage_is_worked_by_hand(module, stage):
    assert hasattr(import_module(f"test_{module}"), f"test_{stage}")
