"""The samples of normalized diffusion: a naive twin in every bit, and the profile they are drawn from."""

import math

import gmpy2
import numpy as np
import pytest
from naive_language import correctly_rounded

from sss_ref.scene.burley_samples import burley_samples
from sss_ref.scene_file.diffusion import Diffusion

CASES = [{}, {"samples": 1}, {"samples": 255, "albedo": [0.2, 0.8, 1.0], "mean_free_path_mm": [1, 5, 0.1]}]


def naive_samples(albedo, mean_free_path, count):
    """d of each channel, places, radii and areas, one number at a time."""
    d = [
        path / (1.85 - a + 7.0 * (abs(a - 0.8) * abs(a - 0.8) * abs(a - 0.8)))
        for a, path in zip(albedo, mean_free_path, strict=True)
    ]
    radii, areas, places = [], [], []
    for i in range(count):
        low, high = 0.0, 1.0
        for _ in range(60):
            e = (low + high) / 2
            low, high = (low, e) if (e * e * e + 3.0 * e) / 4 > 1.0 - (i + 0.5) / count else (e, high)
        e = (low + high) / 2
        radii.append((-3.0 * max(d) * math.log(2)) * float(correctly_rounded(gmpy2.log2, np.float32(e))))
        areas.append(max(d) * radii[-1] / (e * e * e + e))
    for i, radius in enumerate(radii):
        with gmpy2.context(precision=200):
            angle = gmpy2.mpfr(137.50776405003785 * i) * gmpy2.const_pi() / 180
            places.append([float(f(angle)) * (radius / radii[-1]) for f in (gmpy2.cos, gmpy2.sin)])
    return d, places, radii, areas


@pytest.mark.parametrize("case", CASES)
def test_the_naive_samples_in_every_bit(case):
    diffusion = Diffusion(**case)
    found = burley_samples(diffusion)
    d, places, radii, areas = naive_samples(diffusion.albedo, diffusion.mean_free_path_mm, diffusion.samples)
    assert list(found.distance) == d and found.radius.tolist() == radii and found.area.tolist() == areas
    assert found.place.tolist() == places


def test_each_sample_stands_for_as_much_of_the_widest_channels_light():
    found = burley_samples(Diffusion(samples=100))
    d = max(found.distance)
    within = 1 - np.exp(-found.radius / d) / 4 - 3 * np.exp(-found.radius / (3 * d)) / 4
    np.testing.assert_allclose(within, (np.arange(100) + 0.5) / 100, atol=1e-7)


@pytest.mark.parametrize("channel", range(3))
def test_they_integrate_the_profile_of_each_channel(channel):
    """The mean of R/density over the samples is the integral of R over the plane, which is 1."""
    found = burley_samples(Diffusion(samples=255))
    d = found.distance[channel]
    profile = (np.exp(-found.radius / d) + np.exp(-found.radius / (3 * d))) / (d * found.radius)
    assert (profile * found.area).mean() == pytest.approx(1, abs=0.01)


def test_distances_are_those_of_christensen_and_burley():
    """Their fit for a searchlight at A = .8 is l/1.05."""
    assert Diffusion(albedo=[0.8] * 3, mean_free_path_mm=[1, 2, 4]).scatter_distance == pytest.approx(
        [1 / 1.05, 2 / 1.05, 4 / 1.05]
    )
