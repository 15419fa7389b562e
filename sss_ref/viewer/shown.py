"""A buffer of a rendering as the page shows it: its pixels, and what is said about them."""

from typing import Any

import numpy as np

from sss_ref.language.pipeline import Pass
from sss_ref.passes.buffers import described
from sss_ref.pictures import tiles
from sss_ref.pictures.overview import tiles_of
from sss_ref.pictures.png_file import image_encoding_of
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene

RAMP = ["#{:02x}{:02x}{:02x}".format(*anchor) for anchor in tiles.RAMP_ANCHORS]  # of the colour bar


def pass_of(scene: Scene, name: str) -> Pass:
    """The pass that writes a buffer."""
    (found,) = (each for each in scene.method.passes if name in each.values)
    return found


def needed(scene: Scene, name: str) -> set[str]:
    """The buffers that a rendering must keep so that one can be shown: itself, and where it was drawn."""
    this_pass = pass_of(scene, name)
    limit = this_pass.draw.triangle or this_pass.draw.stencil
    return {name} if name == "image" or not limit else {name, limit}


def pixels_of(result: Result, name: str) -> tuple[np.ndarray, dict[str, Any]]:
    """A kept buffer as sRGB uint8 (H, W, 4), the top row first, and its range, unit and colours.

    The image is what `image.png` shows, in front of its background.
    """
    if name == "image":
        colours = image_encoding_of(result.scene.settings)(result.image)
        return opaque(colours), {"low": None, "high": None, "ramp": None, "unit": described(name).unit}
    (tile,) = (each for each in tiles_of(result) if each.name == name)
    colours = tiles.picture(name, tile.buffer, tile.covered, tile.value_range, tile.encode)
    low, high = tile.range_text
    ramp = RAMP if tiles.has_ramp(name, tile.buffer) else None
    return opaque(colours), {"low": low, "high": high, "ramp": ramp, "unit": described(name).unit}


def opaque(colours: np.ndarray) -> np.ndarray:
    """Colours uint8 (H, W, 3), row 0 at the bottom, as (H, W, 4), the top row first."""
    height, width = colours.shape[:2]
    shown = np.full((height, width, 4), 255, np.uint8)
    shown[..., :3] = colours[::-1]
    return shown
