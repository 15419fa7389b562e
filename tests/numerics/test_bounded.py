"""How far results reach, worked out by hand: a bound that is wider than it says hides what it should show."""

from dataclasses import asdict, replace
from fractions import Fraction

import numpy as np
import pytest

from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.interval import Interval, point

VULKAN = Bounded()
EXACT = Bounded(divide_ulp=0, inversesqrt_ulp=0, sqrt_ulp=0, exp_ulp=0, exp_ulp_each=0, log_ulp=0, log_absolute=0)
COARSE = Bounded(relative=2.0**-10)
FLUSHING = Bounded(smallest_normal=2.0**-20)
MARGIN = 1 + Fraction(2) ** -14  # what bounds grow by for products of errors
TINY = Fraction(2) ** -40  # what float64 may err, relative


# Vulkan 1.3, appendix "Precision of Core SPIR-V Instructions", for float32; sqrt inherits from 1 / inversesqrt.
SPECIFIED = {
    "relative": 0.0,
    "smallest_normal": 2.0**-126,
    "largest": 2.0**128 - 2.0**104,
    "largest_denominator": 2.0**126,
    "divide_ulp": 2.5,
    "inversesqrt_ulp": 2.0,
    "sqrt_ulp": 6.5,
    "exp_ulp": 3.0,
    "exp_ulp_each": 2.0,
    "log_ulp": 3.0,
    "log_absolute": 2.0**-21,
}


def test_unless_told_otherwise_the_bounds_are_those_of_vulkan():
    assert asdict(VULKAN) == SPECIFIED


def numbers(*values):
    """Points, one each."""
    return [point(np.float64(value)) for value in values]


def ends_of(a):
    return float(a.low), float(a.high)


def around_zero(reach):
    """From -reach to reach, an exact fraction, rounded outward to the grid of float32."""
    near = np.float32(float(reach))
    end = near if Fraction(float(near)) >= reach else np.nextafter(near, np.float32(np.inf))
    return -float(end), float(end)


BELOW, ABOVE = 2.0**-24, 2.0**-23  # float32's steps below and above 1


@pytest.mark.parametrize(
    ("operation", "operands", "below", "above"),
    [
        ("divide", (1, 1), 6, 3),  # 2.5 ULP are 5 steps below, 2.5 above, and a little of float64
        ("inversesqrt", (1,), 5, 3),  # 2 ULP
        ("sqrt", (1,), 10, 5),  # 1 / inversesqrt: 2 + 2.5 ULP
        ("exp", (0,), 7, 4),  # 3 ULP
        ("exp2", (0,), 7, 4),
        ("pow", (1, 0), 7, 4),  # of exp2
    ],
)
def test_what_is_1_reaches_as_many_steps_as_its_bound_has(operation, operands, below, above):
    with np.errstate(all="ignore"):
        found = getattr(VULKAN, operation)(*numbers(*operands))
    assert ends_of(found) == (1 - below * BELOW, 1 + above * ABOVE)


@pytest.mark.parametrize(("x", "ulps"), [(4, 11), (-4, 11), (-1, 5), (100, 203), (-100, 203)])
def test_an_exponential_errs_by_two_ulp_more_for_each_of_its_argument(x, ulps):
    """An ULP is two steps below a power of two, and one above; outward it is a step more of each."""
    value = 2.0**x
    found = ends_of(VULKAN.exp2(*numbers(x)))
    assert found == (value * (1 - (2 * ulps + 1) * BELOW), value * (1 + (ulps + 1) * ABOVE))


@pytest.mark.parametrize(
    ("operation", "ends"),
    [
        ("inversesqrt", [(0, 1)]),
        ("inversesqrt", [(-1, 4)]),
        ("pow", [(0, 0.5), (0, 0)]),
        ("pow", [(0, 0.5), (-1, 2)]),
        ("pow", [(-0.5, 0.5), (1, 2)]),
        ("multiply", [(0, 0), (-np.inf, 5)]),  # 0 * infinity is no number
        ("multiply", [(0, 0), (5, np.inf)]),
        ("add", [(1, np.inf), (-np.inf, -np.inf)]),
        ("log2", [(-1, 2)]),
        ("sqrt", [(-1, 4)]),
    ],
)
def test_what_has_no_bound_may_be_anything(operation, ends):
    with np.errstate(all="ignore"):
        found = getattr(VULKAN, operation)(*(Interval(*map(np.float64, each)) for each in ends))
    assert ends_of(found) == (-np.inf, np.inf)


