"""H against its exact first moment, its published value without absorption, and single scattering."""

import math

import numpy as np
import pytest

from sss_ref.truth.chandrasekhar import diffuse_half_space_reflectance, half_space_reflectance


def h(albedo, cosine):
    return (1 - half_space_reflectance(albedo, cosine)) / math.sqrt(1 - albedo)


@pytest.mark.parametrize("albedo", [0.2, 0.9, 0.9997])
def test_the_integral_of_h_is_exact(albedo):
    """2/a * (1 - sqrt(1 - a)); by 60 other nodes than the package's own."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    integral = sum(w / 2 * h(albedo, (x + 1) / 2) for x, w in zip(nodes, weights, strict=True))
    assert integral == pytest.approx(2 / albedo * (1 - math.sqrt(1 - albedo)), rel=1e-5)  # H is steep at 0


def test_without_absorption_h_of_1_is_the_published_value():
    """2.9078; Chandrasekhar's table stops at four decimals."""
    assert h(1 - 1e-12, 1.0) == pytest.approx(2.9078, abs=6e-5)


def test_little_scattering_is_single_scattering():
    assert half_space_reflectance(1e-6) == pytest.approx(5e-7 * (1 - math.log(2)), rel=1e-4)
    assert half_space_reflectance(0.0) == 0


def test_near_albedo_one_all_comes_back():
    assert 0.99 < half_space_reflectance(1 - 1e-6) < 1
    assert half_space_reflectance(0.99) < diffuse_half_space_reflectance(0.99) < 1


def test_values_of_now():
    """As 64 nodes have them; 100 change the ninth digit where light comes in flat."""
    found = [half_space_reflectance(albedo, cosine) for albedo, cosine in ((0.9, 0.5), (0.3, 1.0), (0.999, 0.1))]
    assert found == pytest.approx([0.5079389069380649, 0.057214350601037856, 0.9607743245157788], rel=1e-12)
    assert diffuse_half_space_reflectance(0.5) == pytest.approx(0.14654438070226872, rel=1e-12)
    assert half_space_reflectance(0.0, 0.5) == diffuse_half_space_reflectance(0.0) == 0
