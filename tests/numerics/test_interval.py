"""Intervals enclose whatever a processor within its bounds may give, and are no wider than that asks for."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sss_ref.numerics import elementary, interval
from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.directed import downward, nearest, two_sum, ulp, upward
from sss_ref.numerics.ieee import Ieee
from sss_ref.numerics.interval import Interval, point
from sss_ref.numerics.outward import lowered, raised

F = np.float32
VULKAN = Bounded()
RELAXED = Bounded(relative=1e-5)
floats = st.floats(-(2.0**60), 2.0**60, width=32).filter(lambda x: x == 0 or abs(x) > 2.0**-60)
positive = st.floats(2.0**-60, 2.0**60, width=32)
unit = st.floats(0, 1, width=32).filter(lambda x: x == 0 or x > 2.0**-60)
intervals = st.tuples(floats, floats).map(sorted)
shares = st.floats(0, 1)


def scalar(x):
    return point(np.float64(x))


def of(ends):
    return Interval(np.float64(ends[0]), np.float64(ends[1]))


def inside(ends, share):
    """A float32 of the interval."""
    return float(np.clip(F(ends[0] + (ends[1] - ends[0]) * share), *ends))


def neighbours(exact):
    """The float32 on both sides of an exact fraction; twice itself if it is one."""
    near = F(float(exact))
    if Fraction(float(near)) == exact:
        return float(near), float(near)
    other = np.nextafter(near, F(-np.inf) if Fraction(float(near)) > exact else F(np.inf))
    return tuple(sorted((float(near), float(other))))


def ends_of(a):
    return float(a.low), float(a.high)


@given(floats, floats)
@settings(max_examples=300)
def test_sums_and_products_of_points_give_both_neighbours_and_nothing_else(x, y):
    assert ends_of(VULKAN.add(scalar(x), scalar(y))) == neighbours(Fraction(x) + Fraction(y))
    assert ends_of(VULKAN.multiply(scalar(x), scalar(y))) == neighbours(Fraction(x) * Fraction(y))


def test_a_sum_knows_what_float64_has_lost():
    assert ends_of(VULKAN.add(scalar(1), scalar(2.0**-60))) == (1.0, 1.0 + 2.0**-23)
    assert ends_of(VULKAN.add(scalar(1), scalar(-(2.0**-60)))) == (1.0 - 2.0**-24, 1.0)
    assert ends_of(VULKAN.add(scalar(-1), scalar(2.0**-60))) == (-1.0, -1.0 + 2.0**-24)
    assert two_sum(1.0, 2.0**-60) == (1.0, 2.0**-60)


@pytest.mark.parametrize(
    ("x", "error", "below", "above"),
    [
        (1 + 2.0**-52, -(2.0**-60), 1, 1 + 2.0**-23),  # a little less than what float64 has next to 1
        (1 - 2.0**-53, 2.0**-60, 1 - 2.0**-24, 1),
        (1 + 2.0**-52, 2.0**-60, 1, 1 + 2.0**-23),
        (1 - 2.0**-53, -(2.0**-60), 1 - 2.0**-24, 1),
        (1, -(2.0**-60), 1 - 2.0**-24, 1),
        (1, 2.0**-60, 1, 1 + 2.0**-23),
        (1, 0.0, 1, 1),
        (2.0**-149, 0.0, 2.0**-149, 2.0**-149),
        (0, 0.0, 0, 0),
    ],
)
def test_directed_rounding_of_what_float64_has_lost_in_part(x, error, below, above):
    for sign in (1, -1):
        wanted = sorted((sign * below, sign * above))
        one, lost = np.float64(sign * x), np.float64(sign * error)
        assert [float(downward(one, lost)), float(upward(one, lost))] == wanted
        assert [float(lowered(one, lost)), float(raised(one, lost))] == wanted


@given(floats, floats)
@settings(max_examples=300)
def test_directed_rounding_against_fractions(x, y):
    exact = float(np.float64(x) * np.float64(y))  # exact: 48 bits
    assert (float(downward(exact)), float(upward(exact))) == neighbours(Fraction(exact))
    assert float(nearest(exact)) == float(F(exact))


@pytest.mark.parametrize(
    ("x", "unit"), [(1.0, 2.0**-23), (1.9999, 2.0**-23), (2.0, 2.0**-22), (-0.75, 2.0**-24), (0, 0)]
)
def test_ulp(x, unit):
    assert float(ulp(np.float64(x))) == unit


@given(intervals, intervals, shares, shares)
@settings(max_examples=300)
def test_results_of_any_values_lie_inside(a, b, s, t):
    x, y = inside(a, s), inside(b, t)
    for arithmetic in (VULKAN, RELAXED, Ieee()):
        for operation, result in [
            (arithmetic.add, F(x) + F(y)),
            (arithmetic.multiply, F(x) * F(y)),
            (interval.minimum, min(x, y)),
            (interval.maximum, max(x, y)),
        ]:
            got = operation(of(a), of(b))
            assert got.low <= result <= got.high
    low, high = ends_of(interval.square(of(a)))
    assert low <= x * x <= high and low >= 0


@given(intervals, positive, shares, st.floats(-2.5, 2.5))
@settings(max_examples=300)
def test_quotients_within_two_and_a_half_ulp(a, y, s, off):
    x = inside(a, s)
    with np.errstate(all="ignore"):
        got = VULKAN.divide(of(a), scalar(y))
    exact = Fraction(x) / Fraction(y)
    assert (
        Fraction(float(got.low)) <= exact + Fraction(off) * Fraction(float(ulp(np.float64(exact)))) <= float(got.high)
    )


def test_a_quotient_by_what_may_be_zero_or_out_of_range_is_anything():
    for low, high in [(-1, 1), (0, 1), (0, 0), (2.0**-127, 1), (1, 2.0**127)]:
        with np.errstate(all="ignore"):
            assert ends_of(VULKAN.divide(scalar(1), of((low, high)))) == (-np.inf, np.inf)


@pytest.mark.parametrize("y", [2.0**-126, -(2.0**-126), 2.0**126, -(2.0**126)])
def test_a_quotient_by_the_least_and_the_largest_denominator_is_defined(y):
    low, high = ends_of(VULKAN.divide(scalar(1), scalar(y)))
    assert -np.inf < low <= 1 / y <= high < np.inf


PRECISE = {
    "exp": (VULKAN.exp, mpmath.exp, lambda x: 3 + 2 * abs(x)),
    "exp2": (VULKAN.exp2, lambda x: mpmath.power(2, x), lambda x: 3 + 2 * abs(x)),
    "inversesqrt": (VULKAN.inversesqrt, lambda x: 1 / mpmath.sqrt(x), lambda x: 2),
}


@pytest.mark.parametrize("name", PRECISE)
@given(x=st.floats(2.0**-20, 60, width=32), off=st.floats(-1, 1))
@settings(max_examples=150)
def test_functions_within_their_bounds(name, x, off):
    operation, exact, bound = PRECISE[name]
    with mpmath.workdps(40):
        value = exact(mpmath.mpf(x))
        at = value + off * bound(x) * float(ulp(np.float64(float(value))))
        got = operation(scalar(x))
        assert got.low <= at <= got.high
        assert got.high - got.low <= (4 * bound(x) + 4) * float(ulp(np.float64(float(value))))


def test_functions_err_by_their_bounds_and_what_rounds_outward():
    """At a power of 2, below which float32 is twice as dense: 3 + 2*2 ULP of 4, 3 of 4, 3 of 1."""
    assert ends_of(VULKAN.exp2(scalar(2))) == (4 - 15 * 2.0**-22, 4 + 8 * 2.0**-21)
    assert ends_of(VULKAN.log2(scalar(16))) == (4 - 7 * 2.0**-22, 4 + 4 * 2.0**-21)
    assert ends_of(VULKAN.exp(scalar(0))) == (1 - 7 * 2.0**-24, 1 + 4 * 2.0**-23)


def off_by(exact, ulps):
    """A number that many ULP away."""
    return exact + ulps * float(ulp(np.float64(float(exact))))


@given(x=st.floats(2.0**-20, 2.0**20, width=32), off=st.tuples(st.floats(-2, 2), st.floats(-2.5, 2.5)))
@example(x=1.0, off=(-2.0, 2.5))
@example(x=3.9999, off=(2.0, -2.5))
@settings(max_examples=300)
def test_sqrt_errs_no_more_than_its_two_operations(x, off):
    with mpmath.workdps(40):
        value = mpmath.sqrt(mpmath.mpf(x))
        got = VULKAN.sqrt(scalar(x))
        assert got.low <= off_by(1 / off_by(1 / value, off[0]), off[1]) <= got.high
        unit = float(ulp(np.float64(float(value))))
        assert got.high - got.low <= 20 * unit  # 15, and more where an ULP may be the next larger one
        exact = Bounded(sqrt_ulp=0.5).sqrt(scalar(x))
        assert exact.low <= value <= exact.high <= exact.low + 4 * unit


def test_sqrt_errs_no_more_than_its_own_bound():
    """Where the quotient may err by more: the root 1 by 6.5 ULP, and outward to float32, half an ULP apart below 1."""
    for looser in (Bounded(divide_ulp=64), Bounded(inversesqrt_ulp=64)):
        assert ends_of(looser.sqrt(scalar(1))) == (1 - 14 * 2.0**-24, 1 + 7 * 2.0**-23)


@given(x=st.one_of(st.floats(2.0**-20, 2.0**20, width=32), st.floats(0.46875, 2.125, width=32)), off=st.floats(-1, 1))
@settings(max_examples=300)
def test_log2_within_its_bounds(x, off):
    with mpmath.workdps(40):
        value = mpmath.log(x, 2)
        bound = 2.0**-21 if 0.5 <= x <= 2 else 3 * float(ulp(np.float64(float(value))))
        got = VULKAN.log2(scalar(x))
        assert got.low <= value + off * bound <= got.high


@given(st.floats(2.0**-10, 4, width=32), st.floats(-4, 40, width=32))
@settings(max_examples=200)
def test_pow_holds_the_rounded_power_and_the_composed_one(x, y):
    got = VULKAN.pow(scalar(x), scalar(y))
    with np.errstate(all="ignore"):
        composed = np.exp2(F(y) * np.log2(F(x)))
    assert got.low <= elementary.pow_array(F(x), F(y)) <= got.high
    assert got.low <= composed <= got.high


def test_powers_of_zero_and_of_less():
    with np.errstate(all="ignore"):
        assert ends_of(VULKAN.pow(scalar(0), scalar(0.6))) == (0, 0)
        low, high = ends_of(VULKAN.pow(of((0, 0.5)), scalar(2)))
        assert low == 0 and 0.25 <= high <= 0.250001
        for x, y in [(0, 0), (0, -1), (-1, 2)]:
            assert ends_of(VULKAN.pow(scalar(x), scalar(y))) == (-np.inf, np.inf)


def rounded(x, up):
    """A directed float32 rounding of an exact fraction."""
    return Fraction(neighbours(x)[up])


def sums(terms, bits):
    """The sum of exact or rounded products in each order, with every rounding directed by `bits`."""
    for order in [(0, 1, 2), (0, 2, 1), (1, 2, 0)]:
        a, b, c = (terms[k] for k in order)
        yield rounded(rounded(a + b, bits & 1) + c, bits >> 1 & 1)


vectors = st.tuples(floats, floats, floats)


@given(vectors, vectors, st.integers(0, 31))
@settings(max_examples=200)
def test_dot_in_any_order_fused_or_not(a, b, bits):
    got = VULKAN.dot(list(map(scalar, a)), list(map(scalar, b)))
    exact = [Fraction(x) * Fraction(y) for x, y in zip(a, b, strict=True)]
    for terms in (exact, [rounded(term, bits >> 2 + k & 1) for k, term in enumerate(exact)]):
        assert all(Fraction(float(got.low)) <= value <= Fraction(float(got.high)) for value in sums(terms, bits))


def test_a_sum_of_squares_is_not_negative_and_a_sum_of_zeros_is_zero():
    v = [Interval(np.float64(-1e-3), np.float64(1e-3))] * 3
    assert VULKAN.dot(v, v).low == 0
    assert ends_of(VULKAN.dot([scalar(0)] * 3, [scalar(5)] * 3)) == (0, 0)


@given(vectors.filter(lambda v: any(v)))
@settings(max_examples=200)
def test_normalize_by_division_and_by_the_inverse_root(v):
    components = list(map(scalar, v))
    x, y, z = map(F, v)
    squares = (x * x + y * y) + z * z
    got = VULKAN.normalize(components)
    for component, a in zip(v, got, strict=True):
        assert a.low <= F(component) / np.sqrt(squares) <= a.high
        assert a.low <= F(component) * (F(1) / np.sqrt(squares)) <= a.high
        if squares > 2.0**-90:  # far from where squares become 0
            assert a.high - a.low <= 50 * ulp(np.float64(component) / np.sqrt(np.float64(squares)))


def either_neighbour(exact, off):
    """The float32 numbers beside those of float64, which for sums and products errs far less than float32."""
    return np.where(off > 0, upward(exact), downward(exact))


def within_ulps(exact, ulps):
    """The float32 numbers farthest off that are so by no more than these ULP, in their direction."""
    off = exact + ulps * ulp(exact)
    return np.where(ulps > 0, downward(off), upward(off))


def dot_off(a, b, off):
    """Sums of three products, each operation rounded to the neighbour on the given side."""
    x, y, z = (either_neighbour(p * q, off) for p, q in zip(a, b, strict=True))
    return either_neighbour(either_neighbour(x + y, off) + z, off)


def unit_vectors(v, shorter, off):
    """Vectors made unit in both ways; the length errs to one side as far as it may, each component to its own."""
    inverse = within_ulps(1 / np.sqrt(dot_off(v, v, shorter)), -2 * shorter)
    length = within_ulps(1 / inverse, 2.5 * shorter)
    yield [within_ulps(x / length, 2.5 * each) for x, each in zip(v, off, strict=True)]
    yield [either_neighbour(x * inverse, each) for x, each in zip(v, off, strict=True)]


def boxes(rng, count):
    """Vectors of intervals, half of them points, and a float32 vector in each."""
    low, share = rng.uniform(-4, 4, (3, count)).astype(F), rng.random((3, count))
    high = low + (rng.random((3, count)) * (np.arange(count) % 2)).astype(F)
    at = np.clip((low + (high - low) * share).astype(F), low, high)
    return [Interval(*map(np.float64, ends)) for ends in zip(low, high, strict=True)], list(at.astype(np.float64))


SIDES = [(np.float64(a), np.float64(b)) for a in (-1, 1) for b in (-1, 1)]


@pytest.mark.parametrize(("shorter", "less"), SIDES)
def test_unit_vectors_and_their_dots_hold_all_that_either_way_may_give(shorter, less):
    rng = np.random.default_rng(2)
    (box, v), (other, w) = boxes(rng, 5000), boxes(rng, 5000)
    with np.errstate(all="ignore"):
        a, b = VULKAN.normalize(box), VULKAN.normalize(other)
        mixed, turned = VULKAN.dot(a, other), VULKAN.dot(other, [interval.negated(x) for x in a])
        both = VULKAN.dot(a, b)
    for x in unit_vectors(v, shorter, [less * np.sign(each) for each in w]):
        assert all(((each.low <= value) & (value <= each.high)).all() for each, value in zip(a, x, strict=True))
        value = dot_off(x, w, less)
        assert ((mixed.low <= value) & (value <= mixed.high)).all()
        assert ((turned.low <= -value) & (-value <= turned.high)).all()
        for y in unit_vectors(w, shorter, [less * np.sign(each) for each in v]):
            value = dot_off(x, y, less)
            assert ((both.low <= value) & (value <= both.high)).all()


@pytest.mark.parametrize("shorter", [np.float64(-1), np.float64(1)])
def test_a_component_of_a_unit_vector_may_be_off_as_far_as_its_interval_reaches(shorter):
    """Some correct processor comes within a few ULP of the ends, so they could not be much nearer."""
    _, v = boxes(np.random.default_rng(3), 5000)
    got = VULKAN.normalize(list(map(point, v)))
    divided, _ = unit_vectors(v, shorter, [-shorter * np.sign(x) for x in v])
    for a, value in zip(got, divided, strict=True):
        end = np.where(shorter * np.sign(value) > 0, a.low, a.high)
        assert (np.abs(value - end) <= 5 * ulp(value)).mean() > 0.95


def test_a_sum_of_squares_errs_and_with_it_the_length():
    v = [float(F(1.0001))] * 3
    factor = Bounded(inversesqrt_ulp=0, sqrt_ulp=0).normalize(list(map(scalar, v)))[0].factor
    for off in (-1.0, 1.0):
        assert factor.low <= np.sqrt(3 * v[0] ** 2 / dot_off(v, v, off)) <= factor.high
    assert factor.high - factor.low < 5 * 2.0**-23


def test_what_the_length_errs_hardly_changes_a_dot_near_zero():
    unit, across = VULKAN.normalize(list(map(scalar, (1.1, 2.3, 0.7)))), list(map(scalar, (2.3, -1.1, 0.001)))
    together, each = VULKAN.dot(unit, across), VULKAN.dot([Interval(x.low, x.high) for x in unit], across)
    assert together.high - together.low < 0.6 * (each.high - each.low)


def test_a_component_of_a_unit_vector_is_as_wide_as_the_box_makes_it():
    box, _ = boxes(np.random.default_rng(4), 2000)
    with np.errstate(all="ignore"):
        unit = VULKAN.normalize(box)
    nearest_to_zero = [np.clip(0, x.low, x.high) for x in box]
    ends = [[x.low, x.high, zero] for x, zero in zip(box, nearest_to_zero, strict=True)]
    corners = np.array([[x, y, z] for x in ends[0] for y in ends[1] for z in ends[2]])  # the extremes are among them
    lengths = np.sqrt((corners**2).sum(axis=1, keepdims=True))
    exact, far = corners / lengths, lengths.min(axis=0)[0] > 2.0**-4
    rounding = 40 * 2.0**-24 * (lengths.max(axis=0) / lengths.min(axis=0))[0] ** 2
    for got, low, high in zip(unit, exact.min(axis=0), exact.max(axis=0), strict=True):
        assert ((got.low <= low) & (high <= got.high))[far].all() and far.mean() > 0.9
        assert ((low <= got.low + rounding) & (got.high - rounding <= high))[far].all()


def test_the_vector_zero_made_unit_is_zero():
    with np.errstate(all="ignore"):
        assert [ends_of(x) for x in VULKAN.normalize([scalar(0)] * 3)] == [(0, 0)] * 3


def test_a_component_of_a_unit_vector_errs_by_as_much_however_short_its_length_comes_out():
    """The length may err by an eighth, so a component's own error is a larger share of it."""
    arithmetic = Bounded(relative=2.0**-4)
    (got,) = arithmetic.normalize([scalar(3)])
    low, high = ends_of(got.factor)
    own = high * 2.0**-4
    assert low < 0.875 and got.low == pytest.approx(low - own, rel=2.0**-19)
    assert got.high == pytest.approx(high * (1 + own / low), rel=2.0**-19)


