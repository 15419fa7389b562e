"""The elementary functions on whole rows: brackets for all elements at once, then the few in doubt one by one.

rows: those of the arguments, then that of the result. The bits are those of `numerics.scalar`.
"""

import numpy as np

from sss_ref.interpret.kernel.row_memory import chosen, read_float, write_float
from sss_ref.numerics.elementary import exp2_bracket, exp_bracket, log2_bracket, pow_bracket
from sss_ref.numerics.scalar import exp2_scalar, exp_scalar, log2_scalar, pow_scalar

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
            power = pow_scalar(read_float(scratch, base + k), read_float(scratch, exponent + k))
            write_float(0, scratch, result + k, power)


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
            write_float(0, scratch, result + k, exp_scalar(read_float(scratch, argument + k)))


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
            write_float(0, scratch, result + k, exp2_scalar(read_float(scratch, argument + k)))


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
            write_float(0, scratch, result + k, log2_scalar(read_float(scratch, argument + k)))


ELEMENTARY_ROWS = {"pow": pow_row, "exp": exp_row, "exp2": exp2_row, "log2": log2_row}
