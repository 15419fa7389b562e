"""The float32 between two float64, and the numbers that are no farther from another one than a reach."""

import numpy as np
import pytest

from sss_ref.numerics.inward import float32_within, no_farther, ordered

F = np.float32


def test_float32_between_float64():
    low, high = float32_within(np.array([1.0, 1 + 2.0**-30, 1e39]), np.array([1.0, 1 + 2.0**-29, 2e39]))
    assert low.dtype == high.dtype == np.float32
    assert low[0] == high[0] == 1 and low[1] > high[1] and low[2] > high[2]


def test_the_ends_are_the_last_that_the_reach_lets_in():
    """The last row's lie near 0, where the distance from 1 is rounded and a sum of middle and reach misses them."""
    random = np.random.default_rng(5)
    middle = (random.standard_normal((40, 50)) * 10.0 ** random.integers(-40, 38, (40, 50))).astype(F)
    reach = np.abs(middle.astype(float)) * 10.0 ** random.integers(-12, 3, middle.shape)
    reach[0], reach[1, :9] = 0, np.inf
    middle[-1], reach[-1] = 1, 1
    low, high = no_farther(middle, reach)
    for end, outward in ((low, -np.inf), (high, np.inf)):
        with np.errstate(over="ignore"):
            further = np.nextafter(end, F(outward))
        assert (np.abs(end - middle.astype(float)) <= reach).all()
        assert ((np.abs(further - middle.astype(float)) > reach) | (further == end)).all()
    assert np.isinf(low[1, :9]).all() and (low[0] == middle[0]).all() and (low[-1] < 0).all()


def test_neighbours_are_a_step_apart():
    numbers = np.array([-np.inf, -1.5, -1e-45, 0.0, 1e-45, 2.0, np.finfo(F).max], F)
    with np.errstate(over="ignore"):
        assert (ordered(np.nextafter(numbers, F(np.inf))) - ordered(numbers) == 1).all()
    assert ordered(np.array([-0.0], F)) == ordered(np.array([0.0], F)) == [0]


@pytest.mark.parametrize(
    ("dtype", "middle", "reach", "ends"),
    [
        (np.int32, 5, 2.9, (3, 7)),
        (np.uint8, 1, 2.9, (0, 1)),
        (np.int32, 5, np.inf, (-(2**31), 2**31 - 1)),
    ],
)
def test_whole_numbers_stay_whole_and_in_range(dtype, middle, reach, ends):
    low, high = no_farther(np.array([[middle]], dtype), np.array([[reach]]))
    assert (low.item(), high.item()) == ends and low.dtype == high.dtype == dtype
