"""All buffers in one multi-part EXR file: a part per buffer under the buffer's name, top row first.

float32 stays float32; masks and triangle indices become UINT, where -1 is 4294967295. Buffers of different sizes share
the display window, as the format demands, and each has the data window of its own size from the same top left corner.
"""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.passes.buffers import described
from sss_ref.pictures.channels import channel_names


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
        header |= {"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIPS_COMPRESSION}
        parts.append(OpenEXR.Part(header, _channels(name, buffers[name])))
    OpenEXR.set_global_thread_count(os.cpu_count() or 1)
    OpenEXR.File(parts).write(str(path))


def _windows(buffer: np.ndarray, size: tuple[int, int]) -> dict[str, Any]:
    """The data window of a buffer in a display window of `size`; both ends are inclusive."""
    height, width = buffer.shape[:2]
    return {"dataWindow": _box(width, height), "displayWindow": _box(*size)}


def _box(width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
    return np.zeros(2, np.int32), np.array([width - 1, height - 1], np.int32)


def _channels(name: str, buffer: np.ndarray) -> dict[str, np.ndarray]:
    """Channel -> its plane; contiguous, because OpenEXR would write other pixels of an array with strides."""
    planes = np.moveaxis(np.atleast_3d(buffer), -1, 0)[:, ::-1]
    kind = np.float32 if buffer.dtype.kind == "f" else np.uint32
    # Through int64, -1 wraps to 4294967295 by rule and not by chance of the platform.
    whole = planes if kind is np.float32 else planes.astype(np.int64) & 0xFFFFFFFF
    return {
        channel: np.ascontiguousarray(p, kind) for channel, p in zip(channel_names(name, buffer), whole, strict=True)
    }
