"""The form of every buffer of a scene, known before anything is drawn."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.language.pipeline import Method
from sss_ref.passes.buffers import described
from sss_ref.scene_file.settings import SceneFile


@dataclass(frozen=True)
class Form:
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


def size_of(target: str, settings: SceneFile) -> tuple[int, int]:
    """Width and height of what a pass draws into, from the scene table of that name."""
    table = getattr(settings, target)
    return table.width, table.height


def forms_of(method: Method, settings: SceneFile) -> Mapping[str, Form]:
    """Buffer -> its form, for all that a method can write, registers too, in stage order."""
    return {
        name: Form(name, CHANNELS[kind], dtype_of(kind), *size_of(each.target, settings), each.target)
        for each in method.passes
        for name, kind in each.values.items()
    }
