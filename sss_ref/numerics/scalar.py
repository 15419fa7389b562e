"""The compiled scalar forms of `elementary`: float32 in, float32 out, the bits of the array forms.

Importing this module teaches numba the plain functions of `elementary` and `double_double`; with NUMBA_DISABLE_JIT=1
the same code runs as plain Python. Special values are those of the array forms.
"""

from typing import Any

import numpy as np
from numba.extending import overload, register_jitable

from sss_ref.cache.compiled import compiled
from sss_ref.numerics import double_double, elementary

PLAIN_FUNCTIONS = (
    double_double.two_sum,
    double_double.fast_two_sum,
    double_double.split,
    double_double.two_prod,
    double_double.dd_add,
    double_double.dd_mul,
    double_double.dd_to_float32,
    elementary.pow_bracket,
    elementary.exp2_bracket,
    elementary.exp_bracket,
    elementary.log2_bracket,
    elementary._enclose_exp2,
    elementary._log2,
    elementary._exp2,
    elementary._reduce,
    elementary._from_bits,
    elementary._power_of_two,
    elementary.pow_slow,
    elementary.exp2_slow,
    elementary.exp_slow,
    elementary.log2_slow,
    elementary._log2_dd,
    elementary._exp2_dd,
    elementary._can_be_tie,
    elementary._odd_part,
)

for function in PLAIN_FUNCTIONS:
    register_jitable(error_model="numpy")(function)  # spelled out: a callee keeps its own error model


@overload(elementary.select, jit_options={"error_model": "numpy"})
def _select(condition, if_true, if_false):  # no annotations: numba wants the signature of what is returned
    return lambda condition, if_true, if_false: if_true if condition else if_false


@overload(elementary._bits, jit_options={"error_model": "numpy"})
def _bits(x):  # numba views a float only right after a conversion, which changes nothing
    return lambda x: np.float64(x).view(np.int64)


@compiled
def pow_scalar(x: Any, y: Any) -> Any:
    """Compute x^y as `elementary.pow_array` does."""
    base, exponent = np.float64(np.float32(x)), np.float64(np.float32(y))
    low, high = elementary.pow_bracket(base, exponent)
    if low < high:
        return elementary.pow_slow(base, exponent)
    return low


@compiled
def exp2_scalar(x: Any) -> Any:
    """Compute 2^x as `elementary.exp2_array` does."""
    exponent = np.float64(np.float32(x))
    low, high = elementary.exp2_bracket(exponent)
    if low < high:
        return elementary.exp2_slow(exponent)
    return low


@compiled
def log2_scalar(x: Any) -> Any:
    """Compute log2 x as `elementary.log2_array` does."""
    argument = np.float64(np.float32(x))
    low, high = elementary.log2_bracket(argument)
    if low < high:
        return elementary.log2_slow(argument)
    return low


@compiled
def exp_scalar(x: Any) -> Any:
    """Compute e^x as `elementary.exp_array` does."""
    exponent = np.float64(np.float32(x))
    low, high = elementary.exp_bracket(exponent)
    if low < high:
        return elementary.exp_slow(exponent)
    return low


SCALARS = {"pow": pow_scalar, "exp": exp_scalar, "exp2": exp2_scalar, "log2": log2_scalar}  # by GLSL's names
