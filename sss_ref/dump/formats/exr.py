"""OpenEXR: named channels of half, float or uint, in one part or several."""

from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.dump.texels import STORAGE_OF_TYPE, StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

ELEMENT_BYTES = 4  # at most: float and uint; half has 2


def read(path: Path) -> tuple[StoredTexels, ...]:
    """The parts of an EXR file that hold pictures, each under its name, or its number if it has none.

    Channels of different types in one part come as separate parts of the same name. Raises DumpError where the library
    cannot read a part to its end: it leaves such parts out without a word.
    """
    import OpenEXR

    headers = [part.header for part in OpenEXR.File(str(path), header_only=True).parts]
    for header in headers:
        low, high = (corner.astype(np.int64) for corner in header["dataWindow"])
        width, height = (high - low + 1).tolist()
        check_size(path, width, height, ELEMENT_BYTES * len(header["channels"]))
    parts = OpenEXR.File(str(path), separate_channels=True).parts
    if len(parts) != len(headers):
        raise DumpError(told(str(path), f"{len(headers)} whole parts", str(len(parts)), "write the file again"))
    return tuple(texels for index, part in enumerate(parts) for texels in _by_type(path, part, index))


def _by_type(path: Path, part: Any, index: int) -> list[StoredTexels]:
    """The channels of a part, those of one type together."""
    planes = {name: channel.pixels for name, channel in part.channels.items()}
    if len({plane.shape for plane in planes.values()}) != 1 or any(plane.dtype == object for plane in planes.values()):
        raise DumpError(told(str(path), "channels of one size, not deep", "others", "write the file again"))
    name = part.header.get("name") or str(index)
    return [
        StoredTexels(np.dstack([planes[c] for c in names]), names, STORAGE_OF_TYPE[dtype.str[1:]], name)
        for dtype in sorted({plane.dtype for plane in planes.values()}, key=str)
        if (names := tuple(channel for channel, plane in planes.items() if plane.dtype == dtype))
    ]
