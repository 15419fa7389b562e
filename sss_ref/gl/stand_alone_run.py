"""The shader of a witness, run on this machine's OpenGL."""

from dataclasses import dataclass

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.gl.context import open_context

EVERYWHERE = """#version 400 core
void main()
{
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
"""


@dataclass(frozen=True)
class ShaderVerdict:
    """right: whether the shader said so. bits: uint32 (4,), what it computed. device: what ran it."""

    right: bool
    bits: np.ndarray
    device: str


def run_alone(fragment: str) -> ShaderVerdict:
    """Run the shader that `stand_alone` gives for one pixel. Raises ShaderError where it does not compile."""
    import moderngl

    context = open_context()
    try:
        program = context.program(vertex_shader=EVERYWHERE, fragment_shader=fragment)
        verdict, bits = context.texture((1, 1), 4, dtype="f4"), context.texture((1, 1), 4, dtype="u4")
        context.framebuffer([verdict, bits]).use()
        context.vertex_array(program, []).render(context.TRIANGLES, vertices=3)
        green = np.frombuffer(verdict.read(), "f4")[1] == 1
        return ShaderVerdict(bool(green), np.frombuffer(bits.read(), "u4"), context.info["GL_RENDERER"])
    except moderngl.Error as error:
        raise ShaderError(f"witness: expected a shader that compiles and links, got {error}") from None
    finally:
        context.release()
