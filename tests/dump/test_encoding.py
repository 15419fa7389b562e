from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp, mpf

from sss_ref.dump.encoding import decoded, scaled, storage_of
from sss_ref.errors import DumpError


def column(values, kind):
    """One channel, one texel a row."""
    return np.array(values, kind).reshape(-1, 1, 1)


def nearest_float32(exact):
    """The float32 nearest to a fraction, by trying the neighbours of a guess."""
    guess = np.float32(float(exact))
    around = [np.nextafter(guess, np.float32(-1)), guess, np.nextafter(guess, np.float32(2))]
    return min(around, key=lambda value: abs(Fraction(float(value)) - exact))


def shares(top):
    """The float32 nearest to each k / top.

    By float64: no quotient lies as near to the middle of two float32 as float64 is coarse.
    """
    exact = np.arange(top + 1) / top
    nearest = exact.astype(np.float32)
    beyond = np.nextafter(nearest, np.where(exact > nearest, np.float32(2), np.float32(-1)))
    assert (np.abs(exact - (nearest.astype(np.float64) + beyond) / 2)[1:] > 2.0**-50 * exact[1:]).all()
    return nearest


@pytest.mark.parametrize(("storage", "kind", "top"), [("unorm8", "u1", 255), ("unorm16", "u2", 65535)])
def test_every_code_of_unorm_is_rounded_once(storage, kind, top):
    values = decoded(column(np.arange(top + 1), kind), "R", storage, "x").reshape(-1)
    assert values.dtype == np.float32
    assert values.tolist() == shares(top).tolist()
    for code in range(0, top + 1, 85):
        assert values[code] == nearest_float32(Fraction(code, top))


def test_every_half():
    codes = np.arange(65536, dtype=np.uint16)
    values = decoded(codes.view(np.float16).reshape(-1, 1, 1), "R", "float16", "x").reshape(-1)
    assert values.dtype == np.float32
    exponent, fraction = codes >> 10 & 31, codes & 1023
    special = exponent == 31
    assert np.array_equal(np.isnan(values), special & (fraction != 0))
    assert (np.abs(values[special & (fraction == 0)]) == np.inf).all()
    size = np.where(exponent == 0, fraction * 2.0**-24, (1024 + fraction) * 2.0 ** (exponent.astype(float) - 25))
    assert np.abs(values[~special]).tolist() == size[~special].tolist()
    assert np.array_equal(np.signbit(values[~special]), codes[~special] >> 15)


def test_srgb_but_alpha_is_linear():
    values = decoded(np.uint8([[[0, 10, 11, 128], [188, 255, 1, 255]]]), "RGBA", "srgb8", "x")
    with mp.workdps(40):
        low, high = mpf(10) / 255 / mpf("12.92"), ((mpf(188) / 255 + mpf("0.055")) / mpf("1.055")) ** mpf("2.4")
    assert values[0, 0, 1] == np.float32(float(low)) and values[0, 1, 0] == np.float32(float(high))
    assert values[0, 0, 3] == np.float32(128) / np.float32(255) and values[0, 1].tolist()[3] == 1.0
    assert values[0, 0, 0] == 0 and values[0, 1, 1] == 1 and values.dtype == np.float32


def test_largest_unsigned_integer_is_minus_one():
    values = decoded(column([0, 7, 2**31 - 1, 4294967295], "u4"), "R", "uint32", "x")
    assert values.reshape(-1).tolist() == [0, 7, 2**31 - 1, -1] and values.dtype == np.int32
    assert decoded(column([-1, 5], "i4"), "R", "int32", "x").reshape(-1).tolist() == [-1, 5]
    assert decoded(column([255, 1], "u1"), "R", "uint8", "x").reshape(-1).tolist() == [255, 1]


def test_float32_comes_through_in_bits():
    bits = np.uint32([0x7F800001, 0xFF800000, 0x80000000, 1, 0x3F800001]).reshape(-1, 1, 1)
    values = scaled(decoded(bits.view(np.float32), "R", "float32", "x"), 1.0, 0.0)
    assert values.tobytes() == bits.tobytes()


