"""The operations of a shader on intervals, for a processor that rounds each correctly: the oracle's own bits."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.numerics import elementary
from sss_ref.numerics.directed import nearest
from sss_ref.numerics.interval import (
    Interval,
    each_end,
    ends,
    hull,
    point,
    product,
    quotient,
    unbounded_for_nan,
    unbounded_where,
)


@dataclass(frozen=True)
class Ieee:
    """Every operation correctly rounded, in the order written, subnormals kept (rules A1 to A3)."""

    def add(self, a: Interval, b: Interval) -> Interval:
        """All x + y."""
        return self._nearest(each_end(lambda x, y: x + y, a, b))

    def multiply(self, a: Interval, b: Interval) -> Interval:
        """All x * y."""
        return self._nearest(product(a, b))

    def divide(self, a: Interval, b: Interval) -> Interval:
        """All x / y; by the point 0 as IEEE has it, by an interval around 0 anything."""
        around_zero = (b.low <= 0) & (b.high >= 0) & b.undecided
        return unbounded_where(around_zero, self._nearest(quotient(a, b)))

    def sqrt(self, x: Interval) -> Interval:
        """All square roots; of a negative number anything."""
        return self._nearest(each_end(np.sqrt, x))

    def exp(self, x: Interval) -> Interval:
        """All e^x."""
        return self._elementary(elementary.exp_array, x)

    def exp2(self, x: Interval) -> Interval:
        """All 2^x."""
        return self._elementary(elementary.exp2_array, x)

    def log2(self, x: Interval) -> Interval:
        """All log2 x."""
        return self._elementary(elementary.log2_array, x)

    def pow(self, x: Interval, y: Interval) -> Interval:
        """All x^y, x >= 0: monotone in each, so the ends are among the corners."""
        corners = [self._elementary(elementary.pow_array, point(a), point(b)) for a in ends(x) for b in ends(y)]
        return hull(*corners)

    def representable(self, a: Interval) -> Interval:
        """The interval itself: every float32 is kept."""
        return a

    def _elementary(self, function: Any, *arguments: Interval) -> Interval:
        def at(*values: Any) -> Any:
            return np.asarray(function(*(np.asarray(value).astype(np.float32) for value in values))).astype(np.float64)

        return unbounded_for_nan(each_end(at, *arguments))

    def _nearest(self, exact: Interval) -> Interval:
        return unbounded_for_nan(each_end(nearest, exact))
