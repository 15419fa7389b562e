"""Which pixels of the camera's buffers are looked at: a rectangle, and a mask of those to leave out."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.dump.files import BOTTOM_FIRST, parts_of
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

MASK_SUFFIXES = (".png", ".npy")


@dataclass(frozen=True)
class Region:
    """A rectangle of pixels: its lower left one, (column, row) with row 0 at the bottom, and its size."""

    x: int
    y: int
    width: int
    height: int

    @property
    def slices(self) -> tuple[slice, slice]:
        """Rows and columns, to index a buffer with."""
        return slice(self.y, self.y + self.height), slice(self.x, self.x + self.width)


def parsed_region(text: str, width: int, height: int) -> Region:
    """The region "X,Y,W,H" of a picture of that size. Raises DumpError where it is none or reaches out of it."""
    numbers = [int(part) if part.strip().isdecimal() and len(part) < 9 else -1 for part in text.split(",")]
    if len(numbers) == 4 and min(numbers) >= 0 and min(numbers[2:]) > 0:
        region = Region(*numbers)
        if region.x + region.width <= width and region.y + region.height <= height:
            return region
    expected = f"X,Y,W,H within {width} x {height} pixels, Y upwards from the bottom row"
    raise DumpError(told("region", expected, text, "such as 0,0,16,16"))


def read_exclusion(path: Path, width: int, height: int) -> NDArray[np.bool_]:
    """The pixels to leave out, bool (H, W), row 0 at the bottom: those not black in a PNG, not 0 in an NPY array.

    Alpha is not looked at. Raises DumpError for another format or size.
    """
    suffix = path.suffix.lower()
    if suffix not in MASK_SUFFIXES:
        raise DumpError(told(str(path), "a mask as PNG or NPY file", suffix or "no suffix", "convert it"))
    texels = parts_of(path)[0]
    if texels.data.shape[:2] != (height, width):
        came = "{1} x {0}".format(*texels.data.shape)
        raise DumpError(told(str(path), f"a mask of {width} x {height} pixels", came, "draw it on a dumped picture"))
    marked = (texels.data[..., [name != "A" for name in texels.channels]] != 0).any(axis=-1)
    return marked if suffix in BOTTOM_FIRST else marked[::-1]
