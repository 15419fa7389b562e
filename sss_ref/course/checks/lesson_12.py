"""The exercises of lesson 12: how far pictures are from the truth."""

import math
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, called, near
from sss_ref.course.checks.kinds import NUMBER


def samples_for(answer: Any) -> None:
    """A line: the number of paths in all for a smaller standard error."""
    for error, samples, wanted in [(0.1, 64, 0.05), (0.1, 64, 0.01), (0.02, 100, 0.02)]:
        expected, got = samples * (error / wanted) ** 2, called(answer, NUMBER, error, samples, wanted)
        if abs(got - expected) > 1 + 1e-5 * expected:  # rounded up to a whole path, or not
            left = error * math.sqrt(samples / got) if got > 0 else math.inf
            raise NotYet(
                f"{samples} paths have the error {error:g}; with your {got:.6g} it is {left:.3g}, not {wanted:g}. "
                "In the formula of the standard error, where does the number of photons stand?"
            )


def error_without_noise(answer: Any) -> None:
    """A line: the relative root mean square error of a picture, the noise of the truth taken off."""
    generator = np.random.default_rng(12)
    right = generator.uniform(0.5, 1.5, 400)
    for off, size in [(0.3, 0.0), (0.3, 0.2), (0.0, 0.2)]:
        error = size * generator.uniform(0.5, 1.5, right.size)
        truth, picture = right + error * generator.choice([-1.0, 1.0], right.size), right + off
        square = np.square(picture - truth).mean() - np.square(error).mean()
        expected = math.sqrt(max(float(square), 0.0)) / float(truth.mean())
        got = called(answer, NUMBER, picture.copy(), truth.copy(), error.copy())
        if not math.isclose(got, expected, rel_tol=1e-5, abs_tol=1e-6):
            raise NotYet(
                f"a picture that is {off:g} too bright, beside a truth of mean 1 with errors near {size:g}, is off by "
                f"{expected:.4g}, and yours says {got:.4g}. Squares add up, roots do not; a difference can be below 0."
            )


def best_factor(answer: Any) -> None:
    """A line: the factor on a picture that makes its mean squared difference to the truth least."""
    generator = np.random.default_rng(13)
    for truth in (generator.uniform(0, 1, 200), generator.exponential(1, 200)):
        picture = truth * 1.4 + generator.normal(0, 0.5, 200)
        expected = float((picture * truth).sum() / np.square(picture).sum())
        got = called(answer, NUMBER, picture.copy(), truth.copy())
        if not near(got, expected):
            yours, least = (float(np.square(k * picture - truth).mean()) for k in (got, expected))
            raise NotYet(
                f"with your factor {got:.4f} the mean squared difference is {yours:.5f}, and with another {least:.5f}. "
                "Write it down as a function of the factor: where is its slope 0?"
            )