def test_normalize_by_an_inverse_root_that_errs_more_than_the_root():
    arithmetic = Bounded(sqrt_ulp=0.5, divide_ulp=0.5, inversesqrt_ulp=64)
    (got,) = arithmetic.normalize([scalar(3)])
    assert got.low <= 3 * (F(1 / 3) + 60 * 2.0**-25) <= got.high


@given(floats, floats, unit, st.integers(0, 31))
@settings(max_examples=300)
def test_mix_in_both_forms_fused_or_not(a, b, t, bits):
    got = VULKAN.mix(scalar(a), scalar(b), scalar(t))
    x, y, t = Fraction(a), Fraction(b), Fraction(t)
    rest, gap = rounded(1 - t, bits & 1), rounded(y - x, bits & 1)
    results = [rounded(rounded(x * rest, bits >> 1 & 1) + rounded(y * t, bits >> 2 & 1), bits >> 3 & 1)]
    results += [rounded(x * rest + rounded(y * t, bits >> 2 & 1), bits >> 3 & 1)]
    results += [rounded(x + rounded(gap * t, bits >> 1 & 1), bits >> 2 & 1), rounded(x + gap * t, bits >> 2 & 1)]
    assert all(Fraction(float(got.low)) <= value <= Fraction(float(got.high)) for value in results)