def test_a_root_errs_as_an_inverse_and_a_quotient_do():
    """1.5 = 1 / 0.667: 4096 ULP of 2^-24 are 4096 * 2.25 of 2^-24 in 1.5; and a quotient of 8 ULP."""
    (x,) = numbers(2.25)
    of_inverse = Bounded(divide_ulp=0, inversesqrt_ulp=2.0**12, sqrt_ulp=1e6).sqrt(x)
    assert ends_of(of_inverse) == (1.5 - 4609 * ABOVE, 1.5 + 4609 * ABOVE)
    of_quotient = Bounded(divide_ulp=8, inversesqrt_ulp=0, sqrt_ulp=1e6).sqrt(x)
    assert ends_of(of_quotient) == (1.5 - 9 * ABOVE, 1.5 + 9 * ABOVE)


@pytest.mark.parametrize(("x", "steps"), [(0.4899, 4), (0.4901, 5), (2.0399, 5), (2.0401, 4), (0.4, 4), (3, 4)])
def test_a_logarithm_near_0_errs_by_an_absolute_bound_and_no_farther_off(x, steps):
    """2^-21 is 4 ULP of a number between 1 and 2, of which the relative bound is 3; outward it is a step more."""
    exact = np.log2(np.float64(np.float32(x)))
    low, high = ends_of(VULKAN.log2(*numbers(np.float32(x))))
    assert (low, high) == (
        np.floor((exact / ABOVE) - (steps - 1)) * ABOVE,
        np.ceil((exact / ABOVE) + (steps - 1)) * ABOVE,
    )
    assert ends_of(VULKAN.log2(*numbers(1))) == (-(2.0**-21), 2.0**-21)


@pytest.mark.parametrize(("below_two", "steps"), [(2.0**-13 + 2.0**-20, 1), (2.0**-13 - 2.0**-20, 2)])
def test_an_ulp_near_the_next_power_of_two_is_the_larger_one(below_two, steps):
    """As much below 2 as bounds leave out, 2^-14 of it: 64 ULP are 64 steps, or twice as many."""
    arithmetic, x = Bounded(divide_ulp=64), 2 - below_two
    found = arithmetic.divide(*numbers(x, 1))
    assert ends_of(found) == (x - (64 * steps + 1) * ABOVE, x + (64 * steps + 1) * ABOVE)


MIXES = [((-1, 1, 0.5), 2), ((-2, -1, 2), 6), ((1, 2, -1), 6), ((-3, 1, 0.75), 4)]


@pytest.mark.parametrize(("operands", "size"), MIXES)
def test_a_mix_errs_by_two_units_of_both_terms(operands, size):
    """All are 0, so that float32 shows the whole bound; terms grow with what is beyond 0 ... 1 of the weight."""
    a, b, t = numbers(*operands)
    unit = Fraction(2) ** -23
    assert ends_of(VULKAN.mix(a, b, t)) == around_zero(size * 2 * unit * MARGIN)
    assert ends_of(FLUSHING.mix(a, b, t)) == around_zero(size * 2 * unit * MARGIN + 4 * Fraction(2) ** -20)
    share = Fraction(2) ** -10
    assert ends_of(COARSE.mix(a, b, t)) == around_zero(size * (2 * unit + 4 * share) * MARGIN * (1 + share))


@pytest.mark.parametrize("corners", [(-1, 1, -1, 1), (-1, 1, 1, -1)])
def test_a_blend_of_four_errs_by_units_of_the_largest_and_of_what_they_are_apart(corners):
    """Nine units: four of 2, which -1 and 1 are apart, and one of 1; a half more than one operation's for each."""
    a, b, c, d = numbers(*corners)
    halves = tuple(numbers(0.5, 0.5))
    unit, share, flush = Fraction(2) ** -23, Fraction(2) ** -10, Fraction(2) ** -20
    assert ends_of(VULKAN.bilinear((a, b), (c, d), halves)) == around_zero(9 * unit * MARGIN)
    assert ends_of(FLUSHING.bilinear((a, b), (c, d), halves)) == around_zero(9 * unit * MARGIN + 12 * flush)
    coarse = 9 * (unit + share * 3 / 2) * MARGIN
    assert ends_of(COARSE.bilinear((a, b), (c, d), halves)) == around_zero(coarse * (1 + share))


