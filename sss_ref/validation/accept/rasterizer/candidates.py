"""Which pieces a processor may show at each pixel: those that may cover the sample, and are not certainly behind."""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.raster.coverage import acceptance, at, edges
from sss_ref.validation.accept.rasterizer.boxes import Boxes
from sss_ref.validation.accept.rasterizer.loose_piece import Geometry, cover, key, loose_piece, reached

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
    order = by_pixel(found.pixel, nearest.size)
    return Candidates(*(column[order] for column in found))


@compiled
def find_nearest(primitives, geometry, nearest):
    """Lower `nearest` (H, W) to the far end of each piece that covers the sample for certain."""
    height, width = nearest.shape
    for number in range(len(primitives.corners)):
        first_column, last_column = reached(primitives, geometry, number, 0, width)
        first_row, last_row = reached(primitives, geometry, number, 1, height)
        piece = loose_piece(primitives, geometry, number)
        for row in range(first_row, last_row + 1):
            for column in range(first_column, last_column + 1):
                _, must, _ = cover(piece, column, row)
                if must:
                    _, high = key(piece, column, row)
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
    for number in range(len(primitives.corners)):
        first_column, last_column = reached(primitives, geometry, number, 0, width)
        first_row, last_row = reached(primitives, geometry, number, 1, height)
        piece, own_edges = loose_piece(primitives, geometry, number), edges(primitives, number, geometry.step)
        for row in range(first_row, last_row + 1):
            for column in range(first_column, last_column + 1):
                may, must, bits = cover(piece, column, row)
                if not may:
                    continue
                least, most = key(piece, column, row)
                if least > nearest[row, column] or (least >= FAR and geometry.turn == 0):
                    continue
                if count == size:
                    size *= 2
                    pixel, pieces = grown(pixel), grown(pieces)
                    low, high = grown(low), grown(high)
                    inside, certain, band = grown(inside), grown(certain), grown(band)
                pixel[count], pieces[count] = row * width + column, number
                low[count], high[count] = least, most
                inside[count] = is_inside(own_edges, column, row)
                certain[count], band[count] = must, bits
                count += 1
    return pixel[:count], pieces[:count], low[:count], high[:count], inside[:count], certain[:count], band[:count]


@compiled
def grown(array):
    """An array with room for as many again."""
    return np.concatenate((array, np.empty_like(array)))


@compiled
def by_pixel(pixel, pixels):
    """The order, int64 (M,), that puts what belongs to one of so many pixels side by side, each as it came."""
    first, order = np.zeros(pixels + 1, np.int64), np.empty(len(pixel), np.int64)
    for k in range(len(pixel)):
        first[pixel[k] + 1] += 1
    for each in range(pixels):
        first[each + 1] += first[each]
    for k in range(len(pixel)):
        order[first[pixel[k]]] = k
        first[pixel[k]] += 1
    return order


@compiled
def is_inside(own_edges, column, row):
    """Whether the oracle covers the sample with a piece of these edges (rule R3).

    Nothing of one without an area: its edges sum to 0, so that not all of them can own their samples.
    """
    e0, e1, e2 = own_edges
    inside = at(acceptance(e0), column, row) >= 0 and at(acceptance(e1), column, row) >= 0
    return inside and at(acceptance(e2), column, row) >= 0