texels = st.floats(0, 100, width=32).filter(lambda x: x == 0 or x > 2.0**-60)


def one_mix(a, b, t, up):
    """A blend in the first form with every rounding in one direction."""
    return rounded(rounded(a * rounded(1 - t, up), up) + rounded(b * t, up), up)


@given(st.tuples(texels, texels, texels, texels), unit, unit)
@settings(max_examples=200)
def test_bilinear_blends_and_sums_of_weighted_texels(corners, tx, ty):
    a, b, c, d = corners
    got = VULKAN.bilinear((scalar(a), scalar(b)), (scalar(c), scalar(d)), (scalar(tx), scalar(ty)))
    fa, fb, fc, fd, fx, fy = map(Fraction, (a, b, c, d, tx, ty))
    exact = (fa * (1 - fx) + fb * fx) * (1 - fy) + (fc * (1 - fx) + fd * fx) * fy
    directed = [one_mix(one_mix(fa, fb, fx, up), one_mix(fc, fd, fx, up), fy, up) for up in (0, 1)]
    a, b, c, d, tx, ty = map(F, (a, b, c, d, tx, ty))
    weighted = a * ((F(1) - tx) * (F(1) - ty)) + b * (tx * (F(1) - ty)) + c * ((F(1) - tx) * ty) + d * (tx * ty)
    for value in (exact, *directed, Fraction(float(weighted))):
        assert Fraction(float(got.low)) <= value <= Fraction(float(got.high))
    assert got.high - got.low <= 2 * 20 * ulp(np.float64(max(corners)))  # 9 units of the largest are up to 18 ULP


