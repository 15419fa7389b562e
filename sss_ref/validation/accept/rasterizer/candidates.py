"""Which pieces a processor may show at each pixel: those that its boxes let cover the sample, and not certainly behind.

An edge function over boxes is an interval: above 0 the sample lies inside wherever the corners are, below 0 outside.
"""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.raster.coverage import acceptance, at, edges
from sss_ref.validation.accept.rasterizer.boxes import Boxes

FLOAT64 = 2.0**-50  # relative rounding of an edge function in float64, with room
DEPTH = 2.0**-22  # rounding of a depth that is interpolated in float32
FAR = 1.0


class Candidates(NamedTuple):
    """Pieces that may be seen, those of one pixel side by side in scene order (M,).

    pixel: int64, row*width + column. piece: int32. low, high: float64, what decides which is seen: the depth, or the
    turn in a layout. inside: bool, whether it covers the sample where the oracle has the corners. certain: bool,
    wherever a processor may have them. band: uint8, bit k where the sample may lie on either side of the edge opposite
    to corner k.
    """

    pixel: np.ndarray
    piece: np.ndarray
    low: np.ndarray
    high: np.ndarray
    inside: np.ndarray
    certain: np.ndarray
    band: np.ndarray


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


def candidates(boxes: Boxes, turn: int, depth_step: float) -> Candidates:
    """All candidates of a draw. turn, depth_step: as in `Geometry`."""
    primitives, viewport = boxes.primitives, boxes.viewport
    depth = primitives.depth.astype(np.float64)
    geometry = Geometry(
        boxes.centre, boxes.half, depth, boxes.depth_error, boxes.rounding, viewport.step, turn, depth_step
    )
    nearest = np.full((viewport.height, viewport.width), np.inf)
    find_nearest(primitives, geometry, nearest)
    found = Candidates(*list_candidates(primitives, geometry, nearest))
    order = np.argsort(found.pixel, kind="stable")
    return Candidates(*(column[order] for column in found))


@compiled
def find_nearest(primitives, geometry, nearest):
    """Lower `nearest` (H, W) to the far end of each piece that covers the sample for certain."""
    height, width = nearest.shape
    for piece in range(len(primitives.corners)):
        first_column, last_column = reached(primitives, geometry, piece, 0, width)
        first_row, last_row = reached(primitives, geometry, piece, 1, height)
        for row in range(first_row, last_row + 1):
            for column in range(first_column, last_column + 1):
                _, must, _ = cover(primitives, geometry, piece, column, row)
                if must:
                    _, high = key(primitives, geometry, piece, column, row)
                    if high < nearest[row, column] and (high < FAR or geometry.turn != 0):
                        nearest[row, column] = high


@compiled
def list_candidates(primitives, geometry, nearest):
    """The columns of `Candidates`, in scene order: pieces that may cover a sample in front of what is certain there."""
    height, width = nearest.shape
    size, count = max(1024, nearest.size), 0
    pixel, pieces = np.empty(size, np.int64), np.empty(size, np.int32)
    low, high = np.empty(size), np.empty(size)
    inside, certain, band = np.empty(size, np.bool_), np.empty(size, np.bool_), np.empty(size, np.uint8)
    for piece in range(len(primitives.corners)):
        first_column, last_column = reached(primitives, geometry, piece, 0, width)
        first_row, last_row = reached(primitives, geometry, piece, 1, height)
        for row in range(first_row, last_row + 1):
            for column in range(first_column, last_column + 1):
                may, must, bits = cover(primitives, geometry, piece, column, row)
                if not may:
                    continue
                least, most = key(primitives, geometry, piece, column, row)
                if least > nearest[row, column] or (least >= FAR and geometry.turn == 0):
                    continue
                if count == size:
                    size *= 2
                    pixel, pieces = grown(pixel), grown(pieces)
                    low, high = grown(low), grown(high)
                    inside, certain, band = grown(inside), grown(certain), grown(band)
                pixel[count], pieces[count] = row * width + column, piece
                low[count], high[count] = least, most
                inside[count] = is_inside(primitives, piece, column, row, geometry.step)
                certain[count], band[count] = must, bits
                count += 1
    return pixel[:count], pieces[:count], low[:count], high[:count], inside[:count], certain[:count], band[:count]


