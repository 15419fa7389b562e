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

ROWS = 64  # taken and coloured at a time: what is made on the way is so small that it needs no new memory


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
    spread = spread or value_range(buffer, covered)
    shown = _ground(covered.shape)
    for row in range(0, len(covered), ROWS):
        rows = slice(row, row + ROWS)
        drawn = _drawn(kind, buffer[rows], covered[rows])
        colours = _colours(kind, taken(buffer[rows], drawn), spread, encode)
        for channel in range(3):
            shown[rows, :, channel][drawn] = colours[:, channel]
    return shown


def _drawn(kind: str, buffer: np.ndarray, covered: np.ndarray) -> np.ndarray:
    """Bool (H, W): the pixels that are coloured, of those covered."""
    if buffer.dtype == np.uint8:
        return np.asarray(buffer != 0)
    drawn = np.ascontiguousarray(covered)  # it is gone through often
    return drawn & (buffer >= 0).all(axis=-1) if kind == "UV" else drawn


def _colours(
    kind: str,
    values: np.ndarray,
    spread: tuple[float, float],
    encode: Callable[[np.ndarray], np.ndarray],
) -> np.ndarray:
    """The colours uint8 (N, 3) of the values (N,) or (N, C) that are drawn of a buffer with the channels `kind`."""
    if kind == "RGB":
        return encode(values)
    if kind == "UV":
        return uv_colours(values)
    if values.dtype == np.uint8:
        return np.broadcast_to(np.array(MASK, np.uint8), (len(values), 3))
    if values.dtype.kind == "i":
        return hashed_colours(values)
    codes = stretched(values, *spread)
    return codes if kind == "XYZ" else np.take(RAMP, codes, axis=0)


def taken(buffer: np.ndarray, drawn: np.ndarray) -> np.ndarray:
    """The values (N,) or (N, C) of a buffer at the pixels of a mask; whole pixels take NumPy three times as long."""
    if buffer.ndim == 2:
        return np.asarray(buffer[drawn])
    return np.stack([buffer[..., channel][drawn] for channel in range(buffer.shape[2])], axis=-1)


def value_range(buffer: np.ndarray, covered: np.ndarray) -> tuple[float, float]:
    """Least and largest value over the covered pixels; 0, 0 where there are none."""
    channels = np.moveaxis(np.atleast_3d(buffer), -1, 0)
    parts = (
        channel[row : row + ROWS][covered[row : row + ROWS]]
        for channel in channels
        for row in range(0, len(covered), ROWS)
    )
    ends = np.array([(each.min(), each.max()) for each in parts if each.size])
    return (ends[:, 0].min().item(), ends[:, 1].max().item()) if len(ends) else (0, 0)


def has_ramp(name: str, buffer: np.ndarray) -> bool:
    """Whether a buffer is shown by the colours of RAMP."""
    return channel_names(name, buffer) == ("Y",) and buffer.dtype.kind == "f"


def over_ground(colours: np.ndarray, covered: np.ndarray) -> np.ndarray:
    """Colours where covered, GROUND elsewhere."""
    shown = _ground(covered.shape)
    np.copyto(shown, colours, where=covered[..., None])
    return shown


def _ground(size: tuple[int, ...]) -> np.ndarray:
    """A picture uint8 (H, W, 3) of GROUND alone, channel by channel: of whole pixels it takes NumPy longer."""
    shown = np.empty((*size, 3), np.uint8)
    for channel, value in enumerate(GROUND):
        shown[..., channel] = value
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
    return np.concatenate((stretched(uv, 0, 1), np.full((*uv.shape[:-1], 1), 90, np.uint8)), axis=-1)


def hashed_colours(indices: np.ndarray) -> np.ndarray:
    """A colour for each index, neighbours far apart: the upper three bytes of a multiplicative hash, none too dark."""
    mixed = (indices.astype("<u4") + np.uint32(1)) * np.uint32(2654435769)
    upper = mixed.view(np.uint8).reshape(*indices.shape, 4)[..., 1:]
    return np.take(BRIGHTENED, upper)
