"""Errors worked out by hand."""

import numpy as np
import pytest

from sss_ref.yardstick.deviation import Truth

TRUE = np.array([[[1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [0.4, 0.2, 0.0]]])
SEEN = np.array([[[1.1, 1.0, 0.8], [0.15, 0.0, 0.0], [0.4, 0.2, 0.0]]])
EVERYWHERE = {"everywhere": np.ones((1, 3), bool)}


def deviation(seen, error=0.0, **regions):
    truth = Truth(TRUE, np.full(TRUE.shape, error), 1.0)
    found = truth.deviations(seen, regions or EVERYWHERE)
    return found if regions else found["everywhere"]


def test_the_errors_of_three_pixels():
    """0.3/3; 0.15 over a twentieth of white, 3 * 0.05; 0. The truth's light is 3.6, the picture's 3.65."""
    found = deviation(SEEN)
    assert found.pixels == 3
    assert found.mean == pytest.approx((0.1 + 1.0 + 0.0) / 3, rel=1e-12)  # sums of decimal fractions
    assert found.tail == pytest.approx(0.1 + 0.9 * 0.9, rel=1e-12)  # 95 % of the way through 0, 0.1, 1
    assert found.bias == pytest.approx(3.65 / 3.6 - 1, rel=1e-12)
    assert found.rms == pytest.approx(((0.01 + 0.04 + 0.0225) / 9) ** 0.5 / (3.6 / 9), rel=1e-12)


def test_the_noise_of_the_truth_is_taken_off_the_squares():
    square = (0.01 + 0.04 + 0.0225) / 9
    assert deviation(SEEN, 0.05).rms == pytest.approx((square - 0.05**2) ** 0.5 / 0.4, rel=1e-12)
    assert deviation(SEEN, 0.5).rms == 0


def test_the_truth_itself_is_not_off():
    found = deviation(TRUE)
    assert (found.bias, found.rms, found.mean, found.tail, found.color, found.color_tail) == (0, 0, 0, 0, 0, 0)


def test_regions_are_judged_apart():
    found = deviation(SEEN, first=np.array([[True, False, False]]), last=np.array([[False, False, True]]))
    assert found["first"].mean == pytest.approx(0.1, rel=1e-12) and found["last"].mean == 0
    assert found["first"].pixels == 1 and found["first"].color > found["last"].color == 0


def test_a_picture_without_error_is_off_by_the_noise():
    """The mean of |z|, z normal, is sqrt(2/pi): of 30,000 numbers within 1 %."""
    flat = np.full((100, 100, 3), 0.5)
    truth = Truth(flat, flat * 0.1, 1.0)
    found = truth.deviations(truth.as_noisy, {"everywhere": np.ones((100, 100), bool)})["everywhere"]
    assert found.mean == pytest.approx(0.1 * (2 / np.pi) ** 0.5, rel=0.02)
    assert found.rms < 0.02 and abs(found.bias) < 0.005
