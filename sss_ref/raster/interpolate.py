"""Perspective-correct interpolation inside a piece (rule R5): in NumPy; kernels have it by rows.

The exact edge functions e_i are taken positive inside, whichever way the piece turns, and rounded once to float32:

    w_i = e_i * (1/w)_i        a = ((a0*w0 + a1*w1) + a2*w2) / ((w0 + w1) + w2)

Turning a piece round would negate e0, e1 and e2 together, which the quotient cannot see, except in the sign of a zero;
so the sign is part of the rule.
"""

import numpy as np

from sss_ref.raster.primitives import Primitives

NUMBERS_OR_NOT = np.errstate(all="ignore")  # a varying that is not finite stops the stage that reads it (A6)


@NUMBERS_OR_NOT
def weights_arrays(
    primitives: Primitives, piece: np.ndarray, column: np.ndarray, row: np.ndarray, step: int
) -> np.ndarray:
    """The weights of N fragments, float32 (3, N), by plain array code that shares nothing with the kernels.

    piece, column, row: integers (N,), a piece, and a pixel that it covers, or near which its plane is meant.
    step: 2^subpixel_bits.
    """
    corners = primitives.corners[piece].T
    x, y = np.moveaxis(primitives.snapped[corners].astype(np.int64), -1, 0)
    to_x, to_y = x - np.asarray(column, np.int64) * step, y - np.asarray(row, np.int64) * step
    opposite, next_one = [1, 2, 0], [2, 0, 1]
    e = to_x[opposite] * to_y[next_one] - to_x[next_one] * to_y[opposite]
    turn = np.where(e.sum(axis=0) < 0, -1, 1)
    weights: np.ndarray = (turn * e).astype(np.float32) * primitives.inverse_w[corners]
    return weights


@NUMBERS_OR_NOT
def interpolate_arrays(
    primitives: Primitives, piece: np.ndarray, column: np.ndarray, row: np.ndarray, step: int
) -> np.ndarray:
    """All attributes of N fragments, float32 (N, A); arguments as in `weights_arrays`."""
    w0, w1, w2 = weights_arrays(primitives, piece, column, row, step)[..., None]
    a0, a1, a2 = primitives.attributes[primitives.corners[piece].T]
    mixed: np.ndarray = ((a0 * w0 + a1 * w1) + a2 * w2) / ((w0 + w1) + w2)
    return mixed
