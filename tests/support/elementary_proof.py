"""The elementary functions beside MPFR: arguments that reach every corner, and how many results are misrounded."""

import math

import gmpy2
import numba
import numpy as np

from sss_ref.numerics import elementary, scalar

FLOAT32 = gmpy2.context(precision=24, emin=-148, emax=128, subnormalize=True)
MPFR = {"pow": lambda x, y: x**y, "exp2": gmpy2.exp2, "log2": gmpy2.log2, "exp": gmpy2.exp}
NAMES = tuple(MPFR)


def array_form(name, *arguments):
    return getattr(elementary, f"{name}_array")(*arguments)


@numba.njit(error_model="numpy")
def each(function, x, result):
    for i in range(x.size):
        result[i] = function(x[i])


@numba.njit(error_model="numpy")
def each_pair(function, x, y, result):
    for i in range(x.size):
        result[i] = function(x[i], y[i])


def scalar_form(name, *arguments):
    """The compiled scalar function, applied to every element."""
    result = np.empty_like(arguments[0])
    (each_pair if name == "pow" else each)(getattr(scalar, f"{name}_scalar"), *arguments, result)
    return result


def mpfr(name, *arguments):
    """The function by MPFR: 24 bits, the exponents of float32, subnormals, ties to even."""
    with FLOAT32:
        return np.array(
            [
                float(MPFR[name](*map(gmpy2.mpfr, values)))
                for values in zip(*(a.tolist() for a in arguments), strict=True)
            ],
            np.float32,
        )


def sample(name, count, seed):
    """Arguments that reach overflow, subnormals and the neighbourhood of 1."""
    rng = np.random.default_rng(seed)
    if name == "pow":
        near_one = 1.0 + rng.standard_normal(count // 4) * np.exp2(rng.uniform(-23.0, -3.0, count // 4))
        x = np.concatenate([np.exp2(rng.uniform(-149.0, 128.0, count - near_one.size)), near_one]).astype(np.float32)
        result_log2 = rng.uniform(-152.0, 129.0, count)
        with np.errstate(all="ignore"):
            y = np.where(x == 1.0, 1.0, result_log2 / np.log2(x.astype(np.float64)))
        return np.abs(x), y.astype(np.float32)
    if name == "log2":
        near_one = 1.0 + rng.uniform(-0.3, 0.4, count // 2)
        return (
            np.concatenate([np.exp2(rng.uniform(-149.0, 128.0, count - near_one.size)), near_one]).astype(np.float32),
        )
    small = rng.choice([-1.0, 1.0], count // 4) * np.exp2(rng.uniform(-30.0, 0.0, count // 4))
    spread = rng.uniform(-152.0, 129.0, count - small.size) * (1.0 if name == "exp2" else math.log(2.0))
    return (np.concatenate([spread, small]).astype(np.float32),)


def thickness_stride(first, step):
    """Every step-th float32 of the three binades [1/2, 4), the thicknesses of the paper's d^0.6."""
    start, stop = (int(np.float32(v).view(np.int32)) for v in (0.5, 4.0))
    x = np.arange(start + first, stop, step, dtype=np.int32).view(np.float32)
    return x, np.full_like(x, 0.6)


def misrounded(name, *arguments):
    """How many results of either form differ from MPFR."""
    wanted = mpfr(name, *arguments)
    by_array, by_scalar = array_form(name, *arguments), scalar_form(name, *arguments)
    return int(np.count_nonzero((by_array != wanted) | (by_scalar != wanted)))
