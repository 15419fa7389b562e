"""The exercises of lesson 6: texture space."""

from collections.abc import Callable

import numpy as np

from sss_ref.course.checks.answers import NotYet
from sss_ref.language import ivec2, nearest_texel, vec2


def texel_that_holds(answer: Callable[[float, int], int]) -> None:
    """06: the column of the texel that holds a texture coordinate."""
    for width in (4, 7, 1024):
        for u in (0.0, 0.1, 0.24, 0.26, 0.499, 0.5, 0.74, 0.99, 1.0):
            at = nearest_texel(ivec2(np.int32(width), np.int32(1)), vec2(np.float32(u), np.float32(0)))
            got = answer(u, width)
            if got != at.x:
                raise NotYet(
                    f"u = {u:g} lies in column {at.x} of {width}, and you say {got}. "
                    "Texel i reaches from i/width to (i + 1)/width, and the last one also holds u = 1."
                )
