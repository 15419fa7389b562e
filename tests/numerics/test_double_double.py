import math
from fractions import Fraction

import gmpy2
import numpy as np
import pytest

from sss_ref.numerics.double_double import dd_add, dd_mul, dd_to_float32, fast_two_sum, split, two_prod, two_sum

FLOAT32 = gmpy2.context(precision=24, emin=-148, emax=128, subnormalize=True)


def float64s(count, seed):
    """Random float64 of either sign and many magnitudes."""
    rng = np.random.default_rng(seed)
    return rng.choice([-1.0, 1.0], count) * np.exp2(rng.uniform(-60.0, 60.0, count))


def double_doubles(count, seed):
    rng = np.random.default_rng(seed + 1000)
    heads = float64s(count, seed)
    return list(zip(heads, heads * rng.uniform(-1.0, 1.0, count) * 2.0**-54, strict=True))


def exact(pair):
    return Fraction(float(pair[0])) + Fraction(float(pair[1]))


@pytest.mark.parametrize("transform", [two_sum, two_prod])
def test_transform_keeps_what_rounding_loses(transform):
    for a, b in zip(float64s(2000, 1), float64s(2000, 2), strict=True):
        rounded, error = transform(a, b)
        operate = Fraction.__add__ if transform is two_sum else Fraction.__mul__
        assert exact((rounded, error)) == operate(Fraction(float(a)), Fraction(float(b)))
        assert rounded == (a + b if transform is two_sum else a * b)


def test_fast_two_sum_is_two_sum_where_the_first_is_greater():
    for a, b in zip(float64s(2000, 3), float64s(2000, 4), strict=True):
        great, small = (a, b) if abs(a) >= abs(b) else (b, a)
        assert fast_two_sum(great, small) == two_sum(a, b)


def test_split_halves_multiply_exactly():
    for a in float64s(2000, 5):
        upper, lower = split(a)
        assert exact((upper, lower)) == Fraction(float(a))
        for half in (upper, lower):
            assert int(math.frexp(half)[0] * 2**53) % 2**27 == 0  # at most 26 bits


@pytest.mark.parametrize(
    ("operation", "exactly", "units"), [(dd_add, Fraction.__add__, 3.01), (dd_mul, Fraction.__mul__, 7.0)]
)
def test_error_stays_below_the_published_bound(operation, exactly, units):
    bound = Fraction(units) / 2**106
    pairs = list(zip(double_doubles(3000, 6), double_doubles(3000, 7), strict=True))
    nearly_opposite = [(a, (-b[0], b[1])) for a, b in pairs for b in [(a[0] * (1.0 + 2.0**-40), a[1] * 0.3)]]
    for a, b in pairs + nearly_opposite:
        result = operation(a, b)
        wanted = exactly(exact(a), exact(b))
        assert abs(exact(result) - wanted) <= bound * abs(wanted)
        assert result[0] + result[1] == result[0]


def neighbourhood(value):
    """Pairs on, and a hair beside, a value and the midpoint above it."""
    midpoint = (float(value) + float(np.nextafter(value, np.float32(np.inf)))) / 2.0
    heads = [float(value), midpoint, math.nextafter(midpoint, math.inf), math.nextafter(midpoint, 0.0)]
    return [(np.float64(h), h * tail) for h in heads for tail in (0.0, 2.0**-53, -(2.0**-54), 2.0**-100, -(2.0**-100))]


def test_rounding_to_float32_is_single():
    rng = np.random.default_rng(8)
    values = np.exp2(rng.uniform(-149.0, 127.9, 500)).astype(np.float32)
    edges = np.array([0.0, 2.0**-149, 2.0**-126, 1.0, 2.0 - 2.0**-23], np.float32)
    for value in np.concatenate([values, -values, edges]):
        for pair in neighbourhood(value):
            with FLOAT32:
                wanted = float(gmpy2.mpfr(gmpy2.mpq(exact(pair))))
            assert dd_to_float32(pair) == wanted


@pytest.mark.parametrize(
    ("steps", "tail", "rounded"), [(1, 1, 2), (1, -1, 0), (1, 0, 0), (3, 0, 4), (3, -1, 2), (3, 1, 4), (2, -1, 2)]
)
def test_on_a_midpoint_the_tail_decides_and_without_one_the_even_neighbour(steps, tail, rounded):
    """In steps of 2^-24 above 1, of which float32 has every other one; a tail is far smaller."""
    pair = np.float64(1 + steps * 2.0**-24), np.float64(tail * 2.0**-80)
    assert dd_to_float32(pair) == 1 + rounded * 2.0**-24
    assert dd_to_float32((-pair[0], -pair[1])) == -1 - rounded * 2.0**-24


@pytest.mark.filterwarnings("ignore:overflow encountered in cast")
def test_rounding_across_the_greatest_float32():
    greatest = float(np.finfo(np.float32).max)
    midpoint = np.float64(2.0**128 - 2.0**103)
    assert dd_to_float32((midpoint, 0.0)) == np.inf
    assert dd_to_float32((midpoint, 2.0**60)) == np.inf
    assert dd_to_float32((midpoint, -(2.0**60))) == greatest
