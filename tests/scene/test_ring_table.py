"""The table of pre-integrated skin: a naive twin in every bit, and what it must be whatever the profile."""

import math

import gmpy2
import numpy as np
import pytest
from naive_language import correctly_rounded

from sss_ref.scene.ring_table import ring_table
from sss_ref.scene_file.diffusion import Diffusion

CASES = [{}, {"profile": [[2, 1, 0.5, 3], [0.1, 0, 1, 1]], "sharpest_curvature": 0.05}]


def turn(function, degrees):
    with gmpy2.context(precision=200):
        return float(function(gmpy2.mpfr(degrees) * gmpy2.const_pi() / 180))


def naive_texel(diffusion, column, row, c):
    """One channel of a texel, one number at a time."""
    cosine = 2.0 * column / 63 - 1.0
    if row == 0:
        return max(cosine, 0.0)
    sine, curvature = math.sqrt(1.0 - cosine * cosine), diffusion.sharpest_curvature * row / 63
    whole = None
    for _, *weights in diffusion.gaussians:
        whole = weights[c] if whole is None else whole + weights[c]
    total = weight_of_all = None
    for step in range(256):
        middle = (step + 0.5) / 256
        x = 180.0 * (middle * middle * middle)
        chord = 2.0 * turn(gmpy2.sin, x / 2) / curvature
        profile = None
        for v, *weights in diffusion.gaussians:
            power = float(correctly_rounded(gmpy2.exp, np.float32(-chord * chord / (2.0 * v))))
            term = power * (weights[c] / whole / v)
            profile = term if profile is None else profile + term
        profile = profile * (middle * middle)
        a, b = turn(gmpy2.cos, x), turn(gmpy2.sin, x)
        light = (max(cosine * a - sine * b, 0.0) + max(cosine * a + sine * b, 0.0)) * profile
        total = light if total is None else total + light
        weight_of_all = profile if weight_of_all is None else weight_of_all + profile
    return total / (weight_of_all * 2.0)


@pytest.mark.parametrize("case", CASES)
def test_the_naive_table_in_every_bit(case):
    diffusion = Diffusion(**case)
    table = ring_table(diffusion)
    for column, row, c in [(0, 0, 0), (63, 0, 1), (0, 1, 0), (31, 1, 2), (32, 17, 0), (20, 40, 1), (63, 63, 0)]:
        assert table[row, column, c] == naive_texel(diffusion, column, row, c)


def test_it_is_lambert_where_the_surface_is_flat_and_evens_out_where_it_is_sharply_bent():
    table = ring_table(Diffusion())
    cosines = np.linspace(-1, 1, 64)
    np.testing.assert_allclose(table[0], np.repeat(np.maximum(cosines, 0)[:, None], 3, axis=1), atol=1e-15)
    assert (np.diff(table, axis=1) >= -1e-9).all()  # the more the light is faced, the brighter
    at_terminator = table[:, 32]
    assert (np.diff(at_terminator, axis=0) > -1e-6).all() and (at_terminator[1:, 0] > at_terminator[1:, 2]).all()
    even = ring_table(Diffusion(profile=[[1e6, 1, 1, 1]], sharpest_curvature=1.0))[-1]
    np.testing.assert_allclose(even, 1 / math.pi, rtol=1e-3)  # the mean of max(cos, 0) round a ring


def test_rings_lose_no_light():
    """Turned once round, a ring gives back what it got, whatever its profile: the mean over angles is 1/pi."""
    table = ring_table(Diffusion())
    fine = np.linspace(0, np.pi, 4001)
    for row in (1, 20, 63):
        for c in range(3):
            values = np.interp(np.cos(fine), np.linspace(-1, 1, 64), table[row, :, c])
            assert values.mean() == pytest.approx(1 / math.pi, abs=2e-3)
