"""The half-space against exact results, and against what others have published of it."""

import math
from dataclasses import replace

import numpy as np
import pytest

from sss_ref.truth.burley_fit import burley_fit
from sss_ref.truth.chandrasekhar import diffuse_half_space_reflectance, half_space_reflectance
from sss_ref.truth.dipole import dipole, dipole_density, dipole_reflectance
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import REFLECTED, Setup, Volume
from sss_ref.truth.searchlight import RadialProfile, beam, diffusion_length, rings, searchlight
from sss_ref.truth.tally import Walk, nothing_walked

FEW, MANY = 60_000, 4_000_000
DIPOLE_OFF = (-0.008, 0.065, 0.134)  # of skin1, our first walks: reflectance of the dipole against the walk's
BURLEY_NARROW = {0.85: (0.13, 0.23, 0.35), 0.95: (0.24, 0.44, 0.83)}  # at the quantiles .5, .75, .9, rounded there
SUPPORT_HOLDS = {0.85: 0.97, 0.95: 0.93}
ROUNDED = 0.005  # of figures that are published in whole percents


def test_light_that_is_not_scattered_does_not_come_back():
    assert searchlight(Volume(0.0, 1.0), 1000).reflectance == 0


@pytest.mark.parametrize("albedo", [0.2, 0.8, 0.98])
def test_the_reflectance_is_chandrasekhars(albedo):
    volume = Volume(albedo, 1 - albedo)
    profile = searchlight(volume, FEW)
    assert abs(profile.reflectance - half_space_reflectance(albedo)) < 4 * profile.reflectance_error
    diffuse = nothing_walked(Walk(volume, Setup(math.inf, True), ())).more(FEW)
    expected = diffuse_half_space_reflectance(albedo)
    assert abs(diffuse.share(REFLECTED) - expected) < 4 * diffuse.share_error(REFLECTED)


def test_single_scattering_of_a_half_space():
    """a/2 * (1 - ln 2) comes back."""
    counts = searchlight(Volume(0.9, 0.1), FEW).tally.counts
    expected = 0.45 * (1 - math.log(2))
    assert abs(counts[REFLECTED, 1].sum() / FEW - expected) < 4 * math.sqrt(expected * (1 - expected) / FEW)


def test_forward_scattering_is_as_its_reduced_coefficient_where_light_diffuses():
    """Similarity: s with g as s * (1 - g) without; their reflectances are within 3 % of each other at albedo .99."""
    forward, reduced = searchlight(Volume(10.0, 0.05, 0.8), 20_000), searchlight(Volume(2.0, 0.05), 20_000)
    assert forward.reflectance == pytest.approx(reduced.reflectance, rel=0.03)


def test_density_and_quantiles_are_of_the_rings():
    profile = searchlight(Volume(0.8, 0.2), 20_000)
    areas = math.pi * np.diff(np.square(profile.radii))
    inside = (profile.density * areas).sum() * 20_000
    assert inside == pytest.approx(profile.counts[:-1].sum(), rel=1e-12)  # a sum of 1024 roundings
    for share in (0.1, 0.5, 0.9):
        assert profile.within(profile.quantile(share)) == pytest.approx(share, abs=1e-12)  # interpolated and back
    ring = 300
    count = profile.counts[ring] / 20_000
    assert profile.density_error[ring] * areas[ring] == pytest.approx(
        math.sqrt(count * (1 - count) / 20_000), rel=1e-12
    )
    assert rings(8.0, 4) == (0.5, 2.0, 4.5, 8.0)


def assert_known_values(photons):
    """The walk meets each published value within four standard errors and what was rounded away there."""
    for volume, off in zip(volumes("skin1"), DIPOLE_OFF, strict=True):
        profile = searchlight(volume, photons)
        found = dipole_reflectance(dipole(volume)) / profile.reflectance - 1
        error = profile.reflectance_error / profile.reflectance
        assert abs(found - off) < 4 * error + ROUNDED


def burley_against_walk(diffuse_albedo, photons):
    """The fit, and the walk of the medium that its study took for this reflectance (van de Hulst's approximation)."""
    u = (1 - diffuse_albedo) / (1 + 2 * diffuse_albedo)
    return burley_fit(diffuse_albedo, 1.0), searchlight(Volume(1 - u * u, u * u), photons)


def assert_burley(photons, rounded):
    for diffuse_albedo, narrow in BURLEY_NARROW.items():
        fit, profile = burley_against_walk(diffuse_albedo, photons)
        for share, off in zip((0.5, 0.75, 0.9), narrow, strict=True):
            error = profile.quantile_error(share) / fit.quantile(share)
            assert abs(profile.quantile(share) / fit.quantile(share) - 1 - off) < 4 * error + rounded
        support = fit.quantile(0.995)
        held = SUPPORT_HOLDS[diffuse_albedo]
        assert abs(profile.within(support) - held) < 4 * profile.within_error(support) + ROUNDED


