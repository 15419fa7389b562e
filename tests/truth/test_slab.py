"""Slabs against closed forms: nothing scattered, everything kept, scattered once, and a symmetry."""

import math

import numpy as np
import pytest

from sss_ref.truth.photon import ABSORBED, REFLECTED, TRANSMITTED, Volume
from sss_ref.truth.slab import slab

PHOTONS = 100_000
NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)
COSINE, WEIGHT = (NODES + 1) / 2, WEIGHTS / 2


def assert_share(count, expected, photons=PHOTONS):
    """Within four standard errors."""
    assert abs(count / photons - expected) < 4 * math.sqrt(expected * (1 - expected) / photons)


def test_without_scattering_what_is_not_absorbed_comes_through():
    straight = slab(Volume(0.0, 0.7), 1.5, PHOTONS, diffuse=False)
    assert straight.share(REFLECTED) == 0
    assert_share(straight.counts[TRANSMITTED].sum(), math.exp(-0.7 * 1.5))
    from_all_sides = slab(Volume(0.0, 0.7), 1.5, PHOTONS)
    assert_share(from_all_sides.counts[TRANSMITTED].sum(), (2 * WEIGHT * COSINE * np.exp(-1.05 / COSINE)).sum())


@pytest.mark.parametrize("ior", [1.0, 1.4])
@pytest.mark.parametrize("g", [0.0, 0.8])
def test_without_absorption_every_photon_comes_out(ior, g):
    found = slab(Volume(1.3, 0.0, g, ior), 2.0, 5000)
    assert found.counts[ABSORBED].sum() == 0
    assert found.counts[:ABSORBED].sum() == 5000


def test_single_scattering_straight_down():
    """a/2 * integral of m/(1 + m) * (1 - e^(-t(1 + 1/m))), and of m/(1 - m) * (e^-t - e^(-t/m)) on the other side."""
    albedo, depth = 0.6, 1.8
    found = slab(Volume(albedo, 1 - albedo), depth, PHOTONS, diffuse=False)
    back = COSINE / (1 + COSINE) * (1 - np.exp(-depth * (1 + 1 / COSINE)))
    through = COSINE / (1 - COSINE) * (math.exp(-depth) - np.exp(-depth / COSINE))
    assert_share(found.counts[REFLECTED, 1].sum(), albedo / 2 * (WEIGHT * back).sum())
    assert_share(found.counts[TRANSMITTED, 1].sum(), albedo / 2 * (WEIGHT * through).sum())
    assert_share(found.counts[TRANSMITTED, 0].sum(), math.exp(-depth))


def test_a_border_lets_light_out_as_it_lets_it_in():
    """Diffuse light meets both faces alike: what comes through a clear slab is what Fresnel's formulas give, summed."""
    ior, absorption = 1.5, 0.4
    found = slab(Volume(0.0, absorption, 0.0, ior), 1.0, PHOTONS)
    beyond = np.sqrt(1 - (1 - COSINE**2) / ior**2)  # the cosine inside
    across, along = (COSINE - ior * beyond) / (COSINE + ior * beyond), (beyond - ior * COSINE) / (beyond + ior * COSINE)
    returned, kept = (across**2 + along**2) / 2, np.exp(-absorption / beyond)
    entered = 2 * WEIGHT * COSINE * (1 - returned)
    through = (1 - returned) * kept / (1 - (returned * kept) ** 2)
    assert_share(found.counts[TRANSMITTED].sum(), (entered * through).sum() / entered.sum())


def test_the_standard_error_is_that_of_a_share():
    found = slab(Volume(0.5, 0.5), 1.0, 1000)
    share = found.share(TRANSMITTED)
    assert found.share_error(TRANSMITTED) == math.sqrt(share * (1 - share) / 1000)
    assert found.share(TRANSMITTED) + found.share(REFLECTED) + found.share(ABSORBED) == pytest.approx(1, abs=1e-15)
