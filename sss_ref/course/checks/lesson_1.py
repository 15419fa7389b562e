"""The exercises of lesson 1: light and distance."""

import math
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.fragments import COUNT, fragments, units
from sss_ref.course.checks.kinds import NUMBER
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.language import vec3
from sss_ref.passes.phong import light_inverse_square
from sss_ref.passes.shadow_map import distance_to_light


def distance_of_a_wall(answer: Any) -> None:
    """A line: the distance D along a ray at an angle to the axis, of a wall at a depth in front of the light."""
    for depth, angle in [(2.0, 0.0), (2.0, 0.5), (5.0, -0.9), (3.0, 1.2)]:
        point = vec3(*map(np.float32, (depth * math.tan(angle), 0.0, -depth)))
        expected = float(distance_to_light(point, vec3(*np.zeros(3, np.float32))).light_distance)
        got = called(answer, NUMBER, depth, angle)
        if not near(got, expected):
            too = "near" if got < expected else "far"
            raise NotYet(
                f"at depth {depth:g} and {math.degrees(angle):.0f} degrees off the axis your wall is too {too}: "
                f"{got:.4f}, where the light's distance is {expected:.4f}. Draw the right-angled triangle."
            )


def light_that_spreads(answer: Any) -> None:
    """A stage: the light that arrives, by the inverse square law."""
    hint = "At twice the distance the light lies on a sphere of how many times the area?"
    compared(answer, light_inverse_square, fragments(1), hint)


def lambert_in_glsl(answer: Any) -> None:
    """A shader: the cosine between a normal and the direction to the light, 0 on the side that faces away."""
    normal, to_light = units(np.random.default_rng(1), 2 * COUNT).reshape(2, COUNT, 3)
    expected = np.maximum((normal * to_light).sum(axis=1), 0)
    hint = "What should a surface get that faces away from the light?"
    given = {"normal": normal, "to_light": to_light}
    compared_glsl(answer, "float lambert(vec3 normal, vec3 to_light)", given, expected, hint)
