"""The kernel of the separable blur: a naive twin in every bit, and the integrals it stands for."""

import math
from itertools import pairwise

import gmpy2
import numpy as np
import pytest
from naive_language import correctly_rounded

from sss_ref.scene.projected_kernel import projected_kernel
from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.profiles import PROFILES, SKIN

CASES = [{}, {"taps": 3, "reach_mm": 0.1}, {"taps": 17, "profile": "milk"}, {"profile": [[2, 1, 0.5, 3]], "taps": 5}]


def naive_kernel(rows, reach, taps):
    """Places and weights, one number of float64 at a time."""
    turns = [2.0 * k / (taps - 1) - 1.0 for k in range(taps)]
    places = [t * abs(t) for t in turns]
    between = [(after + before) / 2 for before, after in pairwise(places)]
    ends = [end * reach for end in (places[0], *between, places[-1])]
    weights = [[channel(rows, ends[k], ends[k + 1], c) for c in (1, 2, 3)] for k in range(taps)]
    return places, [[w / ordered(row[c] for row in weights) for c, w in enumerate(each)] for each in weights]


def channel(rows, low, high, c):
    whole = ordered(row[c] for row in rows)
    width = (high - low) / 64
    return ordered(
        ordered(
            row[c] / whole / math.sqrt(row[0]) * gaussian(low + width * (step + 0.5), row[0]) for row in rows
        )
        * width
        for step in range(64)
    )  # fmt: skip


def gaussian(x, variance):
    return float(correctly_rounded(gmpy2.exp, np.float32(-x * x / (2.0 * variance))))


def ordered(terms):
    """Not sum(), which since Python 3.12 is better than float64."""
    first, *rest = terms
    for term in rest:
        first = first + term
    return first


@pytest.mark.parametrize("case", CASES)
def test_the_naive_kernel_in_every_bit(case):
    diffusion = Diffusion(**case)
    place, weight = projected_kernel(diffusion)
    places, weights = naive_kernel(diffusion.gaussians, diffusion.reach_mm, diffusion.taps)
    assert place.tolist() == places and weight.tolist() == weights


@pytest.mark.parametrize("profile", PROFILES)
def test_it_spreads_all_light_as_much_to_either_side(profile):
    place, weight = projected_kernel(Diffusion(profile=profile, taps=33))
    assert (place == -place[::-1]).all() and (np.diff(place) > 0).all() and place[0] == -1 and place[16] == 0
    np.testing.assert_allclose(weight.sum(axis=0), 1, rtol=1e-15)
    np.testing.assert_allclose(weight, weight[::-1], rtol=1e-12)
    assert (weight >= 0).all()


def test_weights_are_the_integrals_of_the_projected_profile():
    place, weight = projected_kernel(Diffusion())
    ends = 8 * np.concatenate([[-1], (place[1:] + place[:-1]) / 2, [1]])
    shares = np.array(SKIN)[:, 1:] / np.array(SKIN)[:, 1:].sum(axis=0)
    parts = [
        [math.erf(high / math.sqrt(2 * v)) - math.erf(low / math.sqrt(2 * v)) for v, *_ in SKIN]
        for low, high in pairwise(ends)
    ]
    exact = np.array(parts) @ shares
    # The midpoint rule is off by at most width^3/24 * 64^-2 times the second derivative of the narrowest, .08 mm.
    np.testing.assert_allclose(weight, exact / exact.sum(axis=0), atol=2e-4)


def test_more_taps_and_a_wider_reach_come_nearer_to_the_variance_of_the_profile():
    place, weight = projected_kernel(Diffusion(taps=255, reach_mm=16))
    variance = (weight * (16 * place[:, None]) ** 2).sum(axis=0)
    expected = [sum(row[0] * row[c] for row in SKIN) / sum(row[c] for row in SKIN) for c in (1, 2, 3)]
    np.testing.assert_allclose(variance, expected, rtol=0.02)
