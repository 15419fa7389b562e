"""IEC 61966-2-1, at its ends, at the knee and on both sides of it."""

import numpy as np
import pytest

from sss_ref.dump.srgb import decoded_around, srgb_decoded, srgb_encoded


def test_known_pairs():
    """A code of 10 of 255 lies on the line, .0392 / 12.92; of 128 on the power, (.557 / 1.055)^2.4."""
    linear = srgb_decoded(np.array([0, 10, 11, 128, 255]) / 255)
    assert linear == pytest.approx([0, 0.0030352698, 0.0033465358, 0.2158605001, 1], abs=1e-10)
    assert srgb_encoded(linear) * 255 == pytest.approx([0, 10, 11, 128, 255], abs=1e-9)


def test_the_knee_belongs_to_the_line():
    assert srgb_encoded(np.array([0.0031308]))[0] == 12.92 * 0.0031308
    assert srgb_decoded(np.array([0.04045]))[0] == 0.04045 / 12.92
    assert srgb_encoded(np.array([0.0031309]))[0] != 12.92 * 0.0031309
    assert srgb_decoded(np.array([0.04046]))[0] != 0.04046 / 12.92


def test_what_is_negative_is_0():
    assert srgb_encoded(np.array([-1.0, -1e-9])).tolist() == srgb_decoded(np.array([-1.0, -1e-9])).tolist() == [0, 0]


def test_a_sampler_may_be_off_by_half_a_code_and_no_lighter_than_white():
    codes = np.array([0, 10, 128, 255])
    around = decoded_around(srgb_decoded(codes / 255))
    low, high = (srgb_encoded(end) * 255 for end in (around.low, around.high))
    assert low == pytest.approx([0, 9.5, 127.5, 254.5], abs=1e-9)
    assert high == pytest.approx([0.5, 10.5, 128.5, 255], abs=1e-9)
