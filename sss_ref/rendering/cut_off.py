"""A note on an image that is too bright for its picture."""

from collections.abc import Iterator
from math import ceil, log2

import numpy as np

from sss_ref.scene_file.quantities import MOST_STOPS
from sss_ref.scene_file.settings import Output

SHARE = 0.01  # of the pixels that are no background; fewer are highlights, which may be white


def cut_off(output: Output, image: np.ndarray) -> Iterator[str]:
    """Whether too many pixels of an image, float32 (H, W, 3), are beyond 1 in their picture, where 8 bits end."""
    limit = np.float32(1) / output.gain
    if image.max() <= limit:
        return
    red, green, blue = np.moveaxis(image, -1, 0)  # NumPy takes ten times as long for reductions along three values
    background = [
        channel != np.float32(value) for channel, value in zip((red, green, blue), output.background, strict=True)
    ]
    shown = np.maximum(np.maximum(red, green), blue)[background[0] | background[1] | background[2]]
    share = float((shown > limit).mean()) if shown.size else 0.0
    if share > SHARE:
        last = shown.size - 1 - int(SHARE * shown.size)
        highest = np.partition(shown, last)[last]
        stops = -ceil(10 * log2(highest)) / 10
        remedy = f"set output.exposure = {stops:g}" if stops >= -MOST_STOPS else "make the lights fainter"
        yield f"image: {share:.1%} of its pixels are brighter than the picture can show and are cut off; {remedy}"
