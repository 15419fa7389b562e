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


@pytest.mark.parametrize("unit", [0.01, 1.0, 100.0])
def test_a_share_is_the_same_in_any_unit(unit):
    """Of the unit disc and a circle as large, one apart: 2/3 - sqrt(3)/(2 pi)."""
    found = covered(np.array([0.0, unit, 2.0 * unit, 3.0 * unit]), unit, unit)
    assert found == pytest.approx([1, 2 / 3 - math.sqrt(3) / (2 * math.pi), 0, 0], abs=1e-12)
    assert found[0] == 1 and found[3] == 0


def test_discs_that_nearly_touch_a_circle_are_whole_or_not_there():
    """From inside and from outside, a rounding off: no cosine beyond 1 is without meaning."""
    for disc, circle in np.random.default_rng(1).uniform(0.1, 3, (400, 2)):
        inner, outer = np.nextafter(abs(disc - circle), 9), np.nextafter(disc + circle, 0)
        assert covered(np.array([inner, outer]), disc, circle) == pytest.approx(
            [min(1, (circle / disc) ** 2), 0], abs=1e-6
        )


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
