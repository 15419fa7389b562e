"""Every stage that runs per fragment, each with inputs to try it on."""

from dataclasses import replace

import numpy as np
import pytest
from fragments import VARIANTS, random_inputs
from retyped_stages import RETYPED

from sss_ref.language.pipeline import CLIP_POSITION
from sss_ref.methods.stages import all_stages

FRAGMENT_STAGES = [stage for stage in all_stages().values() if CLIP_POSITION not in stage.outputs]
SIZES = (((24, 16), 1), ((1, 1), 2))
CASES = [
    pytest.param(stage, overrides, size, seed, id=f"{stage.name}-{number}-{size[0]}x{size[1]}-seed{seed}")
    for stage in FRAGMENT_STAGES
    for number, overrides in enumerate([{}, *VARIANTS.get(stage.name, [])])
    for size, seed in SIZES
]
CASES += [
    pytest.param(stage, {}, size, seed, id=f"{name}-{size[0]}x{size[1]}-seed{seed}")
    for name, stage in RETYPED.items()
    for size, seed in SIZES
]


def inputs_of(overrides, size, seed):
    """What a case's stage reads: random and degenerate fragments, and uniforms of which some are overridden."""
    inputs = random_inputs(np.random.default_rng(seed), *size)
    return replace(inputs, uniforms={**inputs.uniforms, **overrides})
