"""The passes of a scene's method, folded over a dictionary of textures, whatever the API that draws them."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from sss_ref.errors import ShaderError
from sss_ref.gl.shaders import Files, ShaderPair, own_shaders, user_shaders, user_vertex_file
from sss_ref.interpret.shader import Dialect, array_lengths
from sss_ref.language.pipeline import Pass
from sss_ref.scene.scene import Scene

T = TypeVar("T")


class Painter(Protocol[T]):
    """What draws: an API with textures of its own, T, and the language of its shaders."""

    dialect: Dialect

    def prepared(self, this_pass: Pass, pair: ShaderPair) -> Callable[[Mapping[str, T]], dict[str, T]]:
        """A draw, compiled: from the textures that are there by buffer to those that it fills."""

    def uploaded(self, buffer: np.ndarray) -> T:
        """A texture that holds a buffer."""

    def downloaded(self, texture: T, kind: Any) -> np.ndarray:
        """The buffer of a type that a texture holds: (H, W), or (H, W, C) for vectors."""


def drawn(
    scene: Scene,
    shaders: Mapping[str, Files],
    keep: str | Iterable[str],
    painting: Callable[[Scene], AbstractContextManager[Painter[T]]],
) -> dict[str, np.ndarray]:
    """The buffers of a scene that are to be kept, as the painter that `painting` opens draws them.

    shaders, keep: as `sss_ref.gl.draw` takes them. Raises what that does.
    """
    kept = scene.kept(keep)
    passes = {each.name: each for each in scene.method.passes if not each.on_demand or kept & set(each.outputs)}
    for wrong in set(shaders) - set(passes):
        raise ShaderError(f"shaders: expected passes of {scene.method.name} ({', '.join(passes)}), got {wrong!r}")
    with painting(scene) as painter:
        drawing = _Drawing(scene, shaders, painter, kept)
        for each in passes.values():
            drawing.run(each)
        return drawing.buffers


def pass_drawn(
    scene: Scene,
    this_pass: Pass,
    buffers: Mapping[str, np.ndarray],
    shaders: Mapping[str, Files],
    painting: Callable[[Scene], AbstractContextManager[Painter[T]]],
) -> dict[str, np.ndarray]:
    """What a single pass writes that reads these buffers, registers too where shaders do.

    shaders, painting: as `drawn` takes them.
    """
    with painting(scene) as painter:
        given = {name: painter.uploaded(buffer) for name, buffer in buffers.items()}
        drawing = _Drawing(scene, shaders, painter, {*this_pass.outputs}, given)
        drawing.run(this_pass)
        written = {name: drawing.textures[name] for name in this_pass.values if name in drawing.textures}
        return {name: painter.downloaded(texture, this_pass.values[name]) for name, texture in written.items()}


@dataclass
class _Drawing(Generic[T]):
    """One run through a method: the textures that are there so far."""

    scene: Scene
    shaders: Mapping[str, Files]
    painter: Painter[T]
    kept: set[str]
    textures: dict[str, T] = field(default_factory=dict)

    @property
    def buffers(self) -> dict[str, np.ndarray]:
        """What is to be kept and was drawn, in stage order."""
        values = self.scene.method.values
        there = [name for name in values if name in self.kept and name in self.textures]
        return {name: self.painter.downloaded(self.textures[name], values[name]) for name in there}

    def run(self, this_pass: Pass) -> None:
        """Draw a pass as often as it has rounds, and keep what it writes."""
        for name in sorted(this_pass.needs & set(self.scene.method.outputs) - set(self.textures)):
            raise ShaderError(
                f"pass {this_pass.name}: expected the buffer {name}, which no shader wrote; write it as an output"
            )
        prepared = [self.painter.prepared(this_pass, pair) for pair in self.pairs(this_pass)]

        def draw_all(read: Mapping[str, T]) -> dict[str, T]:
            outputs: dict[str, T] = {}
            for each in prepared:
                outputs |= each(read)
            return outputs

        self.textures |= this_pass.folded(self.textures, draw_all)

    def pairs(self, this_pass: Pass) -> list[ShaderPair]:
        """The shaders of a pass."""
        dialect = self.painter.dialect
        lengths = array_lengths(self.scene.uniforms, dialect)
        wanted = self.kept | set(this_pass.outputs)
        if this_pass.name not in self.shaders:
            return own_shaders(this_pass, self.textures, wanted, lengths, None, dialect)
        files = self.shaders[this_pass.name]
        vertex, theirs = user_vertex_file(files), user_shaders(this_pass, files, lengths, dialect)
        written = {name for pair in theirs for name in pair.outputs}
        left = set(this_pass.draw.outputs) - written if theirs else wanted
        return theirs + own_shaders(this_pass, self.textures, left, lengths, vertex, dialect)
