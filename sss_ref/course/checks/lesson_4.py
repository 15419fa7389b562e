"""The exercises of lesson 4: the blur."""

from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.fragments import COUNT, fragments
from sss_ref.course.checks.kinds import array_of
from sss_ref.course.checks.written_shaders import compared_glsl
from sss_ref.course.checks.written_stages import compared
from sss_ref.passes.composite import over_background


def colour_kept(answer: Any) -> None:
    """A line: tap weights (13, 3) scaled so that a white surface stays white."""
    weights = np.random.default_rng(4).uniform(0.1, 1.0, (13, 3)) * [1.0, 2.0, 3.0]
    got = called(answer, array_of(13, 3), weights.copy())
    sums = got.sum(axis=0)
    if not near(sums, np.ones(3)):
        seen = ", ".join(f"{each:.3f}" for each in sums)
        raise NotYet(f"a white surface comes out as ({seen}). Every channel has to keep its own light.")
    if not near(got / got[0], weights / weights[0]):
        raise NotYet("the sums are right, but the taps no longer have their proportions: scale, do not shift.")


def stencilled(answer: Any) -> None:
    """A stage: the blurred model before its background."""
    hint = "Which of the two does a pixel show that the model covers, and which one beside it?"
    compared(answer, over_background, fragments(4), hint)


def weight_given_back_in_glsl(answer: Any) -> None:
    """A shader: the light of the taps on the model, as if those beside it had found as much."""
    draw = np.random.default_rng(4)
    all_weights = draw.uniform(0.5, 1.5, (COUNT, 3))
    kept, total = draw.uniform(0.1, 1, (2, COUNT, 3)) * all_weights
    given = {"total": total, "kept": kept, "all_weights": all_weights}
    hint = "A white surface has to stay white: what is `total` there, if only the weights `kept` have found it?"
    head = "vec3 renormalized(vec3 total, vec3 kept, vec3 all_weights)"
    compared_glsl(answer, head, given, total * all_weights / kept, hint)
