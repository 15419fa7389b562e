"""The exercises of lesson 5: thickness and translucency."""

from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import NUMBER
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.passes.shadow_map import back_point


def way_inside(answer: Any) -> None:
    """A line: how far a ray runs inside bodies, from the distances at which it enters and leaves them in turn."""
    for crossings in ([1.0, 3.0], [1.0, 1.5, 4.0, 4.25], [0.5, 1.0, 2.0, 4.0, 4.5, 4.75]):
        expected = sum(crossings[1::2]) - sum(crossings[::2])
        got = called(answer, NUMBER, [*crossings])
        if not near(got, expected):
            raise NotYet(
                f"a ray that crosses surfaces at {crossings} runs {expected:g} inside, and yours {got:g}. "
                "Which of the stretches between two crossings are body, and which are air?"
            )


def where_light_entered(answer: Any) -> None:
    """A stage: where the light entered the body, and how far it went inside."""
    hint = "Start at the light and go towards the fragment: how far is it to the surface that the light sees?"
    compared(answer, back_point, fragments(5), hint)


def ratio_in_glsl(answer: Any) -> None:
    """A shader: x^y / d^exponent, with a thickness that does not fall below d_min."""
    draw = np.random.default_rng(5)
    names = ("thickness", "x", "y", "exponent", "d_min")
    columns = draw.uniform([0.01, 0.5, -1, 0.2, 0.1], [2, 4, 2, 1.5, 0.4], (COUNT, 5)).T
    given = dict(zip(names, columns, strict=True))
    d, x, y, exponent, d_min = columns
    hint = "Look at thin parts: what keeps them from shining without limit? Then at the two powers."
    head = "float translucency(float thickness, float x, float y, float exponent, float d_min)"
    compared_glsl(answer, head, given, x**y / np.maximum(d, d_min) ** exponent, hint, within=1e-3)
