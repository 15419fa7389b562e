"""Whole rows of ends of intervals, compiled: the bits of `directed` and `interval`, each in one go.

Every row is float64 (N,), contiguous and writable (`rows_of` makes them). NumPy goes through memory once for each
operation, some thirty times for a sum of intervals; here LLVM computes several elements at once. For that a function
fills one row, so that it can tell that none overlap, and a condition is written without a way out in its middle.
"""

from typing import Any

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.directed import DROPPED

KEPT, SIGN, ONE, NONE = ~DROPPED, np.int64(63), np.int64(1), np.int64(0)
LEAST = 256  # elements below which NumPy is as fast


def rows_of(*values: Any) -> list[np.ndarray] | None:
    """Values as rows of one length, scalars repeated; None where there are few of them, or no rows."""
    shape = max((np.shape(value) for value in values), key=len)
    if len(shape) != 1 or shape[0] < LEAST or any(np.asarray(value).dtype != np.float64 for value in values):
        return None
    made: dict[int, np.ndarray] = {}
    return [
        made[id(value)] if id(value) in made else made.setdefault(id(value), _row(value, shape)) for value in values
    ]


def _row(value: Any, shape: tuple[int, ...]) -> np.ndarray:
    is_row = isinstance(value, np.ndarray) and value.shape == shape
    if is_row and value.flags.c_contiguous and value.flags.writeable:
        row: np.ndarray = value
        return row
    return np.array(np.broadcast_to(value, shape), order="C")


@compiled
def lowered(x, error):
    """The number of float32's precision at or below x + error, as `directed.downward`."""
    bits = np.float64(x).view(np.int64)
    sign = bits >> SIGN
    away = bits + (DROPPED & sign) - ((sign | ONE) if error < 0.0 else NONE)
    return np.int64(away & KEPT).view(np.float64)


@compiled
def raised(x, error):
    """The number of float32's precision at or above x + error, as `directed.upward`."""
    bits = np.float64(x).view(np.int64)
    sign = bits >> SIGN
    away = bits + (DROPPED & ~sign) + ((sign | ONE) if error > 0.0 else NONE)
    return np.int64(away & KEPT).view(np.float64)


@compiled
def strange(x, smallest, largest):
    """1 of a number that is neither 0 nor normal, else 0."""
    size = abs(x)
    return ONE if (not size <= largest) or (size < smallest and size > 0.0) else NONE


@compiled
def are_ordinary(row, smallest, largest):
    """Whether all numbers are 0 or normal."""
    found = NONE
    for k in range(len(row)):
        found |= strange(row[k], smallest, largest)
    return found == 0


@compiled
def lows(low, lost, smallest, largest):
    """Low ends less what was lost, rounded down; and whether all of them are ordinary."""
    least, found = np.empty_like(low), NONE
    for k in range(len(low)):
        end = lowered(low[k] - lost[k], 0.0)
        found |= strange(end, smallest, largest)
        least[k] = end
    return least, found == 0


@compiled
def highs(high, lost, smallest, largest):
    """High ends and what was lost, rounded up; and whether all of them are ordinary."""
    most, found = np.empty_like(high), NONE
    for k in range(len(high)):
        end = raised(high[k] + lost[k], 0.0)
        found |= strange(end, smallest, largest)
        most[k] = end
    return most, found == 0


@compiled
def rounded_down(row, smallest, largest):
    """Low ends, rounded down; and whether all of them are ordinary."""
    least, found = np.empty_like(row), NONE
    for k in range(len(row)):
        end = lowered(row[k], 0.0)
        found |= strange(end, smallest, largest)
        least[k] = end
    return least, found == 0


@compiled
def rounded_up(row, smallest, largest):
    """High ends, rounded up; and whether all of them are ordinary."""
    most, found = np.empty_like(row), NONE
    for k in range(len(row)):
        end = raised(row[k], 0.0)
        found |= strange(end, smallest, largest)
        most[k] = end
    return most, found == 0


@compiled
def sums_down(row_a, row_b, smallest, largest):
    """x + y, rounded down from the exact sum (its error by Knuth); and whether all of them are ordinary."""
    least, found = np.empty_like(row_a), NONE
    for k in range(len(row_a)):
        a, b = row_a[k], row_b[k]
        total = a + b
        of_b = total - a
        end = lowered(total, (a - (total - of_b)) + (b - of_b))
        found |= strange(end, smallest, largest)
        least[k] = end
    return least, found == 0


@compiled
def sums_up(row_a, row_b, smallest, largest):
    """x + y, rounded up from the exact sum; and whether all of them are ordinary."""
    most, found = np.empty_like(row_a), NONE
    for k in range(len(row_a)):
        a, b = row_a[k], row_b[k]
        total = a + b
        of_b = total - a
        end = raised(total, (a - (total - of_b)) + (b - of_b))
        found |= strange(end, smallest, largest)
        most[k] = end
    return most, found == 0


@compiled
def lesser(x, y):
    """The smaller number, NaN if either is, as NumPy's minimum."""
    return y if y < x or y != y else x


@compiled
def greater(x, y):
    """The larger number, NaN if either is, as NumPy's maximum."""
    return y if y > x or y != y else x


@compiled
def least_products(low_a, high_a, low_b, high_b):
    """The least product of two ends."""
    least = np.empty_like(low_a)
    for k in range(len(low_a)):
        a, b, c, d = low_a[k] * low_b[k], low_a[k] * high_b[k], high_a[k] * low_b[k], high_a[k] * high_b[k]
        least[k] = lesser(lesser(lesser(a, b), c), d)
    return least


@compiled
def most_products(low_a, high_a, low_b, high_b):
    """The largest product of two ends."""
    most = np.empty_like(low_a)
    for k in range(len(low_a)):
        a, b, c, d = low_a[k] * low_b[k], low_a[k] * high_b[k], high_a[k] * low_b[k], high_a[k] * high_b[k]
        most[k] = greater(greater(greater(a, b), c), d)
    return most
