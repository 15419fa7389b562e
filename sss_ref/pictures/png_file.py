"""The preview: colours in 8 bits, as sRGB (IEC 61966-2-1) or as they are, in a PNG file, top row first."""

import zlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.scene_file.settings import SceneFile

ROWS = 16  # encoded at a time
DROPPED_BITS = 15  # of a float32: sign, exponent and 8 bits of the fraction stay
ZLIB: dict[str, Any] = {
    "compress_level": 1,
    "compress_type": zlib.Z_RLE,
}
"""For Pillow: a third of the time of its default, for files 10 to 20 % larger."""


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
    """Linear values, of any shape, rounded to float32, as sRGB codes 0 to 255 (uint8); those beyond are cut off.

    The code of the least value with the same leading bits, and one more where the value has reached the next edge.
    """
    least, ends = _codes_by_leading_bits(), np.append(srgb_edges(), np.float32(np.nan))  # nothing ends 255
    linear = np.array(linear, np.float32, order="C")
    leading = np.clip(linear.view(np.int32) >> DROPPED_BITS, 0, len(least) - 1)
    codes: np.ndarray = least[leading]
    codes += linear >= ends[codes]
    return codes


@cache
def _codes_by_leading_bits() -> np.ndarray:
    """The code, uint8, of the least float32 from 0 to 1 with the same leading bits, by these bits as a number.

    No two edges have the same leading bits: next to each other they are .9 % apart and more, and these values .4 %.
    """
    count = (int(np.float32(1).view(np.int32)) >> DROPPED_BITS) + 1
    starts = (np.arange(count, dtype=np.int32) << DROPPED_BITS).view(np.float32)
    return np.searchsorted(srgb_edges(), starts, side="right").astype(np.uint8)


def plain8(values: np.ndarray) -> np.ndarray:
    """float32 values, of any shape, as 0 to 255 (uint8) without encoding; values outside 0 to 1 are cut off."""
    codes: np.ndarray = np.rint(np.clip(values, 0, 1) * np.float32(255)).astype(np.uint8)
    return codes


def encoding_of(settings: SceneFile) -> Callable[[np.ndarray], np.ndarray]:
    """How a scene's colours become 8 bits; the printed figures show theirs without sRGB encoding."""
    return plain8 if settings.preset == "published" else srgb8


def image_encoding_of(settings: SceneFile) -> Callable[[np.ndarray], np.ndarray]:
    """How a scene's image becomes 8 bits: made brighter by output.exposure, then as other colours."""
    encode, gain = encoding_of(settings), settings.output.gain

    @np.errstate(over="ignore")  # what becomes infinite is cut off as well
    def brightened(linear: np.ndarray) -> np.ndarray:
        return encode(linear * gain)

    return encode if gain == 1 else brightened


def write_png(
    path: Path,
    image: np.ndarray,
    coverage: np.ndarray | None = None,
    encode: Callable[[np.ndarray], np.ndarray] = srgb8,
) -> None:
    """Write a linear RGB image float32 (H, W, 3), row 0 at the bottom, as a PNG file at `path`.

    coverage: 0 to 1 (H, W), becomes alpha (colour is not premultiplied by it); None: no alpha channel.
    encode: what brings linear values to 8 bits, `srgb8` or `plain8`.
    """
    from PIL import Image

    Image.fromarray(_pixels(image, coverage, encode)).save(path, **ZLIB)


def _pixels(image: np.ndarray, coverage: np.ndarray | None, encode: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """What `write_png` writes, uint8 (H, W, 3), or with alpha (H, W, 4), top row first."""
    pixels = np.empty((*image.shape[:2], 3 if coverage is None else 4), np.uint8)
    for start in range(0, len(image), ROWS):  # what encoding needs on the way is of some rows, never of the picture
        rows = slice(start, start + ROWS)
        pixels[rows, :, :3] = encode(image[::-1][rows])
        if coverage is not None:
            pixels[rows, :, 3] = plain8(coverage[::-1][rows])
    return pixels
