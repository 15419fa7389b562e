"""Numbers of about 100 bits as unevaluated sums of two float64: (head, tail), |tail| <= ulp(head)/2.

Plain functions on float64 scalars, without fused multiply-add. Sources: T. J. Dekker, "A floating-point technique for
extending the available precision", 1971; D. E. Knuth, "The Art of Computer Programming", vol. 2, 4.2.2;
M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
arithmetic", 2017.
"""

from typing import Any, TypeAlias

import numpy as np

DoubleDouble: TypeAlias = tuple[Any, Any]  # (head, tail), float64 each

SPLITTER = 134217729.0  # 2^27 + 1: cuts 53 bits into two halves whose products are exact


def two_sum(a: Any, b: Any) -> DoubleDouble:
    """Add: the rounded sum a + b and its rounding error, exactly (Knuth); any order of magnitude."""
    total = a + b
    b_part = total - a
    return total, (a - (total - b_part)) + (b - b_part)


def fast_two_sum(a: Any, b: Any) -> DoubleDouble:
    """Add as `two_sum` does, where |a| >= |b| (Dekker)."""
    total = a + b
    return total, b - (total - a)


def split(a: Any) -> DoubleDouble:
    """Cut a = upper + lower, at most 26 bits each (Dekker); |a| < 2^996."""
    scaled = SPLITTER * a
    upper = scaled - (scaled - a)
    return upper, a - upper


def two_prod(a: Any, b: Any) -> DoubleDouble:
    """Multiply: the rounded product a*b and its rounding error, exactly unless that error underflows (Dekker)."""
    product = a * b
    a_upper, a_lower = split(a)
    b_upper, b_lower = split(b)
    return product, ((a_upper * b_upper - product) + a_upper * b_lower + a_lower * b_upper) + a_lower * b_lower


def dd_add(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    """Add two double-doubles, relative error < 3.01 * 2^-106, cancellation included (Joldes, algorithm 6)."""
    heads, heads_error = two_sum(a[0], b[0])
    tails, tails_error = two_sum(a[1], b[1])
    head, tail = fast_two_sum(heads, heads_error + tails)
    return fast_two_sum(head, tail + tails_error)


def dd_mul(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    """Multiply two double-doubles, relative error < 7 * 2^-106 (Dekker's mul2; Joldes, algorithm 10)."""
    product, error = two_prod(a[0], b[0])
    return fast_two_sum(product, error + (a[0] * b[1] + a[1] * b[0]))


def dd_to_float32(a: DoubleDouble) -> Any:
    """Round head + tail once to the nearest float32, ties to even.

    A head that is no midpoint of two float32 lies on the same side of every midpoint as the sum, since a midpoint is
    a float64. On a midpoint the tail decides, so the head takes one step in its direction.
    """
    head, tail = a
    nearest = np.float32(head)
    across = 2.0 * head - np.float64(nearest)  # head is half-way between `nearest` and this
    is_midpoint = across != nearest and np.float32(across) == across
    if is_midpoint and tail != 0.0:
        return np.float32(np.nextafter(head, np.copysign(np.inf, tail)))
    return nearest