def test_a_blend_of_four_that_are_the_same_errs_by_six_units():
    """Four for each product and two for sums; outward a step of 2^-24 or 2^-23 more."""
    (x,), halves = numbers(1), tuple(numbers(0.5, 0.5))
    assert ends_of(VULKAN.bilinear((x, x), (x, x), halves)) == (1 - 13 * BELOW, 1 + 7 * ABOVE)


@pytest.mark.parametrize(
    ("terms", "ulps", "size"),
    [
        ((1, -1), 2, 2),  # an ULP of each product, 2^-23
        ((1, 1, -2), 4 + 4, 4 + 4),  # 1 + 1 + 2, and of the sum of all sizes 4
        ((1, 1, 1, -3), 5 + 2 * 4, 6 + 2 * 6),
    ],
)
def test_a_dot_errs_by_an_ulp_of_each_product_and_of_each_sum_but_the_last(terms, ulps, size):
    a, b = numbers(*terms), numbers(*[1] * len(terms))
    total, count = sum(map(abs, terms)), len(terms)
    lost = ulps * Fraction(2) ** -23 + size * TINY
    assert ends_of(VULKAN.dot(a, b)) == around_zero(lost)
    assert ends_of(FLUSHING.dot(a, b)) == around_zero(lost + 2 * count * Fraction(2) ** -20)
    share = Fraction(2) ** -10
    coarse = lost + total * (2 * count - 1) * share * MARGIN
    assert ends_of(COARSE.dot(a, b)) == around_zero(coarse * (1 + share))


def test_a_length_errs_by_what_its_squares_their_root_and_the_inverse_do():
    """Of 3, whose square is 9: one ULP of 9 for the product; a sixteenth of everything where that is the bound."""
    factor = EXACT.normalize(numbers(3))[0].factor
    of_dot = 2.0**-20 / 9
    assert ends_of(factor) == pytest.approx(((1 + of_dot) ** -0.5, (1 - of_dot) ** -0.5), abs=1e-11)

    coarse = Bounded(relative=1 / 16, divide_ulp=0, inversesqrt_ulp=0, sqrt_ulp=0)
    least, most = (15 / 16) ** 2, (17 / 16) ** 2  # of the square: the product, and the sum's last rounding
    of_dot, of_root = (2 / 16) / least, (1 / 16) * (17 / 15)
    expected = (1 - of_root) / (1 + of_dot) ** 0.5, 1 / (1 - of_root) / (1 - of_dot) ** 0.5
    assert ends_of(coarse.normalize(numbers(3))[0].factor) == pytest.approx(expected, rel=1e-4)
    assert most / least == pytest.approx((17 / 15) ** 2)


def test_a_length_errs_by_the_larger_of_two_ways():
    """An inverse root of 2^12 ULP, of 1/3: 2^12 of 2^-25, so 3 * 2^-13 of the length; a root of as many, of 2^-22."""
    inverse = Bounded(divide_ulp=0, inversesqrt_ulp=2.0**12, sqrt_ulp=0).normalize(numbers(3))[0].factor
    assert ends_of(inverse) == pytest.approx((1 - 3 * 2.0**-13, 1 + 3 * 2.0**-13), abs=2e-7)
    root = Bounded(divide_ulp=2.0**13, inversesqrt_ulp=0, sqrt_ulp=2.0**12).normalize(numbers(3))[0].factor
    assert ends_of(root) == pytest.approx((1 / (1 + 2.0**-10 / 3), 1 / (1 - 2.0**-10 / 3)), abs=2e-7)


@pytest.mark.parametrize(
    "vector", [(0, 0, 1e-30), (3e19, 1, 1), (2.0**64, 0, 0)], ids=["square is lost", "square is large", "infinite"]
)
def test_a_vector_whose_square_may_be_0_or_infinite_has_any_length(vector):
    with np.errstate(all="ignore"):
        assert ends_of(VULKAN.normalize(numbers(*vector))[0].factor) == (-np.inf, np.inf)


