"""The float32 between two float64, where there is one, none, or where float32 ends."""

import numpy as np

from sss_ref.numerics.inward import float32_within


def test_float32_between_float64():
    low, high = float32_within(np.array([1.0, 1 + 2.0**-30, 1e39]), np.array([1.0, 1 + 2.0**-29, 2e39]))
    assert low.dtype == high.dtype == np.float32
    assert low[0] == high[0] == 1 and low[1] > high[1] and low[2] > high[2]
