"""Errors worked out by hand."""

import numpy as np
import pytest

from sss_ref.yardstick.color_difference import color_difference
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


def test_each_channel_counts_and_a_dark_truth_is_held_against_white():
    """|.3 - .1| + |.2 - .2| + |.1 - .4| over .7, and over .15 of a white of 4 where there is less."""
    true, seen = np.array([[[0.1, 0.2, 0.4]]]), np.array([[[0.3, 0.2, 0.1]]])
    for white, floor in ((1.0, 0.7), (4.0, 0.7), (8.0, 1.2)):
        found = Truth(true, np.zeros((1, 1, 3)), white).relative(seen)
        assert found == pytest.approx(np.array([[0.5 / max(floor, 0.7)]]), rel=1e-12)


def test_a_black_truth_is_off_by_nothing_but_its_noise():
    black = np.zeros((1, 2, 3))
    found = Truth(black, black, 2.0).deviations(black + 0.1, {"all": np.ones((1, 2), bool)})["all"]
    assert (found.bias, found.rms) == (0, 0) and found.mean == pytest.approx(0.3 / 0.3, rel=1e-12)


def test_colours_are_seen_with_the_exposure_of_the_truth():
    """Twice the light of a white twice as bright looks the same; of two pixels .95 of the way to the farther one."""
    light = np.array([[[0.2, 0.2, 0.2], [0.4, 0.4, 0.4]]])
    seen = light * [[[2.0], [1.0]]]
    one = Truth(light, light * 0, 1.0).deviations(seen, {"all": np.ones((1, 2), bool)})["all"]
    two = Truth(2 * light, light * 0, 2.0).deviations(2 * seen, {"all": np.ones((1, 2), bool)})["all"]
    far = color_difference(seen, light)[0, 0]
    assert one.color == two.color == far / 2 > 0 and one.color_tail == pytest.approx(0.95 * far, rel=1e-12)


def test_colours_are_not_known_without_scikit_image(monkeypatch):
    monkeypatch.setattr("sss_ref.yardstick.deviation.color_difference", lambda one, other: None)
    found = deviation(SEEN)
    assert (found.color, found.color_tail, found.pixels) == (None, None, 3)


def test_the_noise_is_drawn_from_one_seed_once():
    truth = Truth(TRUE, np.full(TRUE.shape, 0.5), 1.0)
    assert np.array_equal(truth.as_noisy, TRUE + 0.5 * np.random.default_rng(0).standard_normal((1, 3, 3)))
