"""What a picture file holds, before anybody says what it means."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.scene.memory import MEMORY_LIMIT
from sss_ref.scene_file.quantities import LARGEST_SIZE

STORAGE_OF_TYPE = {
    "f4": "float32",
    "f2": "float16",
    "u1": "uint8",
    "b1": "uint8",
    "u2": "unorm16",
    "i4": "int32",
    "u4": "uint32",
}
"""NumPy's type -> what an array of it is taken for where its file says no more."""


@dataclass(frozen=True, eq=False)
class StoredTexels:
    """The elements of a surface.

    data: (H, W, C), rows in the order of the file; float32, float16, uint8, uint16, int32 or uint32.
    channels: a name for each. storage: how a texel was stored: "float32", "unorm8" ... (see `encoding`).
    part: the name of the surface among several of a file.
    """

    data: np.ndarray
    channels: tuple[str, ...]
    storage: str
    part: str = "0"


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
        expected = "float32, float16, int32, uint32, uint16, uint8 or bool"
        raise DumpError(told(str(path), expected, str(array.dtype), "convert it and say so in the mapping file"))
    height, width, channels = (*array.shape, 1, 1, 1)[:3]
    if array.ndim not in (2, 3) or not 1 <= channels <= 4:
        expected = "an array of height x width, perhaps x 1 to 4 channels"
        raise DumpError(told(str(path), expected, " x ".join(map(str, array.shape)) or "a number", "reshape it"))
    check_size(path, width, height, array.dtype.itemsize * channels)
    data = np.array(array, array.dtype.newbyteorder("=")).reshape(height, width, channels)
    return StoredTexels(data.view(np.uint8) if data.dtype == bool else data, tuple("RGBA"[:channels]), storage)