def test_bilinear_blends_of_one_value_may_lose_something_in_each_of_three_mixes():
    value, t = Fraction(float(F(1.9999))), Fraction(float(F(1 / 3)))
    got = VULKAN.bilinear(*[(scalar(float(value)),) * 2] * 2, (scalar(float(t)),) * 2)
    for up in (0, 1):
        row = one_mix(value, value, t, up)
        assert Fraction(float(got.low)) <= one_mix(row, row, t, up) <= Fraction(float(got.high))


def test_a_mix_over_a_range_of_weights_lies_between_the_two_values():
    got = VULKAN.mix(scalar(1), scalar(3), of((0.25, 0.5)))
    assert 1.5 - 4e-6 < got.low <= 1.5 and 2 <= got.high < 2 + 4e-6
    outside = VULKAN.mix(scalar(1), of((2, 3)), of((-1, 2)))
    assert outside.low <= -1 and outside.high >= 5


def test_subnormals_may_become_zero():
    low, high = ends_of(VULKAN.multiply(scalar(2.0**-100), scalar(2.0**-40)))
    assert low == 0 and high >= 2.0**-140
    low, high = ends_of(VULKAN.multiply(scalar(2.0**-100), scalar(-(2.0**-40))))
    assert low <= -(2.0**-140) and high == 0
    assert ends_of(Ieee().multiply(scalar(2.0**-100), scalar(2.0**-40))) == (2.0**-140, 2.0**-140)
    assert ends_of(VULKAN.representable(scalar(2.0**-140)))[0] == 0


