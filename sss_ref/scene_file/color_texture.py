"""Pictures over a mesh: their codes, and those of 8 bits that are sRGB decoded to linear float32 by a table."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.cache.recent import of_unchanged_file
from sss_ref.errors import SceneError
from sss_ref.errors.array_file import mapped_array
from sss_ref.numerics.trigonometry import fifty_digits
from sss_ref.scene_file.png_codes import Codes, PngContent, PngFault
from sss_ref.scene_file.quantities import LARGEST_SIZE

MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")  # Pillow's names of what has 8 bits a channel or fewer
PNG_DEPTH = slice(24, 25)  # where a PNG file says how many bits a channel has

FloatArray = NDArray[np.float32]


@of_unchanged_file
def load_texture(path: Path) -> FloatArray:
    """The texels of a PNG or JPEG file: linear RGB float32 (H, W, 3), row 0 at the bottom.

    Read as sRGB with 8 bits a channel, whatever profile is in the file. Grey becomes RGB; alpha is not used. Raises
    SceneError as `codes_of` does.
    """
    return srgb_decoded()[codes_of(path)]


def codes_of(path: Path, deepest: int = 8) -> Codes:
    """The codes of a PNG or JPEG file, uint8 or uint16 (H, W, 3), row 0 at the bottom. Grey becomes RGB.

    deepest: 8 or 16 bits a channel, where PNG may have more than 8. Raises SceneError for anything else, for a side of
    more than 16384 texels, and for what Pillow takes for a bomb (more than 178 million texels).
    """
    try:
        with _opened(path) as (image, depth):
            deep = image.format == "PNG" and depth == b"\x10"
            _check(image, deep, deepest)
            return _deep_codes(path) if deep else np.asarray(image.convert("RGB"))[::-1]
    except SceneError:
        raise
    except PngFault as fault:
        raise SceneError(str(fault)) from None
    except Exception as error:  # whatever a broken picture makes Pillow raise
        raise SceneError(f"expected a PNG or JPEG picture, got {_reason(error)}; export it again") from None


def texture_size(path: Path) -> tuple[int, int]:
    """Width and height that a picture, or an array in its place, declares; 0, 0 for none, which is refused later."""
    try:
        if path.suffix == ".npy":
            array = mapped_array(path)
            height, width, _ = (0, 0, 0) if array is None else array.shape
            return width, height
        with _opened(path) as (image, _):
            width, height = image.size
            return width, height
    except Exception:  # whatever a broken picture makes Pillow raise
        return 0, 0


@cache
def srgb_decoded() -> FloatArray:
    """The linear value of each 8-bit sRGB code, correctly rounded to float32 (256,).

    c/12.92 up to c = 0.04045, then ((c + 0.055)/1.055)^2.4, with c = code/255 (IEC 61966-2-1).
    """
    return np.array([_decoded(code) for code in range(256)], np.float32)


@contextmanager
def _opened(path: Path) -> Iterator[tuple[Any, bytes]]:
    """A picture of which only the header was read, and the byte where PNG has its depth."""
    from PIL import Image

    with warnings.catch_warnings(), path.open("rb") as file:
        warnings.simplefilter("ignore")
        depth = file.read(PNG_DEPTH.stop)[PNG_DEPTH]
        with Image.open(file, formats=("PNG", "JPEG")) as image:
            yield image, depth


def _decoded(code: int) -> float:
    mp = fifty_digits()
    c = mp.mpf(code) / 255
    linear = (
        c / mp.mpf("12.92") if c <= mp.mpf("0.04045") else ((c + mp.mpf("0.055")) / mp.mpf("1.055")) ** mp.mpf("2.4")
    )
    return float(mp.fadd(linear, 0, prec=24))  # to the precision of float32 in one step, not by way of float64


def _reason(error: Exception) -> str:
    """Why Pillow gives no texels, in words of our own."""
    from PIL import Image, UnidentifiedImageError

    if isinstance(error, UnidentifiedImageError):
        return "another kind of file"
    if isinstance(error, Image.DecompressionBombError):
        return f"one of more than {2 * (Image.MAX_IMAGE_PIXELS or 0)} texels"
    return "one that is broken or breaks off"


def _check(image: Any, deep: bool, deepest: int) -> None:
    if max(image.size) > LARGEST_SIZE:
        came = "{} x {}".format(*image.size)
        raise SceneError(f"expected at most {LARGEST_SIZE} texels a side, got {came}; scale it down")
    if deepest < 16 and deep:
        raise SceneError("expected grey or RGB of 8 bits a channel, got 16 bits; convert the picture")
    if image.mode not in MODES and not deep:
        raise SceneError(f"expected grey or RGB of 8 bits a channel, got {image.mode}; convert the picture")


def _deep_codes(path: Path) -> Codes:
    """The codes of a PNG file of 16 bits, of which Pillow keeps 8."""
    content = PngContent.of(path.read_bytes())
    rgb: Codes = content.codes()[::-1, :, [0, 1, 2] if "G" in content.header.channels else [0, 0, 0]]
    return rgb
