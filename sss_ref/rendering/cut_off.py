"""A note on an image that is too bright for its picture."""

from collections.abc import Iterator
from math import ceil, log2

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.scene_file.quantities import MOST_STOPS
from sss_ref.scene_file.settings import Output

SHARE = 0.01  # of the pixels that are no background; fewer are highlights, which may be white


def cut_off(output: Output, image: np.ndarray) -> Iterator[str]:
    """Whether too many pixels of an image, float32 (H, W, 3), are beyond 1 in their picture, where 8 bits end."""
    limit = np.float32(1) / output.gain
    if image.max() <= limit:
        return
    shown, brighter = too_bright(image, np.array(output.background, np.float32), limit)
    share = len(brighter) / shown if shown else 0.0
    if share > SHARE:
        last = len(brighter) - 1 - int(SHARE * shown)
        highest = np.partition(brighter, last)[last]
        stops = -ceil(10 * log2(highest)) / 10
        remedy = f"set output.exposure = {stops:g}" if stops >= -MOST_STOPS else "make the lights fainter"
        yield f"image: {share:.1%} of its pixels are brighter than the picture can show and are cut off; {remedy}"


@compiled
def too_bright(image: np.ndarray, background: np.ndarray, limit: np.float32) -> tuple[int, np.ndarray]:
    """How many pixels of an image, (H, W, 3), are no background, and the largest value of each above a limit."""
    shown, count, brighter = 0, 0, np.empty(image.shape[0] * image.shape[1], np.float32)
    for row in range(image.shape[0]):
        for column in range(image.shape[1]):
            red, green, blue = image[row, column]
            if red != background[0] or green != background[1] or blue != background[2]:
                shown += 1
                if max(red, green, blue) > limit:
                    brighter[count] = max(red, green, blue)
                    count += 1
    return shown, brighter[:count]
