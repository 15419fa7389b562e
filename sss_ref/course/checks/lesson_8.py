"""The exercises of lesson 8: float32."""

from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import WHOLE
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.passes.shadow_map import distance_to_light

APART = 2.0**-21  # relative: four roundings


def ulps_between(answer: Any) -> None:
    """A line: how many steps lead from one float32 to another; both are positive."""
    zero, least, one, two = np.float32(0), np.float32(2.0**-149), np.float32(1), np.float32(2)
    pairs = [(one, one), (np.nextafter(two, one), two), (one, two), (two, np.float32(3)), (np.float32(0.5), two)]
    for a, b in [*pairs, (zero, least), (np.float32(4), np.nextafter(np.float32(4), zero))]:
        expected = abs(int(a.view(np.int32)) - int(b.view(np.int32)))
        got = called(answer, WHOLE, a, b)
        if got != expected:
            raise NotYet(
                f"from {a!s} to {b!s} there are {expected} steps, and you count {got}. "
                "The steps change at every power of two; what does not change is how the bit patterns are ordered."
            )


def same_bits(answer: Any) -> None:
    """A stage: the distance to the light from its components, with every bit of the package's own."""
    hint = "Which two of the three squares does the package add first?"
    compared(answer, distance_to_light, fragments(8), hint, exact=True)


def difference_of_squares_in_glsl(answer: Any) -> None:
    """A shader: a*a - b*b of two numbers that are nearly the same, with hardly an error."""
    draw = np.random.default_rng(8)
    a = draw.uniform(1000, 2000, COUNT).astype(np.float32)
    b = a * (1 + draw.uniform(-1e-5, 1e-5, COUNT).astype(np.float32))
    exact = (a.astype(float) - b) * (a.astype(float) + b)
    hint = "Two large numbers that were rounded are subtracted. Is there a form in which the subtraction comes first?"
    head = "float difference_of_squares(float a, float b)"
    compared_glsl(answer, head, {"a": a, "b": b}, exact, hint, within=APART)