@compiled
def grown(array):
    """An array with room for as many again."""
    return np.concatenate((array, np.empty_like(array)))


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
    return int(max(np.ceil(max(low, 0.0)), 0)), int(min(np.floor(min(high, size - 1.0)), size - 1))


@compiled
def cover(primitives, geometry, piece, column, row):
    """Whether a piece may cover a sample, whether it must, and the bits of the edges that may lie on either side."""
    positive, negative, above, below, band = True, True, True, True, 0
    for k in range(3):
        a, b = primitives.corners[piece, (k + 1) % 3], primitives.corners[piece, (k + 2) % 3]
        low, high = edge(geometry, a, b, column, row)
        positive, negative = positive and high >= 0, negative and low <= 0
        above, below = above and low > 0, below and high < 0
        if low <= 0 <= high and beside(geometry, a, b, column, row):
            band |= 1 << k
    return positive or negative, above or below, band


@compiled
def edge(geometry, a, b, column, row):
    """The interval of the edge function of two vertices at a sample: (a - p) x (b - p) over both boxes."""
    ax, ay = geometry.centre[a, 0] - column, geometry.centre[a, 1] - row
    bx, by = geometry.centre[b, 0] - column, geometry.centre[b, 1] - row
    rax, ray, rbx, rby = geometry.half[a, 0], geometry.half[a, 1], geometry.half[b, 0], geometry.half[b, 1]
    change = abs(ax) * rby + abs(by) * rax + rax * rby + abs(ay) * rbx + abs(bx) * ray + ray * rbx
    change += FLOAT64 * (abs(ax * by) + abs(ay * bx))
    value = ax * by - ay * bx
    return value - change, value + change


@compiled
def beside(geometry, a, b, column, row):
    """Whether a sample is between the boxes of two vertices along both axes."""
    inside = True
    for axis, sample in ((0, column), (1, row)):
        low = min(geometry.centre[a, axis] - geometry.half[a, axis], geometry.centre[b, axis] - geometry.half[b, axis])
        high = max(geometry.centre[a, axis] + geometry.half[a, axis], geometry.centre[b, axis] + geometry.half[b, axis])
        inside = inside and low <= sample <= high
    return inside


@compiled
def is_inside(primitives, piece, column, row, step):
    """Whether the oracle covers the sample with this piece (rule R3)."""
    e0, e1, e2 = edges(primitives, piece, step)
    if at(e0, column, row) + at(e1, column, row) + at(e2, column, row) == 0:
        return False
    inside = at(acceptance(e0), column, row) >= 0 and at(acceptance(e1), column, row) >= 0
    return inside and at(acceptance(e2), column, row) >= 0


@compiled
def key(primitives, geometry, piece, column, row):
    """The interval of what decides whether a piece is seen, the least is: its depth, or its turn in a layout."""
    if geometry.turn != 0:
        return float(geometry.turn * piece), float(geometry.turn * piece)
    corners, values, error = primitives.corners, geometry.depth, 0.0
    for k in range(3):
        error = max(error, geometry.depth_error[corners[piece, k]])
    a, b, c = corners[piece]
    e0, r0 = middle(edge(geometry, b, c, column, row))
    e1, r1 = middle(edge(geometry, c, a, column, row))
    e2, r2 = middle(edge(geometry, a, b, column, row))
    area, slack = e0 + e1 + e2, r0 + r1 + r2
    least, most = min(values[a], values[b], values[c]), max(values[a], values[b], values[c])
    error += DEPTH + geometry.depth_step
    if abs(area) <= slack:
        return least - (most - least) - error, most + (most - least) + error
    depth = (values[a] * e0 + values[b] * e1 + values[c] * e2) / area
    spread = abs(values[a] - depth) * r0 + abs(values[b] - depth) * r1 + abs(values[c] - depth) * r2
    spread += (most - least) * plane_rounding(primitives, geometry, piece)
    spread = spread / (abs(area) - slack) + error
    return depth - spread, depth + spread


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
def middle(interval):
    """The middle of an interval and half its width."""
    low, high = interval
    return (low + high) * 0.5, (high - low) * 0.5
