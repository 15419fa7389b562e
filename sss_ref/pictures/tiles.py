"""One buffer as a picture to look at: what kind of values it holds decides how they are shown."""

from collections.abc import Callable

import numpy as np

from sss_ref.pictures.channels import channel_names
from sss_ref.pictures.png_file import srgb8

GROUND = (22, 24, 29)  # sRGB 8-bit, behind everything and wherever nothing is drawn
MASK = (226, 228, 233)
RAMP_ANCHORS = ((58, 32, 104), (57, 84, 158), (33, 138, 148), (84, 188, 110), (200, 222, 78), (255, 247, 194))
RAMP = np.stack(
    [np.interp(np.linspace(0, 5, 256), range(6), channel) for channel in zip(*RAMP_ANCHORS, strict=True)], axis=-1
).astype(np.uint8)
"""256 colours from low to high values, of steadily rising lightness."""

BRIGHTENED = np.linspace(60, 255, 256).astype(np.uint8)


def picture(
    name: str,
    buffer: np.ndarray,
    covered: np.ndarray,
    spread: tuple[float, float] | None = None,
    encode: Callable[[np.ndarray], np.ndarray] = srgb8,
) -> np.ndarray:
    """A buffer as sRGB uint8 (H, W, 3), row 0 at the bottom; covered: bool (H, W), the pixels that were drawn.

    spread: the values that the colours range over; None: the least and the largest that are drawn. encode: how colours
    become 8 bits.
    """
    kind = "".join(channel_names(name, buffer))
    if kind == "RGB":
        return over_ground(encode(buffer), covered)
    if buffer.dtype == np.uint8:
        return over_ground(np.array(MASK, np.uint8), buffer != 0)
    if buffer.dtype.kind == "i":
        return over_ground(hashed_colours(buffer), covered)
    if kind == "UV":
        return over_ground(uv_colours(buffer), covered & (buffer >= 0).all(axis=-1))
    values = stretched(buffer, *(spread or value_range(buffer, covered)))
    return over_ground(values if kind == "XYZ" else RAMP[values], covered)


def value_range(buffer: np.ndarray, covered: np.ndarray) -> tuple[float, float]:
    """Least and largest value over the covered pixels; 0, 0 where there are none."""
    values = buffer[covered]
    return (values.min().item(), values.max().item()) if values.size else (0, 0)


def has_ramp(name: str, buffer: np.ndarray) -> bool:
    """Whether a buffer is shown by the colours of RAMP."""
    return channel_names(name, buffer) == ("Y",) and buffer.dtype.kind == "f"


def over_ground(colours: np.ndarray, covered: np.ndarray) -> np.ndarray:
    """Colours where covered, GROUND elsewhere."""
    shown = np.full((*covered.shape, 3), GROUND, np.uint8)
    np.copyto(shown, colours, where=covered[..., None])
    return shown


def stretched(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Values from `low` to `high` as 0 to 255; one single value becomes the middle."""
    if low == high:
        return np.full(values.shape, 128, np.uint8)
    share = (np.clip(values, low, high).astype(np.float64) - low) / (high - low)
    codes: np.ndarray = np.rint(share * 255).astype(np.uint8)
    return codes


def uv_colours(uv: np.ndarray) -> np.ndarray:
    """Texture coordinates as red and green, over a blue that keeps (0, 0) from being black."""
    return np.dstack((stretched(uv, 0, 1), np.full(uv.shape[:2], 90, np.uint8)))


def hashed_colours(indices: np.ndarray) -> np.ndarray:
    """A colour for each index, neighbours far apart: the upper three bytes of a multiplicative hash, none too dark."""
    mixed = (indices.astype("<u4") + np.uint32(1)) * np.uint32(2654435769)
    upper = mixed.view(np.uint8).reshape(*indices.shape, 4)[..., 1:]
    return BRIGHTENED[upper]
