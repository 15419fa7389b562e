"""One draw: a program, what it reads by name, and the textures it fills."""

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.gl.uploads import texture_data, uploaded
from sss_ref.interpret.shader import GLSL, array_lengths

if TYPE_CHECKING:
    from moderngl import Context, Program, Texture, VertexArray


class Canvas:
    """Draws with one set of uniforms, named as the stages read them (see sss_ref.scene.uniforms)."""

    def __init__(self, context: "Context", uniforms: Mapping[str, Any]) -> None:
        self.context, self.uniforms, self.lengths = context, uniforms, array_lengths(uniforms)

    def rectangle(self, program: "Program", targets: "Iterable[Texture]") -> None:
        """Draw every pixel of the targets."""
        self.context.enable_only(self.context.NOTHING)
        self.context.framebuffer([*targets]).use()
        self.context.vertex_array(program, []).render(self.context.TRIANGLE_STRIP, vertices=4)

    def triangles(self, vertices: "VertexArray", targets: "Iterable[Texture]", later_wins: bool) -> None:
        """Draw triangles in order, nearest first; of two at one depth the earlier counts, or the later if told so."""
        colors = [*targets]
        depth = self.context.depth_texture(colors[0].size)
        self.context.framebuffer([], depth).clear(depth=1.0)
        self.context.framebuffer(colors, depth).use()
        self.context.enable_only(self.context.DEPTH_TEST)
        self.context.depth_func = "<=" if later_wins else "<"
        vertices.render(self.context.TRIANGLES)

    def vertices(self, program: "Program", mesh: Mapping[str, np.ndarray], triangles: np.ndarray) -> "VertexArray":
        """The attributes that a vertex shader reads, of float32 (V, C), for triangles int32 (T, 3)."""
        buffer = self.context.buffer
        content = [
            (buffer(np.ascontiguousarray(array).tobytes()), f"{array.shape[1]}f", name)
            for name, array in mesh.items()
            if name in program
        ]
        return self.context.vertex_array(program, content, buffer(np.ascontiguousarray(triangles).tobytes()), 4)

    def hand_over(self, program: "Program", buffers: "Mapping[str, Texture]", where: str) -> None:
        """Give a program what it reads: buffers, else uniforms; raises ShaderError, naming `where`, for other names."""
        import moderngl

        textures = {GLSL.name(name): texture for name, texture in {**self.textures, **buffers}.items()}
        members = [program[name] for name in program]
        uniforms = [member for member in members if isinstance(member, moderngl.Uniform)]
        for unit, sampler in enumerate(member for member in uniforms if member.name in textures):
            textures[sampler.name].use(unit)
            sampler.value = unit
        for member in uniforms:
            if member.name not in textures:
                self._write(member, where)

    def _write(self, member: Any, where: str) -> None:
        """Write one uniform; OpenGL stores matrices column by column."""
        known = {GLSL.name(name): value for name, value in self.uniforms.items()}
        if member.name not in known:
            names = ", ".join(sorted(known))
            raise ShaderError(f"{where}: expected names of earlier buffers or uniforms ({names}), got {member.name}")
        value = np.asarray(known[member.name])
        rounded = value.astype(np.int32 if value.dtype.kind == "i" else np.float32)
        member.write(np.ascontiguousarray(rounded.T if member.matrix else rounded).tobytes())

    @cached_property
    def textures(self) -> "dict[str, Texture]":
        """The uniforms that are textures."""
        return {name: uploaded(self.context, data) for name, data in texture_data(self.uniforms).items()}
