import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sss_ref.dump.loss import DIAGONAL, EXACT, LOSSES, ROUNDING, Loss, loss_of, shared_exponent

F = np.float32


def test_by_name_and_by_itself():
    assert loss_of("float32") == loss_of("int32") == EXACT
    assert loss_of("unorm8") is LOSSES["unorm8"] and loss_of(EXACT) is EXACT


def test_steps_by_hand():
    assert LOSSES["float24"].step(F([0, 1, -3])).tolist() == [2.0**-141, 2.0**-15, 3 * 2.0**-15]
    assert LOSSES["snorm8"].step(F([0, 1, -1])).tolist() == [1 / 127] * 3
    assert EXACT.step(F([0, np.inf, np.nan])).tolist() == [0, 0, 0]


def test_scale_and_offset_move_the_ends_and_the_step():
    assert LOSSES["unorm8"].scaled(2.0, -1.0, 1.0) == Loss(0.0, 2 / 255 + 3 * ROUNDING, -1.0, 1.0)
    assert LOSSES["unorm8"].scaled(-3.0, 0.0, 1.0) == Loss(ROUNDING, 3 / 255, -3.0, 0.0)
    assert LOSSES["float16"].scaled(4.0, 0.0, 9.0) == Loss(
        2.0**-10 + ROUNDING, 4 * 2.0**-24, -4 * 65504, 4 * 65504, 4 * 2.0**-14
    )
    assert LOSSES["float16"].scaled(4.0, 1.0, 9.0) == Loss(
        0.0, 36 * 2.0**-10 + 37 * ROUNDING, 1 - 4 * 65504, 1 + 4 * 65504
    )


@given(
    vector=st.tuples(*[st.floats(-100, 100, width=32)] * 3),
    angles=st.tuples(*[st.floats(0, 6.28)] * 2),
    cut_off=st.booleans(),
)
@settings(max_examples=300, derandomize=True)
def test_a_turned_vector_of_halves_is_within_the_spread_loss(vector, angles, cut_off):
    """Rounded, or cut off as some writers do, then turned: no component is farther off than said."""
    exact = np.array(vector, F).astype(np.float64)
    held = F(vector).astype(np.float16)
    if cut_off:
        held = np.where(np.abs(held.astype(np.float64)) > np.abs(exact), np.nextafter(held, np.float16(0)), held)
    (a, b), (c, d) = np.cos(angles), np.sin(angles)
    turn = np.array([[a, -c, 0], [c, a, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, b, -d], [0, d, b]])
    apart = np.abs(turn @ held.astype(np.float64) - turn @ exact)
    assert (apart <= LOSSES["float16"].spread(float(np.abs(held).max())).least + 1e-12).all()
    assert LOSSES["unorm8"].spread(1.0).least == DIAGONAL * (1 / 255) + ROUNDING


@pytest.mark.parametrize("largest", [1.0, 1.9, 0.3, 300.0])
def test_a_shared_exponent_loses_the_step_of_the_largest(largest):
    step = 2.0 ** (np.floor(np.log2(largest)) + 1 - 9)
    loss = shared_exponent(F([[[largest, 0.001, 0]]]))
    assert step <= loss.least <= 2 * step
    assert (loss.low, loss.high) == (0.0, 511 * 2.0**7)


def test_what_of_a_turned_or_moved_half_may_have_been_flushed():
    assert LOSSES["float16"].spread(0.01).least == DIAGONAL * 2.0**-14 + 0.01 * ROUNDING
    assert LOSSES["float16"].scaled(1.0, 1.0, 0.01).least == 2.0**-14 + 1.01 * ROUNDING
    assert LOSSES["float16"].unclamped().flushed == 2.0**-14


def test_which_storages_are_bytes():
    spans = {name: loss.span_of_bytes for name, loss in LOSSES.items() if loss.span_of_bytes}
    assert spans == {"unorm8": 1.0, "snorm8": 2.0, "srgb8": 1.0}
    assert LOSSES["unorm8"].scaled(-3.0, 0.3, 1.0).span_of_bytes == pytest.approx(3.0)
    assert EXACT.span_of_bytes == 0.0


def test_a_half_is_what_numpy_says_of_it():
    half = np.finfo(np.float16)
    expected = (float(half.eps), float(half.smallest_subnormal), float(half.min), float(half.max))
    loss = LOSSES["float16"]
    assert (loss.relative, loss.least, loss.low, loss.high) == expected
    assert loss.flushed == float(half.smallest_normal)


def test_steps_of_small_floats_and_of_codes():
    """Blue of 11, 11 and 10 bits has 5 of a significand and exponents from -14 to 15: 1.96875 * 2^15 is the largest."""
    assert LOSSES["r11g11b10f"] == Loss(2.0**-5, 2.0 ** (-14 - 5), 0.0, (2 - 2.0**-5) * 2.0**15, 2.0**-14)
    assert LOSSES["float24"] == Loss(2.0**-15, 2.0**-141)
    codes = {"unorm8": 255, "rgb10a2": 1023, "unorm16": 65535, "unorm24": 16777215}
    assert {name: LOSSES[name] for name in codes} == {
        name: Loss(0.0, 1 / most, 0.0, 1.0) for name, most in codes.items()
    }
    signed = {"snorm8": 127, "snorm16": 32767}
    assert {name: LOSSES[name] for name in signed} == {
        name: Loss(0.0, 1 / most, -1.0, 1.0) for name, most in signed.items()
    }


def test_a_step_of_srgb_is_wider_than_any_that_the_formula_has():
    """The widest is at white: 2.4 / 1.055 of 1/255, from code 254 to 255."""
    widest, srgb = 1 - ((254 / 255 + 0.055) / 1.055) ** 2.4, LOSSES["srgb8"]
    assert widest < srgb.least <= 1.5 * widest and (srgb.low, srgb.high) == (0, 1)


def test_the_diagonal_of_a_cube_and_the_step_of_a_float32():
    assert np.linalg.norm([1, 1, 1]) == pytest.approx(DIAGONAL) and float(np.finfo(F).eps) == ROUNDING
