"""Scenes drawn with a user's shaders, as often as it takes."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sss_ref.gl.drawing import draw, draw_pass
from sss_ref.gl.shaders import Files
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Buffers
from sss_ref.scene.scene import Scene


@dataclass(frozen=True)
class ShaderArtist:
    """The OpenGL of this machine.

    shaders: pass -> the user's files, as in `draw`; of other passes ours.
    """

    shaders: Mapping[str, Files]

    @property
    def any_lights(self) -> bool:
        """Only our own shaders are made for the lights that a scene has."""
        return not self.shaders

    def whole(self, scene: Scene, keep: str | Iterable[str] = "all") -> Buffers:
        """A scene."""
        return draw(scene, self.shaders, keep)

    def again(self, scene: Scene) -> Buffers:
        """A scene, drawn anew."""
        return draw(scene, self.shaders)

    def one(self, scene: Scene, this_pass: Pass, buffers: Buffers) -> Buffers:
        """What a pass writes."""
        return draw_pass(scene, this_pass, buffers, self.shaders)
