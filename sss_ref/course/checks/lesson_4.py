"""The exercises of lesson 4: the blur."""

from collections.abc import Callable

import numpy as np

from sss_ref.course.checks.answers import NotYet, near


def colour_kept(answer: Callable[[np.ndarray], np.ndarray]) -> None:
    """04: tap weights (13, 3) scaled so that a white surface stays white."""
    weights = np.random.default_rng(4).uniform(0.1, 1.0, (13, 3)) * [1.0, 2.0, 3.0]
    got = np.asarray(answer(weights.copy()), float)
    if got.shape != weights.shape:
        raise NotYet(f"expected {weights.shape} weights, got {got.shape}.")
    sums = got.sum(axis=0)
    if not near(sums, np.ones(3)):
        seen = ", ".join(f"{each:.3f}" for each in sums)
        raise NotYet(f"a white surface comes out as ({seen}). Every channel has to keep its own light.")
    if not near(got / got[0], weights / weights[0]):
        raise NotYet("the sums are right, but the taps no longer have their proportions: scale, do not shift.")
