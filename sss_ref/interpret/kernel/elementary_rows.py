"""The elementary functions on whole rows: brackets for all elements at once, then the few in doubt one by one.

rows: those of the arguments, then that of the result. The bits are those of `numerics.scalar`.
"""

import numpy as np

from sss_ref.interpret.kernel.row_memory import chosen, read_float, write_float
from sss_ref.numerics import scalar  # noqa: F401  # teaches numba what follows
from sss_ref.numerics.elementary import (
    exp2_bracket,
    exp2_slow,
    exp_bracket,
    exp_slow,
    log2_bracket,
    log2_slow,
    pow_bracket,
    pow_slow,
)

YES, NO = np.int32(1), np.int32(0)


def pow_row(scratch, count, rows, uniforms, tables):
    """x^y, correctly rounded."""
    base, exponent, result = rows[0], rows[1], rows[2]
    doubts = NO
    for k in range(count):
        x, y = np.float64(read_float(scratch, base + k)), np.float64(read_float(scratch, exponent + k))
        low, high = pow_bracket(x, y)
        write_float(0, scratch, result + k, low)
        doubts |= chosen(low < high, YES, NO)
    if doubts:
        for k in range(count):
            x, y = np.float64(read_float(scratch, base + k)), np.float64(read_float(scratch, exponent + k))
            low, high = pow_bracket(x, y)
            if low < high:
                write_float(0, scratch, result + k, pow_slow(x, y))


def exp_row(scratch, count, rows, uniforms, tables):
    """e^x, correctly rounded."""
    argument, result = rows[0], rows[1]
    doubts = NO
    for k in range(count):
        low, high = exp_bracket(np.float64(read_float(scratch, argument + k)))
        write_float(0, scratch, result + k, low)
        doubts |= chosen(low < high, YES, NO)
    if doubts:
        for k in range(count):
            x = np.float64(read_float(scratch, argument + k))
            low, high = exp_bracket(x)
            if low < high:
                write_float(0, scratch, result + k, exp_slow(x))


def exp2_row(scratch, count, rows, uniforms, tables):
    """2^x, correctly rounded."""
    argument, result = rows[0], rows[1]
    doubts = NO
    for k in range(count):
        low, high = exp2_bracket(np.float64(read_float(scratch, argument + k)))
        write_float(0, scratch, result + k, low)
        doubts |= chosen(low < high, YES, NO)
    if doubts:
        for k in range(count):
            x = np.float64(read_float(scratch, argument + k))
            low, high = exp2_bracket(x)
            if low < high:
                write_float(0, scratch, result + k, exp2_slow(x))


def log2_row(scratch, count, rows, uniforms, tables):
    """log2 x, correctly rounded."""
    argument, result = rows[0], rows[1]
    doubts = NO
    for k in range(count):
        low, high = log2_bracket(np.float64(read_float(scratch, argument + k)))
        write_float(0, scratch, result + k, low)
        doubts |= chosen(low < high, YES, NO)
    if doubts:
        for k in range(count):
            x = np.float64(read_float(scratch, argument + k))
            low, high = log2_bracket(x)
            if low < high:
                write_float(0, scratch, result + k, log2_slow(x))


ELEMENTARY_ROWS = {"pow": pow_row, "exp": exp_row, "exp2": exp2_row, "log2": log2_row}
