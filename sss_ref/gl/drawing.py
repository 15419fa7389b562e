"""Drawing a scene: the passes of its method, folded over a dictionary of textures."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.gl.canvas import Canvas
from sss_ref.gl.context import open_context
from sss_ref.gl.shaders import Files, ShaderPair, own_shaders, user_shaders, user_vertex_file
from sss_ref.gl.uploads import downloaded, filled
from sss_ref.language.pipeline import Pass
from sss_ref.scene.scene import Scene

if TYPE_CHECKING:
    from moderngl import Program, Texture


def draw(
    scene: Scene, shaders: Mapping[str, Files] | None = None, keep: str | Iterable[str] = "all"
) -> dict[str, np.ndarray]:
    """Draw a scene on this machine's OpenGL: buffers of its method by name.

    The buffers are (H, W) or (H, W, C), row 0 at the bottom, as those of a rendering. A UV layout that overlaps is
    drawn even where the scene's policy is "error": OpenGL does not tell.
    shaders: pass -> the user's file or files (see `user_shaders`), drawn in the place of ours. What the rasterizer
        writes (triangle, depth, coverage) ours draw if theirs do not; whatever else theirs leave out is missing. A
        vertex shader alone is drawn with our fragment shaders.
    keep: which buffers come back, as in `sss_ref.render`; passes on demand are drawn for them alone.
    Raises ShaderError where there is no OpenGL, a shader does not compile, or a pass reads what a shader left out, and
    SceneError for an unknown buffer.
    """
    kept = scene.kept(keep)
    passes = {each.name: each for each in scene.method.passes if not each.on_demand or kept & set(each.outputs)}
    for wrong in set(shaders or ()) - set(passes):
        raise ShaderError(f"shaders: expected passes of {scene.method.name} ({', '.join(passes)}), got {wrong!r}")
    context = open_context()
    try:
        drawing = _Drawing(scene, shaders or {}, Canvas(context, scene.uniforms), kept)
        for each in passes.values():
            drawing.run(each)
        return drawing.buffers
    finally:
        context.release()


@dataclass
class _Drawing:
    """One run through a method: the textures that are there so far."""

    scene: Scene
    shaders: Mapping[str, Files]
    canvas: Canvas
    kept: set[str]

    def __post_init__(self) -> None:
        self.textures: dict[str, Texture] = {}

    @property
    def buffers(self) -> dict[str, np.ndarray]:
        """What is to be kept and was drawn, in stage order."""
        values = self.scene.method.values
        there = [name for name in values if name in self.kept and name in self.textures]
        return {name: downloaded(self.textures[name], values[name]) for name in there}

    def run(self, this_pass: Pass) -> None:
        """Draw a pass as often as it has rounds, and keep what it writes."""
        for name in sorted(this_pass.needs & set(self.scene.method.outputs) - set(self.textures)):
            raise ShaderError(
                f"pass {this_pass.name}: expected the buffer {name}, which no shader wrote; write it as an output"
            )
        programs = [(pair, pair.compiled(self.canvas.context)) for pair in self.pairs(this_pass)]

        def draw_all(read: "Mapping[str, Texture]") -> "dict[str, Texture]":
            outputs: dict[str, Texture] = {}
            for pair, program in programs:
                self.canvas.hand_over(program, read, pair.name)
                outputs |= self.draw(this_pass, pair, program)
            return outputs

        self.textures |= this_pass.folded(self.textures, draw_all)

    def pairs(self, this_pass: Pass) -> list[ShaderPair]:
        """The shaders of a pass."""
        lengths = self.canvas.lengths
        if this_pass.name not in self.shaders:
            return own_shaders(this_pass, self.textures, self.kept | set(this_pass.outputs), lengths)
        files = self.shaders[this_pass.name]
        vertex, theirs = user_vertex_file(files), user_shaders(this_pass, files, lengths)
        written = {name for pair in theirs for name in pair.outputs}
        left = set(this_pass.draw.outputs) - written if theirs else self.kept | set(this_pass.outputs)
        return theirs + own_shaders(this_pass, self.textures, left, lengths, vertex)

    def draw(self, this_pass: Pass, pair: ShaderPair, program: "Program") -> "dict[str, Texture]":
        """One draw into fresh textures."""
        context, size, kinds = self.canvas.context, self.scene.size(this_pass), this_pass.values
        written = {name: filled(context, kinds[name], size, self.scene.clear(name)) for name in pair.outputs}
        if this_pass.draw.vertex_stages:
            mesh = self.scene.mesh_of(this_pass)
            vertices = self.canvas.vertices(program, mesh.attributes, mesh.triangles)
            later_wins = this_pass.draw.layout and self.scene.settings.irradiance_map.overlap == "last"
            self.canvas.triangles(vertices, written.values(), later_wins)
        else:
            self.canvas.rectangle(program, written.values())
        return written
