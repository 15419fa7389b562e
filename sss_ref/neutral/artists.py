"""Who draws a scene: the reference itself, or anything that draws as it does."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Buffers, draw
from sss_ref.rendering.fold import machine_of, render, shaded
from sss_ref.scene.scene import Scene


class Artist(Protocol):
    """Draws scenes and passes: buffers by name, as in `Result`."""

    @property
    def any_lights(self) -> bool:
        """Whether it draws a scene with more lights as well."""

    def whole(self, scene: Scene, keep: str | Iterable[str] = "all") -> Buffers:
        """A scene; keep: as in `render`."""

    def again(self, scene: Scene) -> Buffers:
        """A scene in another way, if it has one."""

    def one(self, scene: Scene, this_pass: Pass, buffers: Buffers) -> Buffers:
        """What a pass writes that reads these buffers."""


@dataclass(frozen=True)
class ReferenceArtist:
    """Compiled kernels, and in another way plain NumPy on one thread."""

    any_lights = True

    def whole(self, scene: Scene, keep: str | Iterable[str] = "all") -> Buffers:
        """A scene."""
        return render(scene, keep=keep).buffers

    def again(self, scene: Scene) -> Buffers:
        """A scene in NumPy."""
        return render(scene, "arrays", threads=1).buffers

    def one(self, scene: Scene, this_pass: Pass, buffers: Buffers) -> Buffers:
        """What a pass writes."""
        with machine_of("kernel") as machine:
            sketch = draw(scene, this_pass, buffers, machine)
            return sketch.written | shaded(scene, this_pass, sketch, buffers, {*this_pass.outputs}, machine)
