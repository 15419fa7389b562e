"""OpenEXR: named channels of half, float or uint, in one part or several."""

from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.dump.formats.exr_compression import is_spoiled, storage_after
from sss_ref.dump.formats.muted import muted
from sss_ref.dump.texels import STORAGE_OF_TYPE, Frame, StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

ELEMENT_BYTES = 4  # at most: float and uint; half has 2


def read(path: Path) -> tuple[StoredTexels, ...]:
    """The parts of an EXR file that hold pictures, each under its name, or its number if it has none.

    A part has the size of its data window, and its display window as its frame. Channels of
    different types in one part come as separate parts of the same name. Raises DumpError for deep and for subsampled
    channels, and where the library cannot read a part to its end: it leaves such parts out without a word.
    """
    import OpenEXR

    with muted():
        headers = [part.header for part in OpenEXR.File(str(path), header_only=True).parts]
    for header in headers:
        _check(path, header)
    with muted():
        parts = OpenEXR.File(str(path), separate_channels=True).parts
    if len(parts) != len(headers):
        raise DumpError(told(str(path), f"{len(headers)} whole parts", str(len(parts)), "write the file again"))
    return tuple(texels for index, part in enumerate(parts) for texels in _by_type(path, part, index))


def _check(path: Path, header: Any) -> None:
    """Hold what a part declares against the limits, before any memory is taken for it."""
    kind = str(getattr(header.get("type"), "name", ""))
    if "deep" in kind:
        raise DumpError(told(str(path), "one value for each pixel", f"a part of type {kind}", "flatten it"))
    coarse = [c for c in header["channels"] if (c.xSampling, c.ySampling) != (1, 1)]
    if coarse:
        came = ", ".join(f"{c.name} of every {c.xSampling} x {c.ySampling}" for c in coarse)
        remedy = "write R, G, B instead of luminance and chroma"
        raise DumpError(told(str(path), "a value of each channel for each pixel", came, remedy))
    for name in ("dataWindow", "displayWindow"):
        _, _, width, height = _window(header, name)
        check_size(path, width, height, ELEMENT_BYTES * len(header["channels"]))


def _window(header: Any, name: str) -> tuple[int, int, int, int]:
    """The left and the upper end of a rectangle of pixels, its width and its height."""
    low, high = (corner.astype(np.int64) for corner in header[name])
    return (*low.tolist(), *(high - low + 1).tolist())


def _by_type(path: Path, part: Any, index: int) -> list[StoredTexels]:
    """The channels of a part, those of one type together."""
    planes = {name: channel.pixels for name, channel in part.channels.items()}
    kinds = {name: plane.dtype.str[1:] for name, plane in planes.items()}
    compression = part.header["compression"].name.removesuffix("_COMPRESSION")
    spoiled = {name: compression for name, kind in kinds.items() if is_spoiled(compression, name, kind)}
    frame, found = _frame(path, part.header), []
    for kind in sorted(set(kinds.values())):
        names = tuple(name for name in planes if kinds[name] == kind)
        pixels = np.dstack([planes[name] for name in names])
        kept = storage_after(compression, STORAGE_OF_TYPE[kind])
        notes = (f"its compression {compression} keeps 24 bits of 32",) if kept == "float24" else ()
        name = part.header.get("name") or str(index)
        found.append(StoredTexels(pixels, names, kept, name, True, frame, notes, spoiled=spoiled))
    return found


def _frame(path: Path, header: Any) -> Frame | None:
    """The display window around the data window; None where they are the same. Raises DumpError if they do not meet."""
    (x, y, *size), (left, top, width, height) = _window(header, "dataWindow"), _window(header, "displayWindow")
    frame = Frame(width, height, x - left, y - top)
    if frame == Frame(size[0], size[1], 0, 0):
        return None
    if not (-size[0] < frame.x < width and -size[1] < frame.y < height):
        expected, came = "a data window that meets the display window", f"{size[0]} x {size[1]} {frame}"
        raise DumpError(told(str(path), expected, came, "correct the windows"))
    return frame