def test_known_values_with_few_photons():
    assert_known_values(FEW)
    assert_burley(20_000, 3 * ROUNDED)


@pytest.mark.full
def test_known_values_with_many_photons():
    """The study walked 70,000 photons: its quantiles are known to about 1.5 % each."""
    assert_known_values(MANY)
    assert_burley(MANY // 4, 3 * ROUNDED)


def test_the_dipole_has_too_little_near_the_beam():
    """.17 to .45 of the truth at .1 to .25 mm, over the colours of skin1."""
    found = []
    for volume in volumes("skin1"):
        coarse = Walk(volume, Setup(math.inf, False), (0.1, 0.15, 0.2, 0.25))
        profile = RadialProfile(nothing_walked(coarse).more(FEW))
        middles = (profile.radii[1:] + profile.radii[:-1]) / 2
        found.append((dipole_density(dipole(volume), middles) / profile.density)[1:])
    assert 0.15 < np.min(found) < 0.22
    assert found[0].max() < 0.45 and np.argmax([each[0] for each in found]) == 2


def test_light_fades_over_its_diffusion_length():
    assert diffusion_length(Volume(0.74, 0.032)) == 1 / math.sqrt(3 * 0.032 * (0.032 + 0.74))
    assert diffusion_length(Volume(7.4, 0.032, 0.9)) == pytest.approx(diffusion_length(Volume(0.74, 0.032)), rel=1e-15)
    assert diffusion_length(Volume(1.0, 0.0)) == math.inf


@pytest.fixture
def known():
    """100 photons, of which 10, 20 and 30 left within 1, 2 and 4 mm, and 10 beyond."""
    found = nothing_walked(Walk(Volume(1.0, 1.0), Setup(math.inf, False), (1.0, 2.0, 4.0)))
    found.counts[REFLECTED] = [[0, 0, 0, 0], [4, 20, 0, 10], [6, 0, 30, 0]]
    return RadialProfile(replace(found, photons=100))


def test_what_leaves_by_its_distance(known):
    assert (known.radii.tolist(), known.counts.tolist()) == ([0, 1, 2, 4], [10, 20, 30, 10])
    assert (known.reflectance, known.reflectance_error) == (0.7, math.sqrt(0.7 * (1 - 0.7) / 100))
    assert known.density == pytest.approx(np.array([10, 20 / 3, 30 / 12]) / 100 / math.pi, rel=1e-12)
    share = np.array([0.1, 0.2, 0.3])
    assert known.density_error == pytest.approx(
        np.sqrt(share * (1 - share) / 100) / (math.pi * np.array([1, 3, 12])), rel=1e-12
    )


def test_within_a_ring_it_is_spread_evenly(known):
    """Over its area: halfway through the second ring is sqrt(2.5)."""
    within = {0.0: 0, 0.5: 2.5, 1.0: 10, 2.5**0.5: 20, 2.0: 30, 4.0: 60, 9.0: 60}
    assert [known.within(radius) for radius in within] == pytest.approx([each / 70 for each in within.values()])
    quantiles = {2.5 / 70: 0.5, 20 / 70: 2.5**0.5, 45 / 70: 10**0.5, 1.0: 4.0}
    assert [known.quantile(share) for share in quantiles] == pytest.approx([*quantiles.values()], rel=1e-12)


def test_errors_of_shares_and_radii_are_of_the_photons_that_left(known):
    assert known.within_error(2.0) == pytest.approx(math.sqrt(3 / 7 * 4 / 7 / 70), rel=1e-12)
    step = math.sqrt(2 / 7 * 5 / 7 / 70)  # 5.4 % of the light, 15/70 * 3 mm^2 for every fifth of it
    squares = [2.5 + sign * step * 70 / 20 * 3 for sign in (1, -1)]
    assert squares[0] < 4 and squares[1] > 1
    expected = (math.sqrt(squares[0]) - math.sqrt(squares[1])) / 2
    assert known.quantile_error(2 / 7) == pytest.approx(expected, rel=1e-12)


def test_a_beam_is_walked_as_far_as_light_goes():
    """1024 rings to twelve diffusion lengths, here 2/3 mm."""
    volume = Volume(1.0, 0.5)
    walk = beam(volume)
    assert (walk.volume, walk.setup, walk.seed) == (volume, Setup(math.inf, False), 0)
    assert len(walk.radii) == 1024 and walk.radii[-1] == pytest.approx(8, rel=1e-12)
    assert walk.radii[:2] == pytest.approx([8 / 1024**2, 32 / 1024**2], rel=1e-12)
    assert beam(volume, 3, diffuse=True) == Walk(volume, Setup(math.inf, True), walk.radii, 3)
    found = searchlight(volume, 30, seed=2)
    assert (found.tally.of, found.tally.photons) == (beam(volume, 2), 30)
