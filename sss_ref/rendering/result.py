"""What a rendering gives: named buffers, their hashes, and how long each pass took."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from os import PathLike
from pathlib import Path

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.scene.scene import Scene


@dataclass(frozen=True, eq=False)
class Result:
    """The kept buffers of a rendering, in stage order.

    buffers: name -> (H, W) or (H, W, C), row 0 at the bottom. timings: pass -> seconds.
    notes: what may surprise: of the mesh's UV layout, and where nothing is drawn or the image hides it.
    digests: those of `hashes` that are known already.
    """

    scene: Scene
    buffers: Mapping[str, np.ndarray]
    timings: Mapping[str, float]
    notes: tuple[str, ...] = field(default=(), kw_only=True)
    digests: Mapping[str, str] = field(default_factory=dict, kw_only=True)

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.buffers:
            raise SceneError(
                f"buffer: expected one of {', '.join(self.buffers)}, got {name!r}; render with keep to have it"
            )
        return self.buffers[name]

    @property
    def image(self) -> np.ndarray:
        """The final picture, linear RGB float32 (H, W, 3), row 0 at the bottom."""
        return self["image"]

    @cached_property
    def hashes(self) -> dict[str, str]:
        """Buffer -> SHA-256 in hexadecimal (rule A5)."""
        known = self.digests
        return {name: known.get(name) or buffer_hash(name, buffer) for name, buffer in self.buffers.items()}

    def save(self, folder: str | PathLike[str]) -> Path:
        """Write pictures, buffers and manifest into a folder, which appears whole or not at all; returns it."""
        # The one way up: the room of result folders builds on this one.
        saving = import_module("sss_ref.results.folder")
        saved: Path = saving.save(self, Path(folder))
        return saved


def buffer_hash(name: str, buffer: np.ndarray) -> str:
    """SHA-256 of a buffer: over its name, type, height, width, channels and little-endian data, row 0 at the bottom."""
    little = np.ascontiguousarray(buffer, buffer.dtype.newbyteorder("<"))
    height, width = buffer.shape[:2]
    channels = 1 if buffer.ndim == 2 else buffer.shape[2]
    head = f"sss_ref buffer 1\n{name}\n{little.dtype.str}\n{height},{width},{channels}\n"
    digest = hashlib.sha256(head.encode())
    digest.update(little.reshape(-1).data)  # no copy is made
    return digest.hexdigest()
