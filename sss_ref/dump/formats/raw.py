"""Bare texels: rows without gaps, little-endian, of a shape and a type that the mapping file gives."""

from dataclasses import dataclass
from math import prod
from pathlib import Path

import numpy as np

from sss_ref.dump.texels import StoredTexels, array_texels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told


@dataclass(frozen=True)
class RawLayout:
    """What a raw file does not say of itself: its shape (H, W) or (H, W, C), and the type of its elements."""

    shape: tuple[int, ...]
    dtype: str


def read(path: Path, layout: RawLayout) -> tuple[StoredTexels]:
    """The texels of a raw file, which must have exactly the bytes of its layout. Raises DumpError."""
    element = np.dtype(layout.dtype).newbyteorder("<")
    height, width, *channels = layout.shape
    found, texel_bytes = path.stat().st_size, element.itemsize * prod(channels)
    check_size(path, width, height, texel_bytes, found)
    if found > height * width * texel_bytes:
        expected = f"{height * width * texel_bytes} bytes for {' x '.join(map(str, layout.shape))} {layout.dtype}"
        raise DumpError(told(str(path), expected, str(found), "correct shape or dtype in the mapping file"))
    return (array_texels(path, np.fromfile(path, element).reshape(layout.shape)),)
