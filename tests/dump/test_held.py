"""Which numbers a texture holds, by the formats' definitions: codes by their fractions, small floats by their bits."""

from fractions import Fraction

import numpy as np
import pytest

from sss_ref.dump.held import are_held

LARGEST = {"unorm8": 255, "rgb10a2": 1023, "unorm16": 65535, "snorm8": 127, "snorm16": 32767}


def held(storage, *pixels):
    """Of each pixel, a number or its channels, which are held."""
    return at_all(storage, np.array(pixels)).tolist()


def at_all(storage, pixels):
    """The same of an array of pixels (N,) or (N, C)."""
    return are_held(pixels.astype(np.float32).reshape(len(pixels), 1, -1), storage)[:, 0]


@pytest.mark.parametrize(("storage", "largest"), LARGEST.items())
def test_codes_are_held_and_nothing_between_or_beyond(storage, largest):
    codes = np.arange(largest + 1) / largest
    assert at_all(storage, codes).all()
    assert not at_all(storage, codes[:-1] + 0.5 / largest).any()
    assert held(storage, 1 + 1 / largest, -1 - 1 / largest, np.inf, np.nan) == [[False]] * 4
    below = at_all(storage, -codes[1:])
    assert below.all() == below.any() == storage.startswith("snorm")


def test_two_ways_to_round_a_code_lie_within_a_four_millionth():
    """Exactly, in fractions: of each code the float32 nearest to it and the next four."""
    for code in range(1, 256):
        near = np.float32(code / 255)
        values = [near + steps * np.spacing(near) for steps in range(5)]
        apart = [abs(Fraction(float(each)) - Fraction(code, 255)) for each in values]
        assert held("unorm8", *values) == [[each <= Fraction(code, 255) / 2**22] for each in apart]


def decoded(code):
    """IEC 61966-2-1, of a code of 255."""
    return code / 255 / 12.92 if code / 255 <= 0.04045 else ((code / 255 + 0.055) / 1.055) ** 2.4


@pytest.mark.parametrize(("beside", "expected"), [(0, True), (0.44, True), (0.46, False), (0.54, False), (0.56, True)])
def test_srgb_is_held_up_to_nearly_half_a_code_beside(beside, expected):
    assert held("srgb8", *(decoded(code + beside) for code in range(255))) == [[expected]] * 255


def test_srgb_ends_at_0_and_1():
    assert held("srgb8", 1, 1.00001, -0.00001, np.nan) == [[True], [False], [False], [False]]


def test_halves():
    assert held("float16", 1 + 2**-10, 1 + 2**-11, 2**-24, 2**-25) == [[True], [False], [True], [False]]
    assert held("float16", 65504, 65520, -2, np.inf, np.nan) == [[True], [False], [True], [True], [True]]


def test_packed_floats_have_6_6_and_5_bits_of_mantissa_and_no_sign():
    assert held("r11g11b10f", [1 + 2**-6] * 3, [1 + 2**-5] * 3) == [[True, True, False], [True, True, True]]
    assert held("r11g11b10f", [1 + 2**-7] * 3, [1, 0, -1]) == [[False] * 3, [True, True, False]]
    assert held("r11g11b10f", [2**-20] * 3, [2**-19] * 3) == [[True, True, False], [True, True, True]]
    assert held("r11g11b10f", [2**-21] * 3, [np.inf] * 3, [np.nan] * 3) == [[False] * 3, [True] * 3, [True] * 3]
    assert held("r11g11b10f", 1 + 2**-6, 1 + 2**-7) == [[True], [False]]


def test_a_shared_exponent_leaves_nine_bits_below_the_largest():
    """OpenGL ES 3.2, 8.5.2: the exponent reaches down to -15, so that the least is 2^-24, and the largest is 65408."""
    assert held("rgb9e5", [1, 2**-8, 2**-9], [0.75, 2**-9, 2**-10]) == [[True, True, False]] * 2
    assert held("rgb9e5", [2**-24, 2**-25, 0], [65408, 128, 64], [65536, 0, 0]) == [
        [True, False, True],
        [True, True, False],
        [False, True, True],
    ]
    assert held("rgb9e5", [-1, 0, 1], [np.inf, 0, np.nan]) == [[False, True, True], [False, True, False]]
