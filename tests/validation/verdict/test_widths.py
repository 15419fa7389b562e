"""Widths of intervals in ULP, by hand."""

import numpy as np
import pytest

from sss_ref.validation.verdict.widths import (
    WIDTH_BOUNDS,
    WIDTH_CLASSES,
    Widths,
    compact,
    in_ulps,
    share_let_pass,
    widths_of,
)

ULP = 2.0**-23  # of 1


def column(*values, kind=np.float32):
    return np.array(values, kind)[:, None]


def test_classes_hold_their_upper_end():
    assert len(WIDTH_BOUNDS) == len(WIDTH_CLASSES) - 1
    widths = [0, 1, 1.5, 8, 9, 64, 65, 1024, 1025, 65536, 65537, np.inf]
    expected, reach = column(*[1.25] * len(widths)), column(*widths, kind=np.float64) * ULP / 2
    assert widths_of(expected, reach).counts == (1, 1, 2, 2, 2, 2, 1, 1)


def test_the_unit_is_that_of_the_largest_component_and_of_the_interval():
    """A normal's x of 0 has the unit of its z; a value of 0 that may be 1 has the unit of 1."""
    normal, reach = np.array([[0, 0, 1.25]], np.float32), np.array([[ULP, 2 * ULP, 0]])
    assert in_ulps(reach, normal, reach).tolist() == [[1, 2, 0]]
    assert in_ulps(column(2.0, kind=np.float64), column(0), column(1.25, kind=np.float64)).tolist() == [[2 / ULP]]
    assert in_ulps(column(3.0, kind=np.float64), column(7, kind=np.int32), column(0.0)).tolist() == [[3]]
    tiny = column(1.0, kind=np.float64) * 2.0**-149
    assert in_ulps(tiny, column(0), tiny).tolist() == [[1]]  # the smallest of all floats


def test_95_of_100_have_at_most_that_width():
    reach = column(*range(100), kind=np.float64) * ULP / 2
    found = widths_of(column(*[1.5] * 100), reach)
    assert found.most == 94 and found.counts[0] == 1
    assert widths_of(column(1, 2), np.zeros((2, 1))) == Widths((2, 0, 0, 0, 0, 0, 0, 0), 0.0)
    assert widths_of(column(1, 1), column(0, np.inf, kind=np.float64)).most == np.inf


@pytest.mark.parametrize(
    ("ulps", "text"), [(0, "0"), (63.7, "64"), (30541, "30.5k"), (3.4e6, "3.4M"), (np.inf, "unbounded")]
)
def test_in_few_letters(ulps, text):
    assert compact(ulps) == text


def test_the_share_let_pass_is_what_intervals_cover_of_the_range_from_0_to_the_largest_number():
    """Of 0 to 4 it is a half around 1, from 0 to 2, and a quarter around 4, of which 3 to 4 counts."""
    assert share_let_pass(column(1, 4), column(1, 1, kind=np.float64)) == (0.5 + 0.25) / 2
    assert share_let_pass(column(1, 4), column(np.inf, 0, kind=np.float64)) == 0.5
    assert share_let_pass(column(0, 0), column(1, 1, kind=np.float64)) == 0
    assert share_let_pass(column(1, 4, kind=np.int32), column(1, 1, kind=np.float64)) == 0


@pytest.mark.parametrize(
    ("ulps", "text"), [(999.4, "999"), (1e3, "1k"), (999999, "1e+03k"), (1e6, "1M"), (0.4, "0"), (12.6, "13")]
)
def test_letters_begin_at_a_thousand_and_a_million(ulps, text):
    assert compact(ulps) == text


@pytest.mark.parametrize(("wide", "most"), [(5, 0.0), (6, 8.0), (100, 8.0)])
def test_five_of_a_hundred_may_be_wider(wide, most):
    reach = column(*[4.0] * wide, *[0.0] * (100 - wide), kind=np.float64) * ULP
    found = widths_of(column(*[1.5] * 100), reach)
    assert found.most == most and found.counts == (100 - wide, 0, wide, 0, 0, 0, 0, 0)


def test_a_pixel_is_wide_in_one_channel_and_exact_in_another():
    found = widths_of(np.float32([[1.5, 1.5], [1.5, 1.5]]), np.array([[ULP, 0], [0, 0]]))
    assert found.counts == (3, 0, 1, 0, 0, 0, 0, 0) and found.most == 2


def test_a_range_begins_at_0_and_channels_without_any_do_not_count():
    assert share_let_pass(column(-4, 4), column(1, 0, kind=np.float64)) == 0.125 / 2
    two = np.float32([[1, 0], [4, 0]])
    assert share_let_pass(two, np.array([[1.0, 9.0], [1.0, 9.0]])) == (0.5 + 0.25) / 2
    assert share_let_pass(column(2, 4), np.zeros((2, 1))) == 0
