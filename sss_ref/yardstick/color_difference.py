"""CIEDE2000: how different two colours look, 1 being about what is just seen."""

from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from sss_ref.pictures.png_file import srgb8

FloatArray = NDArray[np.float64]
MISSING = 'delta E 2000 is not told without scikit-image: pip install "sss_ref[metrics]"'


def has_color_difference() -> bool:
    """Whether there is what computes it, the extra `metrics`."""
    return find_spec("skimage") is not None


def color_difference(one: FloatArray, other: FloatArray) -> FloatArray | None:
    """CIEDE2000 of each pixel (H, W) of two linear pictures (H, W, 3), 1 being white, as 8 bits of sRGB show them.

    None where scikit-image is not installed. Source: Sharma, Wu and Dalal (2005), by `skimage.color`.
    """
    if not has_color_difference():
        return None
    from skimage.color import deltaE_ciede2000, rgb2lab

    return np.asarray(deltaE_ciede2000(rgb2lab(srgb8(one)), rgb2lab(srgb8(other))), np.float64)
