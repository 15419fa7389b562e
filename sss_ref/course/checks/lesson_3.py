"""The exercises of lesson 3: Phong."""

from collections.abc import Callable

import numpy as np

from sss_ref.course.checks.answers import NotYet, near
from sss_ref.language import vec3


def mirrored(answer: Callable[[vec3, vec3], vec3]) -> None:
    """03: the direction in which a mirror with this normal sends the light that comes from `to_light`."""
    generator = np.random.default_rng(3)
    for _ in range(8):
        normal, to_light = (v / np.linalg.norm(v) for v in generator.normal(size=(2, 3)))
        to_light = to_light if normal @ to_light > 0 else -to_light
        got = np.array([*answer(vec3(*map(np.float32, normal)), vec3(*map(np.float32, to_light)))], float)
        if abs(got @ got - 1) > 1e-4:
            raise NotYet(f"a mirrored direction is as long as the direction itself, 1, and yours is {got @ got:.3f}.")
        if got @ normal < 0:
            raise NotYet("your direction points into the surface. Which way does `reflect` expect the light to run?")
        if not near(got, 2 * (normal @ to_light) * normal - to_light):
            raise NotYet("the angle to the normal is not the same before and after; or it left the plane of the two.")
