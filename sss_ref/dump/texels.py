"""What a picture file holds, before anybody says what it means."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from sss_ref.dump.loss import Loss
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.scene_file.quantities import LARGEST_SIZE, MEMORY_LIMIT

STORAGE_OF_TYPE = {
    "f4": "float32",
    "f2": "float16",
    "u1": "uint8",
    "b1": "uint8",
    "i1": "int8",
    "u2": "unorm16",
    "i2": "int16",
    "i4": "int32",
    "u4": "uint32",
}
"""NumPy's type -> what an array of it is taken for where its file says no more."""


@dataclass(frozen=True)
class Frame:
    """The picture that a surface is a part of: its size, and where the surface's upper left texel lies in it."""

    width: int
    height: int
    x: int
    y: int

    def __str__(self) -> str:
        return f"pixels from {self.x},{self.y} in a picture of {self.width} x {self.height}"


@dataclass(frozen=True, eq=False)
class StoredTexels:
    """The elements of a surface.

    data: (H, W, C), rows in the order of the file; float32, float16, uint8, uint16, uint32, int8, int16 or int32.
    channels: a name for each. storage: how a texel was stored: "float32", "unorm8" ... (see `encoding`).
    part: the name of the surface among several of a file.
    are_named: whether the channels' names stand in the file; else they are places, and R, G, B, A stand for X, Y, Z, W.
    frame: the picture that they are placed in, if that is another; rows then begin at the top. notes: what was done to
    read them.
    loss: of the format, where it is not that of the storage. spoiled: channel -> what changed it beyond telling.
    """

    data: np.ndarray
    channels: tuple[str, ...]
    storage: str
    part: str = "0"
    are_named: bool = False
    frame: Frame | None = None
    notes: tuple[str, ...] = ()
    loss: Loss | None = None
    spoiled: Mapping[str, str] = field(default_factory=dict)

    def placed(self) -> "tuple[StoredTexels, np.ndarray | None]":
        """In their frame, 0 where it has no texels, and where that is, bool (H, W); None without a frame."""
        if self.frame is None:
            return self, None
        frame, (height, width) = self.frame, self.data.shape[:2]
        rows = slice(max(frame.y, 0), min(frame.y + height, frame.height))
        columns = slice(max(frame.x, 0), min(frame.x + width, frame.width))
        data = np.zeros((frame.height, frame.width, self.data.shape[2]), self.data.dtype)
        outside = np.ones(data.shape[:2], bool)
        data[rows, columns] = self.data[
            rows.start - frame.y : rows.stop - frame.y, columns.start - frame.x : columns.stop - frame.x
        ]
        outside[rows, columns] = False
        note = f"{width} x {height} {frame}; the rest of it is background"
        return replace(self, data=data, frame=None, notes=(*self.notes, note)), outside

    def layer(self, name: str) -> "StoredTexels | None":
        """The channels called NAME.X and the like, by what follows the dot; None where there are none."""
        own = [channel for channel in self.channels if channel.startswith(f"{name}.")]
        if not own:
            return None
        short = {channel: channel.removeprefix(f"{name}.") for channel in own}
        data = self.data[..., [self.channels.index(channel) for channel in own]]
        spoiled = {short[channel]: by for channel, by in self.spoiled.items() if channel in short}
        return replace(self, data=data, channels=tuple(short.values()), part=name, spoiled=spoiled)


def check_size(path: Path, width: int, height: int, texel_bytes: int, available: int | None = None) -> None:
    """Hold a declared size against the limits, and against the bytes that follow, before any memory is taken for it.

    available: bytes of uncompressed texels in the file; None for a compressed file. Raises DumpError.
    """
    if not (1 <= width <= LARGEST_SIZE and 1 <= height <= LARGEST_SIZE):
        expected = f"a width and a height from 1 to {LARGEST_SIZE}"
        raise DumpError(told(str(path), expected, f"{width} x {height}", "dump the buffer in the size of the scene"))
    needed = width * height * texel_bytes
    if needed > MEMORY_LIMIT:
        raise DumpError(told(str(path), f"at most {MEMORY_LIMIT} bytes of texels", str(needed), "dump fewer of them"))
    if available is not None and available < needed:
        expected = f"{needed} bytes for {width} x {height} texels"
        raise DumpError(told(str(path), expected, f"{available}", "the file is cut off; dump the buffer again"))


def array_texels(path: Path, array: np.ndarray) -> StoredTexels:
    """The texels of a plain array (H, W) or (H, W, C), whose channels are called R, G, B, A. Raises DumpError."""
    storage = STORAGE_OF_TYPE.get(f"{array.dtype.kind}{array.dtype.itemsize}")
    if storage is None:
        expected = "float32, float16, integers of 8, 16 or 32 bits, or bool"
        raise DumpError(told(str(path), expected, str(array.dtype), "convert it and say so in the mapping file"))
    height, width, channels = (*array.shape, 1, 1, 1)[:3]
    if array.ndim not in (2, 3) or not 1 <= channels <= 4:
        expected = "an array of height x width, perhaps x 1 to 4 channels"
        raise DumpError(told(str(path), expected, " x ".join(map(str, array.shape)) or "a number", "reshape it"))
    check_size(path, width, height, array.dtype.itemsize * channels)
    data = np.array(array, array.dtype.newbyteorder("=")).reshape(height, width, channels)
    return StoredTexels(data.view(np.uint8) if data.dtype == bool else data, tuple("RGBA"[:channels]), storage)
