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
    shown = image[(image != np.array(output.background, np.float32)).any(axis=-1)].max(axis=-1)
    share = float((shown > limit).mean()) if shown.size else 0.0
    if share > SHARE:
        highest = np.sort(shown)[-1 - int(SHARE * shown.size)]
        stops = -ceil(10 * log2(highest)) / 10
        remedy = f"set output.exposure = {stops:g}" if stops >= -MOST_STOPS else "make the lights fainter"
        yield f"image: {share:.1%} of its pixels are brighter than the picture can show and are cut off; {remedy}"