@pytest.mark.parametrize(
    ("storage", "held", "other"),
    [
        ("float16", [0.5, -65504.0, 2.0**-24, np.inf, np.nan], [0.1, 65520.0, 2.0**-25]),
        ("unorm8", [0.0, np.float32(7 / 255), 1.0], [0.5, 1.5, -0.1, np.nan, np.inf]),
        ("unorm16", [0.0, np.float32(7 / 65535), 1.0], [0.25, 2.0]),
        ("unorm8", [np.float32(7) * np.float32(1 / 255)], [7.01 / 255]),  # by the reciprocal, as samplers do it
        ("rgb10a2", [0.0, np.float32(7 / 1023), 1.0], [7 / 255, 1.5]),
        (
            "srgb8",
            [0.0, 0.001194 + ((38 / 255 + 0.055) / 1.055) ** 2.4, 1.0],
            [((38.5 / 255 + 0.055) / 1.055) ** 2.4, 1.1],
        ),
    ],
)
def test_floats_said_to_come_from_fewer_bits_must_be_such(storage, held, other):
    assert np.array_equal(decoded(column(held, "f4"), "R", storage, "x"), column(held, "f4"), equal_nan=True)
    for value in other:
        with pytest.raises(DumpError, match=f"^x: expected values that {storage} can hold, got "):
            decoded(column([value], "f4"), "R", storage, "x")


@pytest.mark.parametrize(
    ("storage", "held", "other"),
    [
        ("r11g11b10f", [[1.5, 65024.0, 2.0**-19], [0.0, np.inf, 1 + 2.0**-5]], [1.0, 1.0, 1 + 2.0**-6]),
        ("rgb9e5", [[1.0, 0.5, 2.0**-8], [65408.0, 0.0, 0.0]], [1.0, 0.5, 2.0**-9]),
    ],
)
@pytest.mark.parametrize("kind", ["f4", "f2"])
def test_floats_that_come_from_packed_formats(storage, held, other, kind):
    held, other = np.array([held], kind), np.array([[other]], kind)
    assert decoded(held, "RGB", storage, "x").tolist() == held.tolist()
    with pytest.raises(DumpError, match=f"^x: expected values that {storage} can hold, got "):
        decoded(other, "RGB", storage, "x")
    with pytest.raises(DumpError):
        decoded(-held, "RGB", storage, "x")


def test_scale_and_offset_are_applied_in_double_precision_and_rounded_once():
    value = np.float32(0.1)
    expected = nearest_float32(Fraction(float(value)) * Fraction(0.3) - Fraction(0.03))
    assert scaled(np.full((1, 1, 1), value), 0.3, -0.03).item() == expected
    in_single = value * np.float32(0.3) - np.float32(0.03)
    assert in_single != expected


def test_integers_are_moved_without_loss():
    assert scaled(np.int32([2**31 - 1, -(2**31)]), 1.0, -1.0).tolist() == [2**31 - 2, -(2**31) - 1]


def test_what_a_storage_may_be_taken_for():
    assert storage_of("unorm8", None, "x") == "unorm8"
    assert storage_of("unorm8", "srgb8", "x") == "srgb8"
    assert storage_of("float32", "float16", "x") == "float16"
    for native, wanted in [
        ("float16", "float32"),
        ("r11g11b10f", "float16"),
        ("int32", "unorm8"),
        ("unorm16", "unorm8"),
    ]:
        with pytest.raises(DumpError, match=f"^x: expected one of .* for a file of {native}, got {wanted}; "):
            storage_of(native, wanted, "x")


@pytest.mark.parametrize(("storage", "kind", "top"), [("snorm8", "i1", 127), ("snorm16", "i2", 32767)])
def test_every_code_of_snorm_and_two_for_minus_one(storage, kind, top):
    values = decoded(column(np.arange(-top - 1, top + 1), kind), "R", storage, "x").reshape(-1)
    positive = shares(top)
    assert values.dtype == np.float32 and values[:2].tolist() == [-1, -1]
    assert values[1:].tolist() == [*-positive[:0:-1], *positive]


def test_floats_that_come_from_snorm():
    codes = np.arange(-127, 128).astype(np.float32)[:, np.newaxis, np.newaxis] / np.float32(127)
    assert np.array_equal(decoded(codes, "R", "snorm8", "x"), codes)
    with pytest.raises(DumpError, match=r"expected values that snorm8 can hold, got 0\.5; "):
        decoded(column([0.5], "f4"), "R", "snorm8", "x")


@pytest.mark.parametrize(("kind", "storage"), [("u2", "uint16"), ("i1", "int8"), ("i2", "int16")])
def test_narrow_integers_keep_their_values(kind, storage):
    ends = [np.iinfo(kind).min, 0, np.iinfo(kind).max]
    values = decoded(column(ends, kind), "R", storage, "x")
    assert values.reshape(-1).tolist() == ends and values.dtype == np.int32
