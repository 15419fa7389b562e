"""Every stage on a software OpenGL, on random and degenerate fragments: the shader computes what array code does."""

import numpy as np
import pytest
from one_stage import assert_same_bits, run
from opengl import needs_mesa
from stage_cases import CASES, inputs_of

from sss_ref.gl.canvas import Canvas
from sss_ref.gl.context import open_context
from sss_ref.gl.shaders import own_shaders
from sss_ref.gl.uploads import downloaded, filled, uploaded
from sss_ref.interpret import arrays

WITH_POWERS = {  # whose pow and exp are the GPU's own; all else is exact
    "phong_shading",
    "gloss_where_lit",
    "translucency_ratio",
    "translucency_exponent",
    "translucency_beer",
    "translucency_gaussians",
    "translucency_ratio_throughout",
    "translucency_exponent_throughout",
    "translucency_beer_throughout",
    "translucency_gaussians_throughout",
    "light_inside",
    "seen_through",
    "gloss_soft",
    "scatter_burley",
    "irradiance_of_gaussians",
    "phong_preintegrated",
    "phong_ungated",
    "translucency_unclamped",
}
POWER_ERROR = 4e-6  # relative, measured with a shininess of 32
SMALLEST = 2.0**-126  # what is smaller may be 0 after a power

pytestmark = needs_mesa


class OpenGL:
    """An interpreter of fragments, in the form that `run` takes."""

    def __init__(self):
        self.context = open_context()

    def run_fragments(self, work, pool):
        canvas, kinds = Canvas(self.context, work.uniforms), work.this_pass.outputs
        read = {name: uploaded(self.context, buffer) for name, buffer in work.buffers.items()}
        size = (work.fragments.width, work.fragments.height)
        for pair in own_shaders(work.this_pass, work.buffers, work.outputs, canvas.lengths):
            program = pair.compiled(self.context)
            canvas.hand_over(program, read, pair.name)
            textures = {name: filled(self.context, kinds[name], size, 77) for name in pair.outputs}
            canvas.rectangle(program, textures.values())
            for name, texture in textures.items():
                work.outputs[name][...] = downloaded(texture, kinds[name])


@pytest.fixture(scope="module")
def opengl():
    interpreter = OpenGL()
    yield interpreter
    interpreter.context.release()


@pytest.mark.parametrize(("stage", "overrides", "size", "seed"), CASES)
def test_a_stage_gives_the_bits_of_array_code(opengl, stage, overrides, size, seed):
    inputs = inputs_of(overrides, size, seed)
    expected, got = run(arrays, stage, inputs), run(opengl, stage, inputs)
    if stage.name not in WITH_POWERS:
        assert_same_bits(got, expected)
    for name, buffer in expected.items():
        np.testing.assert_allclose(got[name], buffer, rtol=POWER_ERROR, atol=SMALLEST)
