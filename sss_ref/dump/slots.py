"""What buffers a scene has, and the form of each: what a dump is held against."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.interpret.work import CHANNELS, dtype_of
from sss_ref.passes.buffers import described
from sss_ref.scene.catalogue import method_of_scene
from sss_ref.scene.load import Scene


@dataclass(frozen=True)
class Slot:
    """The form of a buffer: channels, float32, int32 or uint8 (0 or 1), and its size with the table that gives it."""

    name: str
    channels: int
    dtype: np.dtype
    width: int
    height: int
    target: str

    @property
    def shape(self) -> tuple[int, ...]:
        """(H, W), or (H, W, C) for vectors."""
        return (self.height, self.width, self.channels)[: 2 if self.channels == 1 else 3]

    @property
    def is_spatial(self) -> bool:
        """Whether it holds points or directions of world space."""
        return described(self.name).unit.endswith("world space")

    @property
    def is_direction(self) -> bool:
        """Whether it holds unit vectors."""
        return described(self.name).unit.startswith("unit vector")


def slots_of(scene: Scene) -> Mapping[str, Slot]:
    """Buffer -> its form, for all that the scene's method can write, registers too, in stage order."""
    slots = {}
    for one in method_of_scene(scene).passes:
        size = getattr(scene.settings, one.target)
        for name, kind in one.values.items():
            slots[name] = Slot(name, CHANNELS[kind], dtype_of(kind), size.width, size.height, one.target)
    return slots
