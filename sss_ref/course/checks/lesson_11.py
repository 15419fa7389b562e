"""The exercises of lesson 11: taps and thickness."""

import math
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.kinds import NUMBER


def blurred_twice(answer: Any) -> None:
    """A line: the standard deviation of the Gaussian that is as wide as two after each other."""
    for first, second in [(3.0, 4.0), (1.0, 1.0), (0.5, 2.0)]:
        expected, got = math.hypot(first, second), called(answer, NUMBER, first, second)
        if not near(got, expected):
            too = "wide" if got > expected else "narrow"
            raise NotYet(
                f"after {first:g} and {second:g} your blur of {got:.4g} is too {too}. "
                "Which measure of a Gaussian's width is added up by blurring twice?"
            )


def millimetres_per_offset(answer: Any) -> None:
    """A line: the scale that gives a kernel a root mean square radius in mm."""
    generator = np.random.default_rng(11)
    for total in (1.0, 1.0, 2.5):
        distances, weights = generator.uniform(0.0, 6.0, 13), generator.dirichlet(np.ones(13)) * total
        spread = math.sqrt(float((weights * distances**2).sum()) / total)
        got = called(answer, NUMBER, distances.copy(), weights.copy(), 4.0)
        if not near(got, 4.0 / spread):
            summed = "" if total == 1.0 else f", whose weights sum to {total:g},"
            raise NotYet(
                f"with {got:.4g} mm an offset the light of this kernel{summed} goes {got * spread:.4g} mm and not 4. "
                "How far does it go, counted in offsets? Far taps with little weight count little."
            )


def exponent_between(answer: Any) -> None:
    """A line: the power p of 1/d^p by which T falls between two thicknesses."""
    e = math.exp
    cases = [(1.0, 0.5, 2.0, 0.5 / 2**0.6), (0.5, 0.8, 4.0, 0.1), (1.0, e(-1), 3.0, e(-3)), (2.0, 0.3, 3.0, 0.3)]
    for thin, through_thin, thick, through_thick in cases:
        expected = math.log(through_thin / through_thick) / math.log(thick / thin)
        got = called(answer, NUMBER, thin, through_thin, thick, through_thick)
        if not near(got, expected):
            wrong = through_thin * (thick / thin) ** -got
            raise NotYet(
                f"T is {through_thin:.3g} at {thin:g} mm; falling as d^-{got:.3g} it would be {wrong:.3g} at {thick:g} "
                f"mm, where it is {through_thick:.3g}. On which axes is a power law a straight line?"
            )
