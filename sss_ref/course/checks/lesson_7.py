"""The exercises of lesson 7: screen or texture."""

import math
from collections.abc import Callable

from sss_ref.course.checks.answers import NotYet, near


def blur_on_the_body(answer: Callable[[float, float, float, int], float]) -> None:
    """07: the length on a surface that faces the camera which so many pixels span."""
    for pixels, distance, fov_y, height in [(6.0, 4.0, 90.0, 100), (6.0, 8.0, 90.0, 100), (2.0, 4.2, 31.0, 1024)]:
        expected = pixels * 2.0 * distance * math.tan(math.radians(fov_y) / 2) / height
        got = answer(pixels, distance, fov_y, height)
        if not near(got, expected):
            raise NotYet(
                f"{pixels:g} of {height} pixels at distance {distance:g} with {fov_y:g} degrees span {expected:.5f} "
                f"scene units, and yours {got:.5f}. How high is the whole picture out there?"
            )
