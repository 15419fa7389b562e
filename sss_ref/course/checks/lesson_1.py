"""The exercises of lesson 1: light and distance."""

import math
from collections.abc import Callable

import numpy as np

from sss_ref.course.checks.answers import NotYet, near
from sss_ref.language import vec3
from sss_ref.passes.shadow_map import distance_to_light


def distance_of_a_wall(answer: Callable[[float, float], float]) -> None:
    """01: the distance D along a ray at an angle to the axis, of a wall at a depth in front of the light."""
    for depth, angle in [(2.0, 0.0), (2.0, 0.5), (5.0, -0.9), (3.0, 1.2)]:
        point = vec3(*map(np.float32, (depth * math.tan(angle), 0.0, -depth)))
        expected = float(distance_to_light(point, vec3(*np.zeros(3, np.float32))).light_distance)
        got = answer(depth, angle)
        if not near(got, expected):
            too = "near" if got < expected else "far"
            raise NotYet(
                f"at depth {depth:g} and {math.degrees(angle):.0f} degrees off the axis your wall is too {too}: "
                f"{got:.4f}, where the light's distance is {expected:.4f}. Draw the right-angled triangle."
            )
