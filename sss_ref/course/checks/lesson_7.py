"""The exercises of lesson 7: screen or texture."""

import math
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import NUMBER
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.passes.texture_image import image_product


def blur_on_the_body(answer: Any) -> None:
    """A line: the length on a surface that faces the camera which so many pixels span."""
    for pixels, distance, fov_y, height in [(6.0, 4.0, 90.0, 100), (6.0, 8.0, 90.0, 100), (2.0, 4.2, 31.0, 1024)]:
        expected = pixels * 2.0 * distance * math.tan(math.radians(fov_y) / 2) / height
        got = called(answer, NUMBER, pixels, distance, fov_y, height)
        if not near(got, expected):
            raise NotYet(
                f"{pixels:g} of {height} pixels at distance {distance:g} with {fov_y:g} degrees span {expected:.5f} "
                f"scene units, and yours {got:.5f}. How high is the whole picture out there?"
            )


def albedo_after_the_blur(answer: Any) -> None:
    """A stage: a picture of blurred light in which the albedo stays sharp."""
    hint = "Three kinds of light arrive, and all of them are reflected."
    draw = fragments(7)
    compared(answer, image_product, draw | {"gloss": draw["incident_light"]}, hint)


def stranger_in_glsl(answer: Any) -> None:
    """A shader: whether a tap found a point that is further away on the body than its offset explains."""
    draw = np.random.default_rng(7)
    here, there = draw.normal(size=(2, COUNT, 3))
    allowed = draw.uniform(0.5, 4, COUNT)
    expected = np.linalg.norm(here - there, axis=1) > allowed
    given = {"here": here, "there": there, "allowed": allowed}
    hint = "How far apart are the two points, whichever way?"
    compared_glsl(answer, "bool stranger(vec3 here, vec3 there, float allowed)", given, expected, hint)
