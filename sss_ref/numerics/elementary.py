"""Correctly rounded float32 pow, exp2, log2 and exp on arrays (rule A2).

Two steps (A. Ziv, "Fast evaluation of elementary mathematical functions with correctly rounded last bit", 1991).
A *bracket* takes float64 arguments, uses + - * and tables only, and rounds the ends of an interval that holds the
exact result to float32. Where the two differ (about once in a million), the *slow* function computes the result to
about 100 bits and rounds that. Brackets hold no branch, so the same function serves arrays and, compiled in `scalar`,
single values; the operations are those of IEEE 754 in a fixed order, so the bits agree.

Error analysis, with u = 2^-53, the relative error of one float64 operation:

* log2 x = (e + T) + p with x = 2^e * m, T = -log2 r, z = r*m - 1 (exact: r has 13 bits, m has 24), p = log2(1 + z).
  |z| < 2^-7. p = z*(C1 + z*(C2 + ...)): rounding C1, the last addition and the last product cost u each, all inner
  ones together .1 u, the terms left out .02 u; so p errs by at most 3.2 u|p|. Beside 1, e + T = 0 and that is all.
  Elsewhere T, e + T and the last sum err by u|T|, u|e + T| and u|log2 x|. If e = 0 the second is exact,
  otherwise |T| <= 1/2 <= |e + T|; |e + T| <= |log2 x| + |p| and |p| < .54 |log2 x|. Together below 6 u|log2 x|.
* 2^t = 2^q * 2^(j/32) * 2^f with f = t - (q + j/32) exact and |f| <= 1/64: the table, the last sum and the polynomial,
  which is below .011, cost 2.2 u.
* x^y = 2^t: t = y * log2 x errs by at most 7 u|t|, for e^x t = x * log2 e by 2.1 u|t|; relative to 2^t that is
  ln 2 = .69 times as much. Rounding the ends of the interval adds u.

So log2 errs by less than 2^-50 |log2 x| and 2^t by less than 2^-50 (|t| + 1) 2^t: the bounds below.

What is known: given these bounds, exp2, log2, exp and x^0.6 are right for every float32, since each argument in doubt
was compared with MPFR (`test_elementary_full`). For x^y in general it is not proven that 100 bits decide every case: of
about 2^60 pairs with a finite result other than 1, the hardest is expected to need 85.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from sss_ref.numerics import tables
from sss_ref.numerics.double_double import DoubleDouble, dd_add, dd_mul, dd_to_float32

RELATIVE_ERROR = 2.0**-50
EXPONENT_LIMIT = 200.0  # 2^200 overflows float32 and 2^-200 is below half its least subnormal
INFINITE_LOG = 2.0**1000  # stands for log2(inf): infinite as float32, yet times 0 it is 0

EXPONENT_SHIFT = 52  # bits of the mantissa of a float64
INDEX_SHIFT = 45  # the next 7 bits choose the interval
LOG_INTERVALS = 128
LEAST_MANTISSA = int(np.float64(181 / 256).view(np.int64))  # m lies in [181/256, 181/128)
ONE = int(np.float64(1.0).view(np.int64))

EXP2_STEP_BITS = 5
EXP2_STEPS = 1 << EXP2_STEP_BITS
INTEGER_ALIGNMENT = 1.5 * 2.0**52  # added to a number, it leaves the nearest integer in the low mantissa bits

C1, C2, C3, C4, C5, C6, C7, C8 = tables.LOG2_SERIES_HEAD[:8].tolist()
E1, E2, E3, E4, E5, E6 = tables.EXP2_SERIES_HEAD[:6].tolist()
LOG2_E = (float(tables.LOG2_E_HEAD[0]), float(tables.LOG2_E_TAIL[0]))
LOG2_TERMS = len(tables.LOG2_SERIES_HEAD)
EXP2_TERMS = len(tables.EXP2_SERIES_HEAD)
MIDPOINT_BITS = 25  # one more than a float32 has


def pow_array(x: Any, y: Any) -> Any:
    """Compute x^y, correctly rounded to float32.

    x, y: float32 arrays that broadcast, or np.float32 scalars; anything else is converted to float32 first.
    Returns a float32 array, or an np.float32 if both are scalars.
    x = 0 or inf: 0, 1 or inf as the sign of y demands, and 0^0 = inf^0 = 1; the sign of a zero is ignored.
    x < 0: NaN for every y, where GLSL leaves the result undefined. NaN propagates, and 1^inf is NaN (IEEE 754 powr).
    """
    return _evaluate(pow_bracket, pow_slow, x, y)


def exp2_array(x: Any) -> Any:
    """Compute 2^x, correctly rounded to float32; arguments and result as in `pow_array`. 2^-inf = 0, 2^inf = inf."""
    return _evaluate(exp2_bracket, exp2_slow, x)


def log2_array(x: Any) -> Any:
    """Compute log2(x), correctly rounded to float32; arguments and result as in `pow_array`.

    log2(0) = -inf, also for -0; log2(inf) = inf; x < 0 gives NaN.
    """
    return _evaluate(log2_bracket, log2_slow, x)


def exp_array(x: Any) -> Any:
    """Compute e^x, correctly rounded to float32; arguments and result as in `pow_array`. e^-inf = 0, e^inf = inf."""
    return _evaluate(exp_bracket, exp_slow, x)


def _evaluate(bracket: Callable[..., Any], slow: Callable[..., Any], *arguments: Any) -> Any:
    """Bracket every element, and compute those in doubt slowly, one by one."""
    with np.errstate(all="ignore"):
        operands = np.broadcast_arrays(*(np.asarray(a, np.float32).astype(np.float64) for a in arguments))
        low, high = bracket(*operands)
        result = np.array(low)
        for element in np.argwhere(low < high):
            place = tuple(element)
            result[place] = slow(*(operand[place] for operand in operands))
    return result[()]


def pow_bracket(x: Any, y: Any) -> tuple[Any, Any]:
    """Enclose x^y = 2^(y log2 x) between two float32, equal unless the rounding is in doubt; x, y float64."""
    return _enclose_exp2(y * _log2(x))


def exp2_bracket(x: Any) -> tuple[Any, Any]:
    """Enclose 2^x between two float32."""
    return _enclose_exp2(x)


def exp_bracket(x: Any) -> tuple[Any, Any]:
    """Enclose e^x = 2^(x log2 e) between two float32."""
    return _enclose_exp2(x * LOG2_E[0])


def log2_bracket(x: Any) -> tuple[Any, Any]:
    """Enclose log2 x between two float32."""
    logarithm = _log2(x)
    error = np.abs(logarithm) * RELATIVE_ERROR
    return np.float32(logarithm - error), np.float32(logarithm + error)


def _enclose_exp2(t: Any) -> tuple[Any, Any]:
    """Enclose 2^t between two float32, where t errs by at most 7 u|t|."""
    exponent = np.minimum(np.maximum(t, -EXPONENT_LIMIT), EXPONENT_LIMIT)
    power = _exp2(exponent)
    error = power * (RELATIVE_ERROR * (np.abs(exponent) + 1.0))
    return np.float32(power - error), np.float32(power + error)


def _log2(x: Any) -> Any:
    """Compute log2 x in float64; x holds a float32. Infinite results are +-INFINITE_LOG, x < 0 and NaN give NaN."""
    exponent, interval, z = _reduce(np.abs(x))
    p = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * (C6 + z * (C7 + z * C8)))))))
    logarithm = (exponent + tables.LOG2_INTERVAL_HEAD[interval]) + p
    logarithm = select(x > 0.0, logarithm, np.nan)
    logarithm = select(x == 0.0, -INFINITE_LOG, logarithm)
    return select(x == np.inf, INFINITE_LOG, logarithm)


def _exp2(t: Any) -> Any:
    """Compute 2^t in float64 for |t| <= EXPONENT_LIMIT; NaN propagates."""
    aligned = t * EXP2_STEPS + INTEGER_ALIGNMENT
    f = t - (aligned - INTEGER_ALIGNMENT) * (1.0 / EXP2_STEPS)
    steps = _bits(aligned)
    fraction = tables.EXP2_STEP_HEAD[steps & (EXP2_STEPS - 1)]
    p = f * (E1 + f * (E2 + f * (E3 + f * (E4 + f * (E5 + f * E6)))))
    return (fraction + fraction * p) * _power_of_two(steps >> EXP2_STEP_BITS)


def _reduce(x: Any) -> tuple[Any, Any, Any]:
    """Write x = 2^exponent * (1 + z) / RECIPROCAL[interval] for x > 0 (float64 holding a float32), z exact.

    Subtracting the bits of the least mantissa moves the border between two exponents from 1 to 181/256, about
    sqrt(1/2): for x near 1 the exponent is then 0 on both sides, and nothing cancels.
    """
    bits = _bits(x)
    offset = bits - LEAST_MANTISSA
    exponent = offset >> EXPONENT_SHIFT
    interval = (offset >> INDEX_SHIFT) & (LOG_INTERVALS - 1)
    mantissa = _from_bits(bits - (exponent << EXPONENT_SHIFT))
    return exponent, interval, mantissa * tables.RECIPROCAL[interval] - 1.0


def _bits(x: Any) -> Any:
    """Reinterpret float64 as int64; `scalar` gives it its compiled form."""
    return x.view(np.int64)


def _from_bits(bits: Any) -> Any:
    """Reinterpret int64 as float64."""
    return np.int64(bits).view(np.float64)


def _power_of_two(exponent: Any) -> Any:
    """Build the float64 2^exponent; only the low 12 bits of `exponent` (int64) count."""
    return _from_bits((exponent << EXPONENT_SHIFT) + ONE)


def select(condition: Any, if_true: Any, if_false: Any) -> Any:
    """Choose per element; `scalar` gives it its compiled form."""
    return np.where(condition, if_true, if_false)[()]


def pow_slow(x: Any, y: Any) -> Any:
    """Round x^y to float32 from about 100 bits; x > 0 and y float64 scalars, |y log2 x| < EXPONENT_LIMIT."""
    head, tail = _exp2_dd(dd_mul(_log2_dd(x), (y, 0.0)))
    return dd_to_float32((head, 0.0 if _can_be_tie(x, y) else tail))


def exp2_slow(x: Any) -> Any:
    """Round 2^x to float32 from about 100 bits; the only tie, 2^-150, is computed exactly."""
    return dd_to_float32(_exp2_dd((x, 0.0)))


def exp_slow(x: Any) -> Any:
    """Round e^x to float32 from about 100 bits; e^x is irrational for x other than 0."""
    return dd_to_float32(_exp2_dd(dd_mul(LOG2_E, (x, 0.0))))


def log2_slow(x: Any) -> Any:
    """Round log2 x to float32 from about 100 bits; it is an integer or irrational, hence never a tie."""
    return dd_to_float32(_log2_dd(x))


def _log2_dd(x: Any) -> DoubleDouble:
    """Compute log2 x for x > 0, relative error about 2^-102."""
    exponent, interval, z = _reduce(x)
    series = (0.0, 0.0)
    for k in range(LOG2_TERMS - 1, -1, -1):
        coefficient = (tables.LOG2_SERIES_HEAD[k], tables.LOG2_SERIES_TAIL[k])
        series = dd_mul(dd_add(coefficient, series), (z, 0.0))
    interval_log = (tables.LOG2_INTERVAL_HEAD[interval], tables.LOG2_INTERVAL_TAIL[interval])
    return dd_add(dd_add((np.float64(exponent), 0.0), interval_log), series)


def _exp2_dd(t: DoubleDouble) -> DoubleDouble:
    """Compute 2^t for |t| <= EXPONENT_LIMIT; the relative error is that of t times |t|, and 2^-102."""
    steps = np.floor(t[0] * EXP2_STEPS + 0.5)
    f = dd_add(t, (-steps / EXP2_STEPS, 0.0))
    series = (0.0, 0.0)
    for k in range(EXP2_TERMS - 1, -1, -1):
        coefficient = (tables.EXP2_SERIES_HEAD[k], tables.EXP2_SERIES_TAIL[k])
        series = dd_mul(dd_add(coefficient, series), f)
    step = np.int64(steps) & (EXP2_STEPS - 1)
    fraction = (tables.EXP2_STEP_HEAD[step], tables.EXP2_STEP_TAIL[step])
    head, tail = dd_mul(fraction, dd_add((1.0, 0.0), series))
    scale = _power_of_two(np.int64(steps) >> EXP2_STEP_BITS)
    return head * scale, tail * scale


def _can_be_tie(x: Any, y: Any) -> bool:
    """Tell whether x^y is a dyadic fraction short enough to be a midpoint of two float32, in exact arithmetic.

    Take square roots of x while y is no integer and they are exact; x is then an odd number times a power of two,
    y an integer, and x^y has as many bits as odd^y. Otherwise x^y is irrational, or its odd denominator is above 1.
    A root is exact if it is a float32: two numbers of 24 and 48 bits that are not the same are 2^-48 apart at least.
    """
    while y != np.floor(y):
        root = np.sqrt(x)
        if np.float32(root) != root:
            return False
        x, y = root, 2.0 * y
    bits = y * _log2(_odd_part(x))
    return bool(0.0 <= bits < MIDPOINT_BITS)


def _odd_part(x: Any) -> Any:
    """Divide x > 0 by the greatest power of two that leaves an integer."""
    bits = _bits(x)
    mantissa = (bits & ((1 << EXPONENT_SHIFT) - 1)) | (1 << EXPONENT_SHIFT)
    return np.float64(mantissa // (mantissa & -mantissa))
