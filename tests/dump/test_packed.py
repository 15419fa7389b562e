from fractions import Fraction

import numpy as np

from sss_ref.dump.packed import d24s8, r11g11b10


def small_float(bits, mantissa):
    """The value as the formats' definition has it."""
    exponent, fraction = bits >> mantissa, Fraction(bits & (2**mantissa - 1), 2**mantissa)
    if exponent == 31:
        return float("nan") if fraction else float("inf")
    return float(fraction / 2**14 if exponent == 0 else (1 + fraction) * Fraction(2) ** (exponent - 15))


def test_all_floats_of_eleven_bits():
    codes = np.arange(2048, dtype=np.uint32)
    values = r11g11b10((codes | codes[::-1] << 11)[np.newaxis])
    expected = np.float32([small_float(code, 6) for code in range(2048)])
    assert values.dtype == np.float32
    assert np.array_equal(values[0, :, 0], expected, equal_nan=True)
    assert np.array_equal(values[0, :, 1], expected[::-1], equal_nan=True)
    assert expected[1] == 2.0**-20 and np.isinf(expected[1984]) and np.isnan(expected[1985])


def test_all_floats_of_ten_bits():
    codes = np.arange(1024, dtype=np.uint32)
    expected = np.float32([small_float(code, 5) for code in range(1024)])
    assert np.array_equal(r11g11b10((codes << 22)[np.newaxis])[0, :, 2], expected, equal_nan=True)


def test_depth_of_24_bits_is_rounded_once():
    codes = np.random.default_rng(1).integers(0, 2**24, 1000, np.uint32)
    expected = [Fraction(int(code), 2**24 - 1) for code in codes]
    got = d24s8(codes[np.newaxis])[0, :, 0]
    for value, exact in zip(got, expected, strict=True):
        error = abs(Fraction(float(value)) - exact)
        for other in (np.nextafter(value, np.float32(-1)), np.nextafter(value, np.float32(2))):
            assert error <= abs(Fraction(float(other)) - exact)