def test_overflow_reaches_infinity():
    low, high = ends_of(VULKAN.multiply(scalar(2.0**100), scalar(2.0**100)))
    assert low == np.finfo(F).max and high == np.inf
    with np.errstate(all="ignore"):
        low, high = ends_of(VULKAN.add(scalar(np.inf), scalar(-np.inf)))
    assert (low, high) == (-np.inf, np.inf)


@given(floats, positive, st.floats(-4, 4, width=32))
@settings(max_examples=300)
def test_ieee_gives_the_oracles_bits(x, y, z):
    ieee = Ieee()
    with np.errstate(all="ignore"):
        pairs = [
            (ieee.add(scalar(x), scalar(y)), F(x) + F(y)),
            (ieee.multiply(scalar(x), scalar(y)), F(x) * F(y)),
            (ieee.divide(scalar(x), scalar(y)), F(x) / F(y)),
            (ieee.sqrt(scalar(y)), np.sqrt(F(y))),
            (ieee.pow(scalar(y), scalar(z)), elementary.pow_array(F(y), F(z))),
            (ieee.exp(scalar(z)), elementary.exp_array(F(z))),
            (ieee.exp2(scalar(z)), elementary.exp2_array(F(z))),
            (ieee.log2(scalar(y)), elementary.log2_array(F(y))),
        ]
    for got, expected in pairs:
        assert got.is_point and F(got.low).tobytes() == F(expected).tobytes()


