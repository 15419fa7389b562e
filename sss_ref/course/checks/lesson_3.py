"""The exercises of lesson 3: Phong."""

from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.fragments import COUNT, fragments, units
from sss_ref.course.checks.kinds import DIRECTION
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.language import vec3
from sss_ref.passes.phong import highlight, phong_shading


def mirrored(answer: Any) -> None:
    """A line: the direction in which a mirror with this normal sends the light that comes from `to_light`."""
    generator = np.random.default_rng(3)
    for _ in range(8):
        normal, to_light = (v / np.linalg.norm(v) for v in generator.normal(size=(2, 3)))
        to_light = to_light if normal @ to_light > 0 else -to_light
        got = called(answer, DIRECTION, vec3(*map(np.float32, normal)), vec3(*map(np.float32, to_light)))
        if abs(got @ got - 1) > 1e-4:
            raise NotYet(f"a mirrored direction is as long as the direction itself, 1, and yours is {got @ got:.3f}.")
        if got @ normal < 0:
            raise NotYet("your direction points into the surface. Which way does `reflect` expect the light to run?")
        if not near(got, 2 * (normal @ to_light) * normal - to_light):
            raise NotYet("the angle to the normal is not the same before and after; or it left the plane of the two.")


def matt_surface(answer: Any) -> None:
    """A stage: Phong shading without its highlight."""
    given = fragments(3) | {"specular": np.float32(0)}
    hint = "Two terms are left. Which of them may not become negative where the surface faces away?"
    compared(answer, phong_shading, given, hint)


def highlight_in_glsl(answer: Any) -> None:
    """A shader: the highlight of unit vectors; 0 where the light or its mirror image is behind."""
    normal, to_light, to_eye = units(np.random.default_rng(3), 3 * COUNT).reshape(3, COUNT, 3).astype(np.float32)
    shininess = np.full(COUNT, 8, np.float32)
    vectors: Any = (vec3(*each.T) for each in (normal, to_light, to_eye))
    shine: Any = highlight  # takes arrays, too
    expected = shine(*vectors, shininess)
    given = {"normal": normal, "to_light": to_light, "to_eye": to_eye, "shininess": shininess}
    hint = "Of what is behind the surface there is no highlight; and an even power hides a sign."
    head = "float highlight(vec3 normal, vec3 to_light, vec3 to_eye, float shininess)"
    compared_glsl(answer, head, given, expected, hint, within=1e-3)
