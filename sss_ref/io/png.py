"""The preview: linear colours encoded as 8-bit sRGB (IEC 61966-2-1) in a PNG file, top row first."""

from functools import cache
from pathlib import Path

import numpy as np


@cache
def srgb_edges() -> np.ndarray:
    """The least float32 linear value of each code from 1 to 255, float32 (255,).

    Code k stands for encoded values from (k - 1/2)/255 on. Decoding those bounds once, at 50 digits, leaves only
    comparisons to the encoder, so the same pixels come out on every processor.
    """
    return np.array([_least_float32_of_code(code) for code in range(1, 256)], np.float32)


def _least_float32_of_code(code: int) -> np.float32:
    from mpmath import mp, mpf

    with mp.workdps(50):
        encoded = (mpf(code) - mpf("0.5")) / 255
        low = encoded <= mpf("0.04045")
        linear = encoded / mpf("12.92") if low else ((encoded + mpf("0.055")) / mpf("1.055")) ** mpf("2.4")
        nearest = np.float32(float(linear))
        return nearest if mpf(float(nearest)) >= linear else np.nextafter(nearest, np.float32(1))


def srgb8(linear: np.ndarray) -> np.ndarray:
    """Linear float32 values, of any shape, as sRGB codes 0 to 255 (uint8); values outside 0 to 1 are cut off."""
    return np.searchsorted(srgb_edges(), linear, side="right").astype(np.uint8)


def write_png(path: Path, image: np.ndarray, coverage: np.ndarray | None = None) -> None:
    """Write a linear RGB image float32 (H, W, 3), row 0 at the bottom, as an sRGB PNG.

    coverage: 0 to 1 (H, W), becomes alpha (colour is not premultiplied by it); None: no alpha channel.
    """
    import imageio.v3 as imageio

    pixels = srgb8(image)
    if coverage is not None:
        pixels = np.dstack((pixels, np.rint(coverage * np.float32(255)).astype(np.uint8)))
    imageio.imwrite(path, pixels[::-1])
