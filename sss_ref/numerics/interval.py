"""Sets of values as closed intervals, one per element of two arrays; nothing here rounds.

Floats are float64 (-inf, inf: unbounded), integers int64, truth values bool: there low means certainly true and high
possibly true.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np

from sss_ref.numerics import outward

INFINITY = np.inf


@dataclass(frozen=True, eq=False, slots=True)
class Interval:
    """All values from low to high, both included; arrays of one shape, or scalars. Of a point, high is low itself."""

    low: Any
    high: Any

    @property
    def is_point(self) -> bool:
        """Whether every element is a single value, known without comparing any."""
        return self.low is self.high

    @property
    def magnitude(self) -> Any:
        """The largest absolute value."""
        return np.abs(self.low) if self.is_point else np.maximum(np.abs(self.low), np.abs(self.high))

    @property
    def undecided(self) -> Any:
        """Where more than one value is left."""
        return np.False_ if self.is_point else self.low != self.high


@dataclass(frozen=True, eq=False, slots=True)
class Scaled(Interval):
    """A component of a vector whose length is less certain than its direction: all share * factor.

    factor: one Interval for all components of the vector: whatever number it stands for, each is multiplied by it.
    """

    share: Interval
    factor: Interval


def point(value: Any) -> Interval:
    """One value per element."""
    return Interval(value, value)


def each_end(operation: Callable[..., Any], *intervals: Interval) -> Interval:
    """An operation that no argument makes smaller by growing, at both ends."""
    low = operation(*(interval.low for interval in intervals))
    if all(interval.is_point for interval in intervals):
        return Interval(low, low)
    return Interval(low, operation(*(interval.high for interval in intervals)))


def negated(a: Interval) -> Interval:
    """All -x."""
    low = -a.high
    high = low if a.is_point else -a.low
    return Scaled(low, high, negated(a.share), a.factor) if isinstance(a, Scaled) else Interval(low, high)


def hull(*intervals: Interval) -> Interval:
    """The smallest interval around all of them."""
    result = intervals[0]
    for other in intervals[1:]:
        result = Interval(np.minimum(result.low, other.low), np.maximum(result.high, other.high))
    return result


def minimum(a: Interval, b: Interval) -> Interval:
    """All y < x ? y : x (rule A1, also in which zero it gives)."""
    return each_end(lambda x, y: np.where(y < x, y, x), a, b)


def maximum(a: Interval, b: Interval) -> Interval:
    """All x < y ? y : x (rule A1)."""
    return each_end(lambda x, y: np.where(x < y, y, x), a, b)


def product(a: Interval, b: Interval) -> Interval:
    """All x*y, where float64 holds them exactly; all x*x where a and b are the same value."""
    if a is b:
        return square(a)
    if a.is_point and (b.is_point or np.all(a.low >= 0)):
        return each_end(lambda y: a.low * y, b)
    if b.is_point and np.all(b.low >= 0):
        return each_end(lambda x: x * b.low, a)
    rows = outward.rows_of(a.low, a.high, b.low, b.high)
    if rows:
        return Interval(outward.least_products(*rows), outward.most_products(*rows))
    corners = [x * y for x in ends(a) for y in ends(b)]
    return hull(*map(point, corners))


def square(a: Interval) -> Interval:
    """All x*x."""
    if a.is_point:
        return point(a.low * a.low)
    least = np.maximum(np.maximum(a.low, -a.high), 0.0)  # the distance of the interval from 0
    return Interval(least * least, a.magnitude**2)


def directions(v: Sequence[Interval]) -> list[Interval]:
    """All v / |v| in float64, 0 where v is: a component grows with itself and shrinks as the others grow.

    Unbounded where v is: the quotient of two infinities is NaN.
    """
    squares = [square(x) for x in v]
    bounded = reduce(np.logical_and, [np.isfinite(end) for x in v for end in ends(x)])
    return [_part_of_length(x, squares[:k] + squares[k + 1 :], bounded) for k, x in enumerate(v)]


def _part_of_length(x: Interval, others: Sequence[Interval], bounded: Any) -> Interval:
    """All x / sqrt(x*x + others) where that is bounded."""
    least, most = sum(each.low for each in others), sum(each.high for each in others)

    def at(end: Any, rest: Any) -> Any:
        return np.where(end == 0, 0.0, end / np.sqrt(end * end + rest))

    low, high = at(x.low, np.where(x.low < 0, least, most)), at(x.high, np.where(x.high < 0, most, least))
    return Interval(np.where(bounded, low, -INFINITY), np.where(bounded, high, INFINITY))


def quotient(a: Interval, b: Interval) -> Interval:
    """All x/y in float64, for b on one side of 0."""
    if a.is_point and b.is_point:
        return point(a.low / b.low)
    return hull(*(point(x / y) for x in ends(a) for y in ends(b)))


def ends(a: Interval) -> tuple[Any, ...]:
    """Low and high, once if they are the same."""
    return (a.low,) if a.is_point else (a.low, a.high)


def without_factor(v: Sequence[Interval]) -> tuple[Interval, Sequence[Interval]]:
    """The factor that all components of a vector share, and their shares; 1 and the components if there is none."""
    scaled = [x for x in v if isinstance(x, Scaled)]
    if len(scaled) == len(v) and all(x.factor is scaled[0].factor for x in scaled):
        return scaled[0].factor, [x.share for x in scaled]
    return point(np.float64(1)), v


def unbounded_where(undefined: Any, a: Interval) -> Interval:
    """Any value at all where the operation is undefined."""
    if not np.any(undefined):
        return a
    return Interval(np.where(undefined, -INFINITY, a.low), np.where(undefined, INFINITY, a.high))


def unbounded_for_nan(a: Interval) -> Interval:
    """Any value at all where an end came out as NaN."""
    undefined = np.isnan(a.low) if a.is_point else np.isnan(a.low) | np.isnan(a.high)
    return unbounded_where(undefined, a)


# Truth values


def less(a: Interval, b: Interval) -> Interval:
    """Whether x < y."""
    return _truth(a.high < b.low, a.low < b.high, a, b)


def less_equal(a: Interval, b: Interval) -> Interval:
    """Whether x <= y."""
    return _truth(a.high <= b.low, a.low <= b.high, a, b)


def equal(a: Interval, b: Interval) -> Interval:
    """Whether x == y."""
    return _truth((a.high <= b.low) & (b.high <= a.low), (a.low <= b.high) & (b.low <= a.high), a, b)


def opposite(truth: Interval) -> Interval:
    """Whether it does not hold."""
    low = ~truth.high
    return Interval(low, low if truth.is_point else ~truth.low)


def chosen(condition: Interval, if_true: Interval, if_false: Interval) -> Interval:
    """What condition ? x : y may give: both where the condition is undecided."""
    if not np.any(condition.undecided):
        return each_end(lambda x, y: np.where(condition.low, x, y), if_true, if_false)
    either = hull(if_true, if_false)
    return Interval(
        np.where(condition.low, if_true.low, np.where(condition.high, either.low, if_false.low)),
        np.where(condition.low, if_true.high, np.where(condition.high, either.high, if_false.high)),
    )


def _truth(certain: Any, possible: Any, a: Interval, b: Interval) -> Interval:
    return point(certain) if a.is_point and b.is_point else Interval(certain, possible)