def test_ieee_powers_of_intervals_reach_from_corner_to_corner():
    assert ends_of(Ieee().pow(of((0.5, 2)), of((-1, 3)))) == (0.125, 8)
    with np.errstate(all="ignore"):
        assert ends_of(Ieee().divide(scalar(1), scalar(0))) == (np.inf, np.inf)
        for around_zero in [(-1, 1), (-0.5, 0.5), (0, 1), (-1, 0)]:
            assert ends_of(Ieee().divide(scalar(1), of(around_zero))) == (-np.inf, np.inf)
    assert ends_of(Ieee().divide(scalar(1), of((0.5, 2)))) == (0.5, 2)
    assert ends_of(Ieee().divide(scalar(1), of((-2, -0.5)))) == (-2, -0.5)


@pytest.mark.parametrize(("x", "y"), [(0.0, -0.0), (-0.0, 0.0)])
def test_of_two_zeros_the_first_is_the_smaller_and_the_larger(x, y):
    """Rule A1: y < x ? y : x, and x < y ? y : x."""
    for operation in (interval.minimum, interval.maximum):
        assert np.signbit(operation(scalar(x), scalar(y)).low) == np.signbit(x)


@pytest.mark.parametrize(
    ("a", "b", "less", "less_equal", "equal"),
    [
        ((1, 2), (3, 4), (True, True), (True, True), (False, False)),
        ((1, 2), (2, 4), (False, True), (True, True), (False, True)),
        ((1, 3), (2, 4), (False, True), (False, True), (False, True)),
        ((2, 2), (2, 2), (False, False), (True, True), (True, True)),
        ((3, 4), (1, 2), (False, False), (False, False), (False, False)),
    ],
)
def test_comparisons(a, b, less, less_equal, equal):
    a, b = of(a), of(b)
    truths = (interval.less(a, b), interval.less_equal(a, b), interval.equal(a, b))
    assert [(bool(t.low), bool(t.high)) for t in truths] == [less, less_equal, equal]
    opposite = interval.opposite(truths[0])
    assert (bool(opposite.low), bool(opposite.high)) == (not less[1], not less[0])


def test_a_choice_takes_both_where_it_is_undecided():
    condition = Interval(np.array([False, False, True]), np.array([False, True, True]))
    got = interval.chosen(condition, point(np.array([1.0, 1, 1])), of((3, 4)))
    assert got.low.tolist() == [3, 1, 1] and got.high.tolist() == [4, 4, 1]
    decided = interval.chosen(point(np.array([True, False])), scalar(1), scalar(2))
    assert decided.is_point and decided.low.tolist() == [1, 2]
