"""From float64 to the grid of float32: to the nearest number, or to the one on a given side."""

from typing import Any

import numpy as np

LARGEST = float(np.finfo(np.float32).max)
SMALLEST_NORMAL = 2.0**-126
UNIT = 2.0**-23  # the ULP of 1
DROPPED = np.int64((1 << 29) - 1)  # the bits of a float64's significand that float32 does not have
EXPONENT = np.int64(0x7FF << 52)


def nearest(x: Any) -> np.ndarray:
    """Round to float32, ties to even; the result is float64, as all numbers here."""
    return np.asarray(x).astype(np.float32).astype(np.float64)


def two_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """The float64 sum and its error: sum + error is a + b exactly (Knuth)."""
    total = a + b
    of_b = total - a
    return total, (a - (total - of_b)) + (b - of_b)


def downward(x: Any, error: Any = None) -> np.ndarray:
    """The largest number of float32's precision that is <= x + error; float32's range does not bound it.

    error: what float64 has lost of the exact value, at most half of its own last place; None: nothing.
    """
    bits = np.asarray(x).view(np.int64)
    sign = bits >> 63  # -1 or 0
    away = bits + (DROPPED & sign)  # below zero, down is away from zero
    if error is not None:
        away = away - (error < 0) * (sign | 1)
    return (away & ~DROPPED).view(np.float64)


def upward(x: Any, error: Any = None) -> np.ndarray:
    """The smallest number of float32's precision that is >= x + error."""
    bits = np.asarray(x).view(np.int64)
    sign = bits >> 63
    away = bits + (DROPPED & ~sign)  # above zero, up is away from zero
    if error is not None:
        away = away + (error > 0) * (sign | 1)
    return (away & ~DROPPED).view(np.float64)


def ulp(x: Any) -> np.ndarray:
    """Float32's unit in the last place at x; 0 at 0."""
    return (np.asarray(x).view(np.int64) & EXPONENT).view(np.float64) * UNIT
