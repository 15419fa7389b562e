"""Drawing a scene by OpenGL: a draw of a pass, into fresh textures."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.gl.canvas import Canvas
from sss_ref.gl.context import open_context
from sss_ref.gl.folding import Painter, drawn, pass_drawn
from sss_ref.gl.shaders import Files, ShaderPair
from sss_ref.gl.uploads import downloaded, filled, uploaded
from sss_ref.interpret.shader import GLSL
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
    return drawn(scene, shaders or {}, keep, _painting)


def draw_pass(
    scene: Scene, this_pass: Pass, buffers: Mapping[str, np.ndarray], shaders: Mapping[str, Files] | None = None
) -> dict[str, np.ndarray]:
    """Draw a single pass of a scene that reads these buffers; what it writes.

    shaders: as in `draw`. Raises ShaderError as that does.
    """
    return pass_drawn(scene, this_pass, buffers, shaders or {}, _painting)


@contextmanager
def _painting(scene: Scene) -> "Iterator[Painter[Texture]]":
    context = open_context()
    try:
        yield _GlPainter(scene, Canvas(context, scene.uniforms))
    finally:
        context.release()


@dataclass
class _GlPainter:
    """Draws the passes of a scene by OpenGL."""

    scene: Scene
    canvas: Canvas
    dialect = GLSL

    def prepared(self, this_pass: Pass, pair: ShaderPair) -> "Callable[[Mapping[str, Texture]], dict[str, Texture]]":
        """A draw, compiled."""
        program = pair.compiled(self.canvas.context)

        def run(read: "Mapping[str, Texture]") -> "dict[str, Texture]":
            self.canvas.hand_over(program, read, pair.name)
            return self.draw(this_pass, pair, program)

        return run

    def uploaded(self, buffer: np.ndarray) -> "Texture":
        """A texture that holds a buffer."""
        return uploaded(self.canvas.context, buffer)

    def downloaded(self, texture: "Texture", kind: Any) -> np.ndarray:
        """The buffer of a type that a texture holds."""
        return downloaded(texture, kind)

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