def test_a_vector_that_may_be_0_has_any_direction():
    around = Interval(np.float64(-1), np.float64(1))
    with np.errstate(all="ignore"):
        assert ends_of(VULKAN.normalize([around] * 3)[0].factor) == (-np.inf, np.inf)
        assert ends_of(VULKAN.normalize([around] * 3)[0]) == (-np.inf, np.inf)


@pytest.mark.parametrize(("length", "is_lost"), [(1.9, True), (2.1, False), (2.9, False)])
def test_a_component_may_be_lost_below_twice_the_smallest_normal_number(length, is_lost):
    """Twice: the quotient may come out as half of what it is, and is then below."""
    arithmetic = Bounded(smallest_normal=2.0**-10)
    low = arithmetic.normalize(numbers(1, length * 2.0**-10))[1].low
    assert bool(low <= 0) is is_lost


def test_a_component_errs_by_an_ulp_even_where_a_quotient_does_not():
    """It may be a product, which gives either neighbour; 1 and what float64 errs is the rest."""
    (x,) = EXACT.normalize(numbers(1))
    of_dot = 2.0**-23  # an ULP of its square
    assert ends_of(x.share) == pytest.approx((1 - 2.0**-23, 1 + 2.0**-23), abs=1e-11)
    assert ends_of(x) == pytest.approx((1 - 1.5 * of_dot, 1 + 1.5 * of_dot), abs=2 * BELOW)


@pytest.mark.parametrize("count", [1, 300], ids=["few", "a row"])
def test_ordinary_numbers_are_kept_as_they_are(count):
    """A point stays one value, known to be one without a look."""
    for value in (0.0, 1.0, -(2.0**-126), 2.0**-126, float(np.finfo(np.float32).max)):
        x = point(np.full(count, value))
        assert VULKAN.representable(x) is x


NO_LENGTH = 2.0**23 - 2.0**-17  # ULP of 1 that are 1 with what float64 errs


@pytest.mark.parametrize(
    ("bounds", "is_known"),
    [
        ({"inversesqrt_ulp": NO_LENGTH}, False),
        ({"inversesqrt_ulp": NO_LENGTH - 1}, True),
        ({"sqrt_ulp": NO_LENGTH, "divide_ulp": 2.0**24}, False),
        ({"sqrt_ulp": NO_LENGTH - 1, "divide_ulp": 2.0**24}, True),
        ({"largest": 1.0}, True),
        ({"largest": 1 - 2.0**-24}, False),
    ],
)
def test_a_vector_whose_length_may_come_out_as_0_has_any_direction(bounds, is_known):
    """(1): an inverse, or a root, that errs by all of it; and a square that may be more than the largest number."""
    arithmetic = replace(EXACT, **bounds)
    with np.errstate(all="ignore"):
        (x,) = arithmetic.normalize(numbers(1))
    assert (ends_of(x.factor) != (-np.inf, np.inf)) is is_known


@pytest.mark.parametrize("other", [0.0, 1.0, -1.0, 2.0**-126, -(2.0**-126), 2.0**128 - 2.0**104, 2.0**104 - 2.0**128])
@pytest.mark.parametrize("strange", [2.0**-127, -np.inf, np.inf, np.nan])
def test_beside_a_number_out_of_range_those_in_range_stay(other, strange):
    found = VULKAN.representable(Interval(np.array([other, strange]), np.array([other, strange])))
    assert (found.low[0], found.high[0]) == (other, other)


@pytest.mark.parametrize("count", [1, 300], ids=["few", "a row"])
@pytest.mark.parametrize(
    ("value", "ends"),
    [
        (2.0**-127, (0, 2.0**-126)),
        (-(2.0**-149), (-(2.0**-126), 0)),
        (2.0**128, (2.0**128 - 2.0**104, np.inf)),
        (-np.inf, (-np.inf, -(2.0**128 - 2.0**104))),
        (np.nan, (-np.inf, np.inf)),
    ],
)
def test_one_number_out_of_range_among_others(count, value, ends):
    numbers_of_all = np.ones(count)
    numbers_of_all[count // 2] = value
    found = VULKAN.representable(point(numbers_of_all))
    assert (found.low[count // 2], found.high[count // 2]) == ends
    assert count == 1 or (found.low[0], found.high[0]) == (1, 1)
