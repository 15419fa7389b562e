import math
from pathlib import Path

import mpmath
import numpy as np

from sss_ref.numerics import elementary, make_tables, tables

INTERVALS = range(make_tables.INTERVALS)


def interval_ends(interval):
    """The least and the greatest float32 of an interval of the logarithm."""
    below_one = interval < make_tables.INTERVALS_BELOW_ONE
    step = 2.0**-8 if below_one else 2.0**-7
    start = 1.0 + (interval - make_tables.INTERVALS_BELOW_ONE) * step
    return start, float(np.nextafter(np.float32(start + step), np.float32(0.0)))


def test_the_shipped_tables_are_the_generated_ones():
    assert Path(tables.__file__).read_text(encoding="utf-8") == make_tables.source()


def test_reduction_is_exact_and_finds_the_interval():
    for interval in INTERVALS:
        for mantissa in interval_ends(interval):
            for exponent in (-149, -1, 0, 1, 126):
                found = elementary._reduce(np.float64(mantissa * 2.0**exponent))
                with mpmath.workprec(200):
                    z = mpmath.mpf(mantissa) * mpmath.mpf(tables.RECIPROCAL[interval]) - 1
                assert found == (exponent, interval, z)


def test_arguments_of_the_series_obey_the_error_analysis():
    for interval in INTERVALS:
        for mantissa in interval_ends(interval):
            z = mantissa * tables.RECIPROCAL[interval] - 1.0
            assert abs(z) < 2.0**-7
            if tables.RECIPROCAL[interval] != 1.0:
                assert abs(math.log1p(z)) < 0.54 * abs(math.log(mantissa))
    assert np.abs(tables.LOG2_INTERVAL_HEAD).max() <= 0.5


def test_one_lies_between_two_intervals_without_offset():
    beside_one = [make_tables.INTERVALS_BELOW_ONE - 1, make_tables.INTERVALS_BELOW_ONE]
    assert [i for i in INTERVALS if tables.RECIPROCAL[i] == 1.0] == beside_one
    assert [i for i in INTERVALS if tables.LOG2_INTERVAL_HEAD[i] == 0.0] == beside_one


def test_head_and_tail_hold_the_constant_to_a_hundred_bits():
    with mpmath.workprec(200):
        for j, (head, tail) in enumerate(zip(tables.EXP2_STEP_HEAD, tables.EXP2_STEP_TAIL, strict=True)):
            exact = mpmath.mpf(2) ** (mpmath.mpf(j) / 32)
            assert abs(mpmath.mpf(head) + mpmath.mpf(tail) - exact) <= mpmath.mpf(2) ** -105
