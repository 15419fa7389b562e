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
from sss_ref.language import tree

POWERS = {"pow", "exp", "exp2", "log2"}  # which are the GPU's own; all else is exact
POWER_ERROR = 4e-6  # relative, measured with a shininess of 32
SMALLEST = 2.0**-126  # what is smaller may be 0 after a power

pytestmark = needs_mesa


def has_powers(body):
    """Whether a body calls one of POWERS, or a function that does."""
    return any(map(has_power, tree.expressions(body)))


def has_power(expression):
    if isinstance(expression, tree.Call) and expression.callee.name in POWERS:
        return True
    if isinstance(expression, tree.Call) and expression.body is not None and has_powers(expression.body):
        return True
    return any(map(has_power, tree.children(expression)))


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
    if not has_powers(stage.body):
        assert_same_bits(got, expected)
    for name, buffer in expected.items():
        np.testing.assert_allclose(got[name], buffer, rtol=POWER_ERROR, atol=SMALLEST)
