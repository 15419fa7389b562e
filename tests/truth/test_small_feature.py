"""Lenses against a sum over points, and kernels against what they must conserve."""

import math

import numpy as np
import pytest

from sss_ref.truth.small_feature import covered, energy_within, separable, strip_shares


@pytest.mark.parametrize("distance", [0.0, 0.4, 1.0, 1.9, 2.6])
@pytest.mark.parametrize(("disc", "circle"), [(1.0, 1.5), (1.5, 1.0)])
def test_a_circle_covers_what_a_sum_over_points_says(distance, disc, circle):
    steps = (np.arange(800) + 0.5) / 400 - 1
    x, y = np.meshgrid(steps * disc, steps * disc)
    inside = x * x + y * y < disc * disc
    share = ((x + distance) ** 2 + y * y < circle * circle)[inside].mean()
    assert covered(np.array([distance]), disc, circle)[0] == pytest.approx(share, abs=2e-3)  # of 800 x 800 points


def test_a_kernel_of_one_tap_leaves_the_disc_where_it_is():
    distances, weights = separable(np.array([0.0]), np.array([1.0]))
    assert energy_within(distances, weights, 2.0, (1.0, 2.0, 3.0)) == pytest.approx([0.25, 1, 1], abs=1e-15)


def test_a_separable_kernel_keeps_its_energy():
    distances, weights = separable(np.array([-1.0, 0.0, 1.0]), np.array([0.25, 0.5, 0.25]))
    assert energy_within(distances, weights, 1.0, (9.0,))[0] == 1
    assert weights[0, 0] == 0.0625 and distances[0, 2] == math.sqrt(2)


def test_a_strip_holds_two_thirds_of_a_ring_of_twice_its_width_and_more():
    found = strip_shares(np.array([1.0, 2.0]), np.array([0.5, 0.5]), np.array([1.0, 2.0]))
    assert found == pytest.approx([0.5 + 0.5 / 3, 1.0], abs=1e-15)
