"""Drawing a scene: the passes of its method, folded over a dictionary of textures."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.gl.canvas import Canvas
from sss_ref.gl.context import open_context
from sss_ref.gl.shaders import Files, ShaderPair, own_shaders, user_shaders
from sss_ref.gl.uploads import downloaded, filled
from sss_ref.language.pipeline import MeshDraw, Method, Pass
from sss_ref.passes.buffers import background
from sss_ref.scene.catalogue import method_of_scene
from sss_ref.scene.load import Scene
from sss_ref.scene.uniforms import uniforms
from sss_ref.scene.until import buffers_kept

if TYPE_CHECKING:
    from moderngl import Program, Texture


def draw(
    scene: Scene, shaders: Mapping[str, Files] | None = None, keep: str | Iterable[str] = "all"
) -> dict[str, np.ndarray]:
    """Draw a scene on this machine's OpenGL: buffers of its method by name.

    The buffers are (H, W) or (H, W, C), row 0 at the bottom, as those of a rendering. A UV layout that overlaps is
    drawn even where the scene's policy is "error": OpenGL does not tell.
    shaders: pass -> the user's file or files (see `user_shaders`), drawn in the place of ours. What the rasterizer
        writes (triangle, depth, coverage) ours draw if theirs do not; whatever else theirs leave out is missing.
    keep: which buffers come back, as in `sss_ref.render`; passes on demand are drawn for them alone.
    Raises ShaderError where there is no OpenGL, a shader does not compile, or a pass reads what a shader left out, and
    SceneError for an unknown buffer.
    """
    method = method_of_scene(scene)
    kept = buffers_kept(method, keep)
    passes = {one.name: one for one in method.passes if not one.on_demand or kept & set(one.outputs)}
    for wrong in set(shaders or ()) - set(passes):
        raise ShaderError(f"shaders: expected passes of {method.name} ({', '.join(passes)}), got {wrong!r}")
    context = open_context()
    try:
        drawing = _Drawing(scene, method, shaders or {}, Canvas(context, uniforms(scene)), kept)
        for one in passes.values():
            drawing.run(one)
        return drawing.buffers
    finally:
        context.release()


@dataclass
class _Drawing:
    """One run through a method: the textures that are there so far."""

    scene: Scene
    method: Method
    shaders: Mapping[str, Files]
    canvas: Canvas
    kept: set[str]

    def __post_init__(self) -> None:
        self.textures: dict[str, Texture] = {}

    @property
    def buffers(self) -> dict[str, np.ndarray]:
        """What is to be kept and was drawn, in stage order."""
        there = [name for name in self.method.values if name in self.kept and name in self.textures]
        return {name: downloaded(self.textures[name], self.method.values[name]) for name in there}

    def run(self, one: Pass) -> None:
        """Draw a pass as often as it has rounds, and keep what it writes."""
        for name in sorted(one.needs & set(self.method.outputs) - set(self.textures)):
            raise ShaderError(
                f"pass {one.name}: expected the buffer {name}, which no shader wrote; write it as an output"
            )
        programs = [(pair, pair.compiled(self.canvas.context)) for pair in self.pairs(one)]
        outputs = {own: self.textures[name] for name, own in one.feedback.items()}
        for _ in range(one.rounds):
            read = self.textures | {name: outputs[own] for name, own in one.feedback.items()}
            outputs = {}
            for pair, program in programs:
                self.canvas.hand_over(program, read, pair.name)
                outputs |= self.draw(one, pair, program)
        self.textures |= outputs

    def pairs(self, one: Pass) -> list[ShaderPair]:
        """The shaders of a pass."""
        lengths = self.canvas.lengths
        if one.name not in self.shaders:
            return own_shaders(one, self.textures, self.kept | set(one.outputs), lengths)
        theirs = user_shaders(one, self.shaders[one.name], lengths)
        written = {name for pair in theirs for name in pair.outputs}
        return theirs + own_shaders(one, self.textures, set(one.draw.outputs) - written, lengths)

    def draw(self, one: Pass, pair: ShaderPair, program: "Program") -> "dict[str, Texture]":
        """One draw into fresh textures."""
        table = getattr(self.scene.settings, one.target)
        size, kinds = (table.width, table.height), one.values
        clear = {name: background(name, self.canvas.uniforms) for name in pair.outputs}
        written = {name: filled(self.canvas.context, kinds[name], size, value) for name, value in clear.items()}
        if isinstance(one.draw, MeshDraw):
            vertices = self.canvas.vertices(program, self.scene.mesh.attributes, self.scene.mesh.triangles)
            later_wins = one.draw.layout and self.scene.settings.irradiance_map.overlap == "last"
            self.canvas.triangles(vertices, written.values(), later_wins)
        else:
            self.canvas.rectangle(program, written.values())
        return written
