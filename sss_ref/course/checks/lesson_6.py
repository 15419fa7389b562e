"""The exercises of lesson 6: texture space."""

from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import WHOLE
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.language import ivec2, nearest_texel, vec2
from sss_ref.passes.texture_image import image_sqrt


def texel_that_holds(answer: Any) -> None:
    """A line: the column of the texel that holds a texture coordinate."""
    for width in (4, 7, 1024):
        for u in (0.0, 0.1, 0.24, 0.26, 0.499, 0.5, 0.74, 0.99, 1.0):
            at = nearest_texel(ivec2(np.int32(width), np.int32(1)), vec2(np.float32(u), np.float32(0)))
            got = called(answer, WHOLE, u, width)
            if got != at.x:
                raise NotYet(
                    f"u = {u:g} lies in column {at.x} of {width}, and you say {got}. "
                    "Texel i reaches from i/width to (i + 1)/width, and the last one also holds u = 1."
                )


def mixed_with_phong(answer: Any) -> None:
    """A stage: irradiance and Phong colour mixed to a picture, as paper 2.2 does."""
    hint = "Twice the light has to give a picture twice as bright, and it is in both factors."
    compared(answer, image_sqrt, fragments(6), hint)


def layout_in_glsl(answer: Any) -> None:
    """A shader: the clip position at which a vertex is drawn on the map (Listing 1)."""
    uv = np.random.default_rng(6).uniform(size=(COUNT, 2))
    expected = np.c_[uv * 2 - 1, np.zeros(COUNT), np.ones(COUNT)]
    hint = "The screen reaches from -1 to 1, the map from 0 to 1; and nothing is to be divided by perspective."
    compared_glsl(answer, "vec4 layout_position(vec2 uv)", {"uv": uv}, expected, hint)
