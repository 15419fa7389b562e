"""Arrays as text inside a page: little-endian bytes in base 64, as they are or deflated."""

import base64
import zlib
from typing import Any

import numpy as np

Packed = str | dict[str, Any]


def plain(data: np.ndarray) -> Packed:
    """The bytes of an array."""
    return _text(_bytes(data))


def deflated(data: np.ndarray) -> Packed:
    """The same in fewer letters: all first bytes of its numbers, then all second ones, deflated (RFC 1950)."""
    planes = np.frombuffer(_bytes(data), np.uint8).reshape(-1, data.itemsize).T
    return {"deflated": _text(zlib.compress(planes.tobytes(), 9)), "size": data.itemsize}


def _bytes(data: np.ndarray) -> bytes:
    return np.ascontiguousarray(data, data.dtype.newbyteorder("<")).tobytes()


def _text(content: bytes) -> str:
    return base64.b64encode(content).decode("ascii")
