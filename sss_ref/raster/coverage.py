"""Which samples a piece covers: exact edge functions, and the one place where the fill rule lives (rule R3).

Window positions are whole numbers of 1/2^bits pixel, counted from the centre of pixel (0, 0). The sample of pixel
(column, row) is therefore (column*step, row*step) with step = 2^bits, and no rounding enters anywhere in this file:
edge functions are whole numbers below 2^53, exact in float64, which processors divide faster than integers.
"""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import part_of_kernels


class EdgeFunction(NamedTuple):
    """e(column, row) = (constant + column*per_column) + row*per_row, whole float64, in squared snapped units.

    Twice the area that the edge spans with the sample; positive on the inner side whichever way the piece turns.
    """

    constant: float
    per_column: float
    per_row: float


@part_of_kernels
def position(snapped, vertex):
    """Window position (x, y) of a vertex, as float64: products of two are exact."""
    return np.float64(snapped[vertex, 0]), np.float64(snapped[vertex, 1])


@part_of_kernels
def twice_area(a, b, c):
    """Twice the signed area of the corners (x, y): positive when they run counter-clockwise, rows counted upwards."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])


@part_of_kernels
def edge_function(start, end, orientation, step):
    """The edge from `start` to `end` of a piece that turns counter-clockwise (orientation +1) or clockwise (-1)."""
    dx = orientation * (end[0] - start[0])
    dy = orientation * (end[1] - start[1])
    constant = dy * start[0] - dx * start[1]
    return EdgeFunction(np.float64(constant), np.float64(-dy * step), np.float64(dx * step))


@part_of_kernels
def edges(primitives, piece, step):
    """The three edge functions of a piece; number i is opposite corner i, so it is what weighs corner i."""
    a = position(primitives.snapped, primitives.corners[piece, 0])
    b = position(primitives.snapped, primitives.corners[piece, 1])
    c = position(primitives.snapped, primitives.corners[piece, 2])
    turn = 1.0 if twice_area(a, b, c) > 0 else -1.0
    return edge_function(b, c, turn, step), edge_function(c, a, turn, step), edge_function(a, b, turn, step)


@part_of_kernels
def at(edge, column, row):
    """The edge function's exact value at the sample of a pixel."""
    return (edge.constant + column * edge.per_column) + row * edge.per_row


@part_of_kernels
def owns_its_samples(edge):
    """The fill rule: a sample on the edge is inside if the edge is a left one or a minimum-row horizontal one.

    On a left edge the inside lies towards larger columns, on a minimum-row edge towards larger rows: e grows there.
    """
    return edge.per_column > 0 or (edge.per_column == 0 and edge.per_row > 0)


@part_of_kernels
def least(edge):
    """The least value of an edge function at a sample that is covered: 1 where the edge does not own its samples."""
    return 0.0 if owns_its_samples(edge) else 1.0


@part_of_kernels
def acceptance(edge):
    """The edge function lowered by its least value: covered means value >= 0."""
    return EdgeFunction(edge.constant - least(edge), edge.per_column, edge.per_row)


@part_of_kernels
def accepted_columns(edge, row, first, last):
    """The part of the columns first..last of a row where an acceptance is >= 0, all of them whole float64.

    The floor of the rounded quotient is that of the quotient: per_column is at most 2^33, so a quotient that is not
    whole is at least 2^-33 away from a whole one, and float64 numbers below 2^15 lie closer. Larger is no column.
    """
    value = edge.constant + row * edge.per_row
    if edge.per_column > 0:
        return max(first, -np.floor(value / edge.per_column)), last
    if edge.per_column < 0:
        return first, min(last, np.floor(value / -edge.per_column))
    return first, (last if value >= 0 else first - 1.0)


@part_of_kernels
def covered_columns(acceptances, row, first, last):
    """The columns of first..last that all three acceptances leave: (first, last), empty where last < first."""
    low, high = accepted_columns(acceptances[0], row, np.float64(first), np.float64(last))
    low, high = accepted_columns(acceptances[1], row, low, high)
    low, high = accepted_columns(acceptances[2], row, low, high)
    return np.int64(low), np.int64(high)
