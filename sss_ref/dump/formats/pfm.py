"""PFM, the portable float map: three lines of text, then float32, the bottom row first.

Source: P. Debevec's and the Netpbm description of the format. "PF" has three channels, "Pf" one; a negative scale means
little-endian; what the scale is beside its sign, multiplies the samples.
"""

import re
from pathlib import Path

import numpy as np

from sss_ref.dump.loss import ROUNDING, Loss
from sss_ref.dump.texels import StoredTexels, check_size
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

CHANNELS = {b"PF": "RGB", b"Pf": "R", b"PF4": "RGBA"}
HEADER = re.compile(rb"(PF4|PF|Pf)\s+(\d{1,9})\s+(\d{1,9})\s+([-+]?[0-9.]+(?:[eE][-+]?\d+)?)(?:\r\n|\s)")
LONGEST_HEADER = 256  # bytes


def read(path: Path) -> tuple[StoredTexels]:
    """The texels of a PFM file. Raises DumpError."""
    with path.open("rb") as file:
        start = HEADER.match(file.read(LONGEST_HEADER))
        scale = _number(start[4]) if start else 0.0
        if not start or not scale:
            remedy = "dump the buffer again"
            raise DumpError(told(str(path), "PF or Pf, a width, a height and a scale", "another header", remedy))
        width, height, channels = int(start[2]), int(start[3]), CHANNELS[start[1]]
        texel_bytes = 4 * len(channels)
        available = path.stat().st_size - start.end()
        check_size(path, width, height, texel_bytes, available)
        left = available - texel_bytes * width * height
        if left:
            expected = f"{available - left} bytes for {width} x {height} texels"
            raise DumpError(told(str(path), expected, f"{left} more", "dump the buffer again"))
        file.seek(start.end())
        data = file.read(available)
    stored = np.frombuffer(data, "<f4" if scale < 0 else ">f4").reshape(height, width, len(channels))
    return (_multiplied(stored.astype(np.float32), abs(scale), tuple(channels)),)


def _number(text: bytes) -> float:
    """The number of a header, 0 where it is none."""
    try:
        return float(np.float32(text.decode("ascii")))
    except ValueError:
        return 0.0


def _multiplied(data: np.ndarray, scale: float, channels: tuple[str, ...]) -> StoredTexels:
    if scale == 1.0:
        return StoredTexels(data, channels, "float32")
    with np.errstate(all="ignore"):
        values = (data.astype(np.float64) * scale).astype(np.float32)
    note = f"multiplied by the scale of its header, {scale:g}"
    return StoredTexels(values, channels, "float32", notes=(note,), loss=Loss(ROUNDING))
