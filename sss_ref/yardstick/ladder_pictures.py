"""The pictures of a ladder: each technique beside the truth, with one exposure, and what lies between."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.pictures import tiles
from sss_ref.pictures.png_file import srgb8
from sss_ref.yardstick.deviation import Mask, Truth
from sss_ref.yardstick.ladder import Ladder

Pixels = NDArray[np.uint8]
SPAN = 0.2  # of white: the difference that has the last colour of the bar
STEPS = 256
ANCHORS = ((36, 92, 196), (120, 168, 232), (238, 238, 236), (238, 152, 104), (190, 40, 30))  # too dark ... too bright
SIGNED = np.stack(
    [np.interp(np.linspace(0, 4, STEPS), range(5), channel) for channel in zip(*ANCHORS, strict=True)], axis=-1
).astype(np.uint8)
REGION_COLOURS = {
    "lit": (226, 228, 233),
    "dark": (58, 62, 74),
    "thin": (232, 130, 60),
    "terminator": (84, 128, 190),
    "shadow edge": (47, 143, 91),
    "silhouette": (146, 104, 190),
    "seam": (214, 70, 60),
}  # sRGB; of several the last is shown


def exposed(image: Any, truth: Truth) -> Pixels:
    """A picture in the truth's units as sRGB, uint8 (H, W, 3), row 0 at the bottom."""
    return srgb8(np.asarray(image) / truth.white)


def signed(image: Any, truth: Truth, covered: Mask) -> Pixels:
    """Red where a picture is brighter than the truth, blue where it is darker: the mean of the channels."""
    apart = (np.asarray(image, np.float64) - truth.mean).mean(axis=-1) / truth.white
    return tiles.over_ground(SIGNED[tiles.stretched(apart, -SPAN, SPAN)], covered)


def colour_bar(width: int, height: int) -> Pixels:
    """The colours of `signed` from -SPAN to SPAN, uint8 (height, width, 3)."""
    row = SIGNED[np.linspace(0, STEPS - 1, width).round().astype(int)]
    return np.ascontiguousarray(np.broadcast_to(row, (height, width, 3)))


def region_map(ladder: Ladder) -> Pixels:
    """The regions in their colours."""
    shown = np.full((*ladder.masks["everywhere"].shape, 3), tiles.GROUND, np.uint8)
    for name, colour in REGION_COLOURS.items():
        if name in ladder.masks:
            shown[ladder.masks[name]] = colour
    return shown


def region_colour(name: str) -> str:
    """The colour of a region for a page; none for the whole body."""
    return "#{:02x}{:02x}{:02x}".format(*REGION_COLOURS[name]) if name in REGION_COLOURS else ""
