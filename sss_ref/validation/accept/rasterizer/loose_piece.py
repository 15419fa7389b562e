"""A piece whose corners lie somewhere in their boxes: which samples it may and must cover, and how deep it is there.

An edge function over boxes is an interval: above 0 the sample lies inside wherever the corners are, below 0 outside.
"""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled

FLOAT64 = 2.0**-50  # relative rounding of an edge function in float64, with room
DEPTH = 2.0**-22  # rounding of a depth that is interpolated in float32


class Geometry(NamedTuple):
    """What the kernels read of the boxes: float64 (V, 2) twice, (V,) twice and (P, 2), and the resolution."""

    centre: np.ndarray
    half: np.ndarray
    depth: np.ndarray
    depth_error: np.ndarray
    rounding: np.ndarray
    step: int
    turn: int  # of a layout: 1 where the first piece is seen, -1 where the last is; 0: the nearest
    depth_step: float


class Side(NamedTuple):
    """An edge from vertex a to vertex b, pixels, float64: the boxes' middles and half widths, and the hull of both."""

    ax: float
    ay: float
    bx: float
    by: float
    half_ax: float
    half_ay: float
    half_bx: float
    half_by: float
    least_x: float
    most_x: float
    least_y: float
    most_y: float


class Depths(NamedTuple):
    """The depths of a piece: at its corners, the least and most of these, how far they may be off, and their plane."""

    a: float
    b: float
    c: float
    least: float
    most: float
    error: float
    plane_rounding: float


class LoosePiece(NamedTuple):
    """A piece of which each side is known as far as the boxes tell; number k is opposite to corner k.

    turn: of a layout the piece's turn, by which it is seen; is_laid_out: whether it is one.
    """

    sides: tuple[Side, Side, Side]
    depths: Depths
    turn: float
    is_laid_out: bool


@compiled
def reached(primitives, geometry, piece, axis, size):
    """The columns (axis 0) or rows (axis 1) whose samples the piece can reach, first and last."""
    low, high = np.inf, -np.inf
    for k in range(3):
        vertex = primitives.corners[piece, k]
        if not primitives.inverse_w[vertex] > 0:
            return 0, -1
        low = min(low, geometry.centre[vertex, axis] - geometry.half[vertex, axis])
        high = max(high, geometry.centre[vertex, axis] + geometry.half[vertex, axis])
    return int(np.ceil(max(low, 0.0))), int(np.floor(min(high, size - 1.0)))


@compiled
def loose_piece(primitives, geometry, piece):
    """All that the samples of a piece need to know of it."""
    a, b, c = primitives.corners[piece]
    sides = (side(geometry, b, c), side(geometry, c, a), side(geometry, a, b))
    depths = depths_of(geometry, a, b, c, plane_rounding(primitives, geometry, piece))
    return LoosePiece(sides, depths, float(geometry.turn * piece), geometry.turn != 0)


@compiled
def side(geometry, a, b):
    """The side between two vertices."""
    ax, ay, bx, by = geometry.centre[a, 0], geometry.centre[a, 1], geometry.centre[b, 0], geometry.centre[b, 1]
    rax, ray, rbx, rby = geometry.half[a, 0], geometry.half[a, 1], geometry.half[b, 0], geometry.half[b, 1]
    least_x, most_x = min(ax - rax, bx - rbx), max(ax + rax, bx + rbx)
    least_y, most_y = min(ay - ray, by - rby), max(ay + ray, by + rby)
    return Side(ax, ay, bx, by, rax, ray, rbx, rby, least_x, most_x, least_y, most_y)


@compiled
def depths_of(geometry, a, b, c, rounding):
    """The depths of a piece; rounding: that of its plane."""
    values, errors = geometry.depth, geometry.depth_error
    least, most = min(values[a], values[b], values[c]), max(values[a], values[b], values[c])
    error = max(0.0, errors[a], errors[b], errors[c])
    error += DEPTH + geometry.depth_step
    return Depths(values[a], values[b], values[c], least, most, error, (most - least) * rounding)


@compiled
def plane_rounding(primitives, geometry, piece):
    """How far a plane is rounded that changes by 1 over a piece, times twice the piece's area."""
    rounding = 0.0
    for axis in range(2):
        low, high = np.inf, -np.inf
        for k in range(3):
            place = geometry.centre[primitives.corners[piece, k], axis]
            low, high = min(low, place), max(high, place)
        rounding += geometry.rounding[piece, 1 - axis] * (high - low)
    return rounding


@compiled
def cover(piece, column, row):
    """Whether a piece may cover a sample, whether it must, and the bits of the edges that may lie on either side."""
    positive, negative, above, below, band = True, True, True, True, 0
    for k in range(3):
        low, high = edge(piece.sides[k], column, row)
        positive, negative = positive and high >= 0, negative and low <= 0
        above, below = above and low > 0, below and high < 0
        if low <= 0 <= high and beside(piece.sides[k], column, row):
            band |= 1 << k
    return positive or negative, above or below, band


@compiled
def edge(side, column, row):
    """The interval of the edge function of two vertices at a sample: (a - p) x (b - p) over both boxes."""
    ax, ay, bx, by = side.ax - column, side.ay - row, side.bx - column, side.by - row
    rax, ray, rbx, rby = side.half_ax, side.half_ay, side.half_bx, side.half_by
    change = abs(ax) * rby + abs(by) * rax + rax * rby + abs(ay) * rbx + abs(bx) * ray + ray * rbx
    change += FLOAT64 * (abs(ax * by) + abs(ay * bx))
    value = ax * by - ay * bx
    return value - change, value + change


@compiled
def beside(side, column, row):
    """Whether a sample is between the boxes of two vertices along both axes."""
    return side.least_x <= column <= side.most_x and side.least_y <= row <= side.most_y


@compiled
def key(piece, column, row):
    """The interval of what decides whether a piece is seen, the least is: its depth, or its turn in a layout."""
    if piece.is_laid_out:
        return piece.turn, piece.turn
    depths = piece.depths
    e0, r0 = middle(edge(piece.sides[0], column, row))
    e1, r1 = middle(edge(piece.sides[1], column, row))
    e2, r2 = middle(edge(piece.sides[2], column, row))
    area, slack = e0 + e1 + e2, r0 + r1 + r2
    least, most, error = depths.least, depths.most, depths.error
    if abs(area) <= slack:
        return least - (most - least) - error, most + (most - least) + error
    depth = (depths.a * e0 + depths.b * e1 + depths.c * e2) / area
    spread = abs(depths.a - depth) * r0 + abs(depths.b - depth) * r1 + abs(depths.c - depth) * r2
    spread += depths.plane_rounding
    spread = spread / (abs(area) - slack) + error
    return depth - spread, depth + spread


@compiled
def middle(interval):
    """The middle of an interval and half its width."""
    low, high = interval
    return (low + high) * 0.5, (high - low) * 0.5
