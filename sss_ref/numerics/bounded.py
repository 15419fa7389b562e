"""The operations of a shader on intervals, for a processor of which no more than its error bounds is known.

What it may compute, given what its operands may be: each result encloses everything that it may give.
"""

import operator
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np

from sss_ref.numerics import outward
from sss_ref.numerics.directed import LARGEST, SMALLEST_NORMAL, UNIT, downward, two_sum, ulp, upward
from sss_ref.numerics.interval import (
    INFINITY,
    Interval,
    Scaled,
    chosen,
    directions,
    each_end,
    ends,
    hull,
    point,
    product,
    quotient,
    unbounded_for_nan,
    unbounded_where,
    without_factor,
)

FLOAT64_MARGIN = 2.0**-40  # relative; float64 + - * / sqrt and NumPy's exp, exp2 and log2 err by far less
MARGIN = 2.0**-14  # relative; what bounds leave out: products of errors, and how far an ULP reaches
Pair = tuple[Interval, Interval]

LARGEST_EXPONENT = 150.0  # 2^-150 is below every float32, so the error of exp2 need not grow beyond it


@dataclass(frozen=True)
class Bounded:
    """Operations known by their bounds alone, in ULP of the exact value; the defaults are Vulkan's.

    Sums and products give either neighbour of the exact value; sums of products come in any order, fused or not.
    relative: what every operation may err besides, as a share of its result.
    smallest_normal: a result closer to 0 may become 0. largest: a result beyond may become infinite.
    largest_denominator: a quotient by more, or by less than smallest_normal, is undefined.
    sqrt_ulp: sqrt errs by no more, nor by more than 1/inversesqrt may.
    exp_ulp, exp_ulp_each: exp and exp2 err by exp_ulp + exp_ulp_each*|x|.
    log_ulp, log_absolute: log2 errs by log_ulp; for x in [0.5, 2] by log_absolute, which is no ULP, if that is more.
    """

    relative: float = 0.0
    smallest_normal: float = SMALLEST_NORMAL
    largest: float = LARGEST
    largest_denominator: float = 2.0**126
    divide_ulp: float = 2.5
    inversesqrt_ulp: float = 2.0
    sqrt_ulp: float = 6.5
    exp_ulp: float = 3.0
    exp_ulp_each: float = 2.0
    log_ulp: float = 3.0
    log_absolute: float = 2.0**-21

    def add(self, a: Interval, b: Interval) -> Interval:
        """All x + y."""
        rows = None if self.relative else outward.rows_of(a.low, b.low, a.high, b.high)
        if rows:
            return self._in_range(
                outward.sums_down(*rows[:2], *self._ordinary_size), outward.sums_up(*rows[2:], *self._ordinary_size)
            )
        low, low_error = two_sum(a.low, b.low)
        if a.is_point and b.is_point:
            return self._rounded(low, low, low_error, low_error)
        high, high_error = two_sum(a.high, b.high)
        return self._rounded(low, high, low_error, high_error)

    def multiply(self, a: Interval, b: Interval) -> Interval:
        """All x * y."""
        exact = product(a, b)
        return self._rounded(exact.low, exact.high)

    def divide(self, a: Interval, b: Interval) -> Interval:
        """All x / y."""
        one_sided = (b.low >= self.smallest_normal) | (b.high <= -self.smallest_normal)
        undefined = ~(one_sided & (b.magnitude <= self.largest_denominator))
        return unbounded_where(undefined, self._within(self.divide_ulp, quotient(a, b)))

    def sqrt(self, x: Interval) -> Interval:
        """All square roots; of a negative number anything."""
        exact = each_end(np.sqrt, x)
        return self._rounded(exact.low - self._sqrt_spread(exact.low), exact.high + self._sqrt_spread(exact.high))

    def inversesqrt(self, x: Interval) -> Interval:
        """All 1 / sqrt(x); of 0 or a negative number anything."""
        roots = Interval(1.0 / np.sqrt(x.high), 1.0 / np.sqrt(x.low))
        return unbounded_where(x.low <= 0, self._within(self.inversesqrt_ulp, roots))

    def exp(self, x: Interval) -> Interval:
        """All e^x."""
        return self._exponential(np.exp, x)

    def exp2(self, x: Interval) -> Interval:
        """All 2^x."""
        return self._exponential(np.exp2, x)

    def log2(self, x: Interval) -> Interval:
        """All log2 x; of a negative number anything."""
        exact = each_end(np.log2, x)
        low = exact.low - np.maximum(_spread(self.log_ulp, exact.low), self._log_absolute(x.low))
        high = exact.high + np.maximum(_spread(self.log_ulp, exact.high), self._log_absolute(x.high))
        return self._rounded(low, high)

    def pow(self, x: Interval, y: Interval) -> Interval:
        """All x^y as exp2(y * log2(x)); of a negative number, or of 0 where y may be <= 0, anything."""
        undefined = (x.low < 0) | ((x.low == 0) & (y.low <= 0))
        return unbounded_where(undefined, self.exp2(self.multiply(y, self.log2(x))))

    def dot(self, a: Sequence[Interval], b: Sequence[Interval]) -> Interval:
        """All x*x' + y*y' + ..., in whatever order, fused or not.

        A sum of squares (b is made of the values of a) is never negative. A factor that all components of a vector
        share is one of the result.
        """
        lost = self._lost_in_dot([x.magnitude * y.magnitude for x, y in zip(a, b, strict=True)])
        (factor_a, a), (factor_b, b) = without_factor(a), without_factor(b)
        squares = all(x is y for x, y in zip(a, b, strict=True))
        total = each_end(lambda *terms: _total(terms), *map(product, a, b))
        exact = product(product(factor_a, factor_b), total)
        return self._rounded(np.maximum(exact.low - lost, 0.0) if squares else exact.low - lost, exact.high + lost)

    def normalize(self, v: Sequence[Interval]) -> list[Interval]:
        """The vectors v / length(v) and v * inversesqrt(dot(v, v)); 0 where v is.

        A processor takes one of the two ways, and the length once: what that errs all components share as a factor.
        """
        factor = self._factor_of_length(v)
        return [self._scaled(x, factor) for x in directions(v)]

    def mix(self, a: Interval, b: Interval, t: Interval) -> Interval:
        """All x*(1 - t) + y*t and x + (y - x)*t: both err by two units of both terms, before the sum is rounded."""
        size = (a.magnitude + b.magnitude) * np.maximum(np.maximum(t.magnitude, np.abs(1.0 - t.low)), 1.0)
        return self._around(_between(a, b, t), self._lost(size, 2 * UNIT + 4 * self.relative, flushes=4))

    def bilinear(self, lower: Pair, upper: Pair, t: Pair) -> Interval:
        """All blends of four neighbours, for t in 0 ... 1: three mixes, or one sum with products of weights.

        In units of the largest corner, before the last sum: four for each product of the one sum and two for its first
        sums; of a mix two, of the corner or of what it is apart from another, which is more where their signs differ.
        """
        corners = (*lower, *upper)
        size = reduce(np.maximum, [x.magnitude for x in corners])
        apart = reduce(np.maximum, [x.high for x in corners]) - reduce(np.minimum, [x.low for x in corners])
        exact = _between(_between(*lower, t[0]), _between(*upper, t[0]), t[1])
        largest = np.maximum(6.0 * size, 4.0 * apart + size)
        return self._around(exact, self._lost(largest, UNIT + 1.5 * self.relative, flushes=12))

    def _lost_in_dot(self, sizes: Sequence[Any]) -> Any:
        """What a dot of terms of these sizes errs before its last rounding: each operation an ULP of its result."""
        size, count = _total(sizes), len(sizes)
        ulps = _total([_spread(1.0, each) for each in sizes]) + (count - 2) * _spread(1.0, size)
        return ulps + self._lost(size, (2 * count - 1) * self.relative, flushes=2 * count)

    def _factor_of_length(self, v: Sequence[Interval]) -> Interval:
        """By how much 1 / length(v) may come out larger or smaller than it is, in either way of `normalize`."""
        squares, sizes = self.dot(v, v), [x.magnitude**2 for x in v]
        shortest, longest = np.sqrt(squares.low), np.sqrt(squares.high)
        of_dot = (self._lost_in_dot(sizes) + self._error(1.0, _total(sizes))) / squares.low
        of_root = (self._sqrt_spread(longest) + self.relative * longest) / shortest
        of_inverse = self._error(self.inversesqrt_ulp, 1.0 / shortest) * longest
        low = np.minimum(1.0 / (1.0 + of_root), 1.0 - of_inverse) / np.sqrt(1.0 + of_dot)
        high = np.maximum(1.0 / (1.0 - of_root), 1.0 + of_inverse) / np.sqrt(1.0 - of_dot)
        error = reduce(np.maximum, (of_dot, of_root, of_inverse))  # from 1 on, what comes out may be 0 or less
        undefined = ~((error < 1) & (squares.high <= self.largest))
        factor = unbounded_where(undefined, Interval(low, high))
        return chosen(point(squares.high > 0), factor, point(np.float64(1)))

    def _scaled(self, direction: Interval, factor: Interval) -> Interval:
        """A component of a unit vector: its direction, the factor, and the last rounding, which is its own."""
        size = direction.magnitude * factor.high
        flushed = np.where(size < 2.0 * self.smallest_normal, size, 0.0)
        error = self._error(max(self.divide_ulp, 1.0), size) + flushed
        share = Interval(direction.low - error / factor.low, direction.high + error / factor.low)
        whole = product(factor, share)
        near = self.representable(Interval(downward(whole.low), upward(whole.high)))
        return Scaled(near.low, near.high, share, factor)

    def _sqrt_spread(self, root: Any) -> Any:
        """How much a square root errs in absolute terms."""
        composed = _spread(self.divide_ulp, root) + _spread(self.inversesqrt_ulp, 1.0 / root) * root * root
        return np.fmin(_spread(self.sqrt_ulp, root), composed * (1.0 + MARGIN))

    def _error(self, ulps: float, size: Any) -> Any:
        """What an operation errs in absolute terms on results of this size."""
        return _spread(ulps, size) + self.relative * size

    def _exponential(self, function: Any, x: Interval) -> Interval:
        exact = each_end(function, x)
        low = exact.low - _spread(self._exp_bound(x.low), exact.low)
        return self._rounded(low, exact.high + _spread(self._exp_bound(x.high), exact.high))

    def _exp_bound(self, x: Any) -> Any:
        return self.exp_ulp + self.exp_ulp_each * np.minimum(np.abs(x), LARGEST_EXPONENT)

    def _log_absolute(self, x: Any) -> Any:
        """The absolute bound, and some way beyond its limits, so that no end lies inside one next to it."""
        return np.where((x > 0.49) & (x < 2.04), self.log_absolute, 0.0)

    def _around(self, exact: Interval, lost: Any) -> Interval:
        rows = None if self.relative else outward.rows_of(exact.low, exact.high, lost)
        if rows:
            low, high, lost = rows
            return self._in_range(
                outward.lows(low, lost, *self._ordinary_size), outward.highs(high, lost, *self._ordinary_size)
            )
        return self._rounded(exact.low - lost, exact.high + lost)

    def _lost(self, size: Any, share: float, flushes: int) -> Any:
        """What operations on terms of this size may lose: a share of it, and results so small that they become 0."""
        return size * (share * (1.0 + MARGIN)) + np.minimum(size, flushes * self.smallest_normal)

    def _within(self, ulps: float, exact: Interval) -> Interval:
        low = exact.low - _spread(ulps, exact.low)
        return self._rounded(low, exact.high + _spread(ulps, exact.high))

    def _rounded(self, low: Any, high: Any, low_error: Any = None, high_error: Any = None) -> Interval:
        """The numbers of float32 around these bounds, as far as this arithmetic has them."""
        if self.relative:
            low, high = low - self.relative * np.abs(low), high + self.relative * np.abs(high)
        rows = outward.rows_of(low, high) if low_error is None else None
        if rows:
            return self._in_range(
                outward.rounded_down(rows[0], *self._ordinary_size), outward.rounded_up(rows[1], *self._ordinary_size)
            )
        return self.representable(Interval(downward(low, low_error), upward(high, high_error)))

    def representable(self, a: Interval) -> Interval:
        """The interval with 0 where it has a number too small for this arithmetic, infinity where one too large."""
        return a if all(map(self._ordinary, ends(a))) else self._within_range(a)

    @property
    def _ordinary_size(self) -> tuple[float, float]:
        """The least and the largest size of an ordinary number that is not 0."""
        return self.smallest_normal, self.largest

    def _in_range(self, low: tuple[Any, bool], high: tuple[Any, bool]) -> Interval:
        """The interval between ends, each with whether all of its numbers are ordinary."""
        found = Interval(low[0], high[0])
        return found if low[1] and high[1] else self._within_range(found)

    def _within_range(self, a: Interval) -> Interval:
        """The interval with ends in the range of normal numbers; any value where one is NaN."""
        a = unbounded_for_nan(a)
        return Interval(self._low_in_range(a.low), -self._low_in_range(-a.high))

    def _ordinary(self, x: Any) -> bool:
        """Whether all numbers are 0 or normal."""
        rows = outward.rows_of(x)
        if rows:
            return bool(outward.are_ordinary(*rows, *self._ordinary_size))
        size = np.abs(x)
        return bool(size.max(initial=0.0) <= self.largest) and not np.any((size < self.smallest_normal) & (size > 0))

    def _low_in_range(self, low: Any) -> Any:
        """A lower end in the range of normal numbers."""
        near_zero = np.where(low < 0, -self.smallest_normal, 0.0)
        normal = np.where(np.abs(low) < self.smallest_normal, near_zero, low)
        return np.where(normal >= -self.largest, np.minimum(normal, self.largest), -INFINITY)


def _spread(ulps: Any, x: Any) -> Any:
    """So many ULP of x in absolute terms; just below a power of 2 that of the larger ULP, which is next to it."""
    size = np.minimum(np.abs(x), LARGEST)
    return ulps * ulp(size * (1.0 + MARGIN)) + FLOAT64_MARGIN * size


def _between(a: Interval, b: Interval, t: Interval) -> Interval:
    """All x*(1 - t) + y*t in float64: linear in t, so those at its ends enclose the others."""
    return hull(*(_blend(a, b, weight) for weight in ends(t)))


def _blend(a: Interval, b: Interval, weight: Any) -> Interval:
    of_a, of_b = product(a, point(1.0 - weight)), product(b, point(weight))
    return each_end(operator.add, of_a, of_b)


def _total(terms: Sequence[Any]) -> Any:
    return reduce(operator.add, terms)
