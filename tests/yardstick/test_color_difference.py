"""CIEDE2000 of greys, where it is short enough to be worked out by hand."""

import numpy as np
import pytest

from sss_ref.yardstick import color_difference as module
from sss_ref.yardstick.color_difference import color_difference


def gray(linear):
    return np.full((1, 1, 3), linear)


def lightness(code):
    """CIE L* of an sRGB code: 116 * cbrt(Y) - 16."""
    return 116 * (((code / 255 + 0.055) / 1.055) ** 2.4) ** (1 / 3) - 16


def test_two_greys():
    """Without colour only lightness counts: |dL| / (1 + 0.015*m / sqrt(20 + m)), m = (mean L - 50)^2."""
    one, other = lightness(128), lightness(188)
    square = ((one + other) / 2 - 50) ** 2
    expected = (other - one) / (1 + 0.015 * square / (20 + square) ** 0.5)
    found = color_difference(gray(0.2158605), gray(0.5028865))  # the codes 128 and 188
    assert found.shape == (1, 1)
    assert found[0, 0] == pytest.approx(expected, abs=0.01)  # its white point is given in five digits


def test_black_and_white_and_what_is_brighter_than_white():
    assert color_difference(gray(0.0), gray(1.0))[0, 0] == pytest.approx(100, abs=0.01)
    assert color_difference(gray(1.0), gray(7.0))[0, 0] == 0


def test_it_is_left_out_without_its_package(monkeypatch):
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    assert color_difference(gray(0.0), gray(1.0)) is None
