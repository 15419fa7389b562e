"""The fit against sums over its own density."""

import math

import numpy as np
import pytest

from sss_ref.truth.burley_fit import burley_fit


def test_the_width_is_the_mean_free_path_over_s():
    assert burley_fit(0.8, 2.0).width == pytest.approx(2 / 1.05, rel=1e-15)
    assert burley_fit(0.3, 1.0).width == pytest.approx(1 / (1.55 + 7 * 0.125), rel=1e-15)


def test_the_share_within_a_radius_is_the_integral_of_the_density():
    fit = burley_fit(0.85, 1.0)
    radius = (np.arange(100_000) + 0.5) * 4 / 100_000
    density = (np.exp(-radius / fit.width) + np.exp(-radius / (3 * fit.width))) / (8 * math.pi * fit.width * radius)
    inside = (density * 2 * math.pi * radius).sum() * 4 / 100_000
    assert fit.within(4.0) == pytest.approx(inside, rel=1e-8)  # of the midpoint rule
    assert fit.within(fit.quantile(0.9)) == pytest.approx(0.9, abs=1e-15)


def test_nothing_leaves_within_no_radius_and_all_within_a_wide_one():
    fit = burley_fit(0.8, 2.0)
    assert fit.quantile(0.0) < 1e-50 and fit.within(0.0) == 0
    assert fit.within(fit.quantile(1 - 1e-12)) == pytest.approx(1 - 1e-12, abs=1e-15)
    assert fit.quantile(1.0) < 120 * fit.width  # 3 * 53 ln 2 of them are a rounding of 1
