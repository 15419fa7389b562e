"""All buffers in one multi-part EXR file: a part per buffer under the buffer's name, top row first.

float32 stays float32; masks and triangle indices become UINT, where -1 is 4294967295. Buffers of different sizes share
the display window, as the format demands, and each has the data window of its own size from the same top left corner.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.cache.spare_memory import SPARE
from sss_ref.passes.buffers import described
from sss_ref.pictures.channels import channel_names

ROWS = 16  # copied at a time


def write_exr(
    path: Path, buffers: Mapping[str, np.ndarray], size: tuple[int, int], metadata: Mapping[str, str | int]
) -> None:
    """Write buffers (H, W) or (H, W, C), row 0 at the bottom, as the parts of one EXR file at `path`.

    size: width and height of the display window. metadata: attributes of every part, prefixed with `sss_ref:`.
    """
    import OpenEXR

    attributes = {f"sss_ref:{key}": value for key, value in metadata.items()}
    image_first = sorted(buffers, key=lambda name: name != "image")  # viewers open the first part
    parts = []
    for name in image_first:
        header = {**_windows(buffers[name], size), **attributes, "sss_ref:unit": described(name).unit, "name": name}
        header |= {"type": OpenEXR.scanlineimage, "compression": OpenEXR.RLE_COMPRESSION}
        parts.append(OpenEXR.Part(header, _channels(name, buffers[name])))
    OpenEXR.set_global_thread_count(0)  # threads of its own take longer than this one alone
    OpenEXR.File(parts).write(str(path))


def _windows(buffer: np.ndarray, size: tuple[int, int]) -> dict[str, Any]:
    """The data window of a buffer in a display window of `size`; both ends are inclusive."""
    height, width = buffer.shape[:2]
    return {"dataWindow": _box(width, height), "displayWindow": _box(*size)}


def _box(width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
    return np.zeros(2, np.int32), np.array([width - 1, height - 1], np.int32)


def plane_by_plane(buffer: np.ndarray) -> np.ndarray:
    """A buffer of the same values, whose memory is as EXR has it: a plane for each channel, top row first."""
    rows = np.atleast_3d(buffer)[::-1]
    planes = SPARE.empty((rows.shape[2], *rows.shape[:2]), rows.dtype)
    for row in range(0, len(rows), ROWS):  # so that all channels of some rows are in the processor's cache
        planes[:, row : row + ROWS] = np.moveaxis(rows[row : row + ROWS], -1, 0)
    return np.moveaxis(planes, 0, -1)[::-1].reshape(buffer.shape)


def _channels(name: str, buffer: np.ndarray) -> dict[str, np.ndarray]:
    """Channel -> its plane; contiguous, because OpenEXR would write other pixels of an array with strides."""
    planes = _planes(_stored(buffer))
    if not planes.flags.c_contiguous:
        planes = _planes(plane_by_plane(_stored(buffer)))
    return dict(zip(channel_names(name, buffer), planes, strict=True))


def _planes(buffer: np.ndarray) -> np.ndarray:
    """The channels of a buffer, (C, H, W), top row first; nothing is copied."""
    return np.moveaxis(np.atleast_3d(buffer)[::-1], -1, 0)


def _stored(buffer: np.ndarray) -> np.ndarray:
    """A buffer in one of the types that EXR has."""
    if buffer.dtype.kind == "f":
        return buffer.astype(np.float32, copy=False)
    return buffer.astype(np.int32, copy=False).view(np.uint32)  # -1 wraps
