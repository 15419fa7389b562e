"""The shader language's built-ins and its texture sampling, read plainly: one np.float32 at a time.

Imports nothing of the package. A vector is a list of np.float32; a picture is an ndarray [row, column] or
[row, column, channel], row 0 at the bottom; a texel is (column, row).
"""

from functools import reduce
from operator import add

import gmpy2
import numpy as np

F = np.float32
FLOAT32 = gmpy2.context(precision=24, emin=-148, emax=128, subnormalize=True)


def correctly_rounded(operation, *arguments):
    """A2: a function of MPFR at the precision and range of float32."""
    with gmpy2.context(FLOAT32):
        return F(float(operation(*(gmpy2.mpfr(float(v)) for v in arguments))))


def power(x, y):
    return correctly_rounded(lambda base, exponent: base**exponent, x, y)


def minimum(x, y):
    """A1: which operand a tie or a NaN gives is part of the rule."""
    return y if y < x else x


def maximum(x, y):
    return y if x < y else x


# Vectors


def added(a, b):
    return [p + q for p, q in zip(a, b, strict=True)]


def minus(a, b):
    return [p - q for p, q in zip(a, b, strict=True)]


def times(a, b):
    return [p * q for p, q in zip(a, b, strict=True)]


def scaled(a, s):
    return [p * s for p in a]


def negative(a):
    return [-p for p in a]


def dot(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(v):
    return np.sqrt(dot(v, v))


def normalize(v):
    magnitude = length(v)
    if magnitude == 0:
        return [F(0), F(0), F(0)]
    return [p / magnitude for p in v]


def reflect(i, n):
    return minus(i, scaled(n, F(2) * dot(n, i)))


def mix(a, b, t):
    return [p * (F(1) - t) + q * t for p, q in zip(a, b, strict=True)]


def transform(matrix, v):
    """A3: matrix * column vector, every row added from the left."""
    return [reduce(add, times(row, v)) for row in matrix]


# Sampling


def fetch(picture, column, row):
    """A list of the channels of a texel, or of the texel on the edge that is nearest to it."""
    height, width = picture.shape[:2]
    return list(np.atleast_1d(picture[min(max(row, 0), height - 1), min(max(column, 0), width - 1)]))


def four_texels(picture, corner):
    """Lower left, lower right, upper left, upper right."""
    column, row = corner
    return [fetch(picture, column + right, row + up) for up in (0, 1) for right in (0, 1)]


def nearest(picture, uv):
    height, width = picture.shape[:2]
    return fetch(picture, int(np.floor(uv[0] * F(width))), int(np.floor(uv[1] * F(height))))


def between_centres(picture, uv):
    """The texel to the lower left of uv, and how far uv lies to the right of and above its centre."""
    height, width = picture.shape[:2]
    return split([uv[0] * F(width) - F(0.5), uv[1] * F(height) - F(0.5)])


def split(position):
    """A position in texels as whole texels and a fraction."""
    whole = [np.floor(p) for p in position]
    return [int(p) for p in whole], minus(position, whole)


def bilinear(picture, corner, t):
    """R9: x first, then y."""
    lower_left, lower_right, upper_left, upper_right = four_texels(picture, corner)
    return mix(mix(lower_left, lower_right, t[0]), mix(upper_left, upper_right, t[0]), t[1])
