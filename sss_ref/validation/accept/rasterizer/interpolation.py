"""How far apart right processors may interpolate: on a triangle as it is, or as they have snapped it (rule R5)."""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.outward import greater, lesser
from sss_ref.validation.accept.rasterizer.boxes import Boxes


class Uncertain(NamedTuple):
    """What is not known exactly of vertices and pieces, as in `Boxes`, and the resolution."""

    off: np.ndarray
    rounding: np.ndarray
    weight_error: np.ndarray
    attribute_error: np.ndarray
    step: float


def interpolation_slack(
    boxes: Boxes, piece: np.ndarray, column: np.ndarray, row: np.ndarray, interpolated: np.ndarray, columns: slice
) -> np.ndarray:
    """How far from its interpolated attributes (N, A) a fragment may have them, float64 (N, A).

    piece, column, row: integers (N,). columns: those of `primitives.attributes`.
    With weights E_i that may be off by D_i, a = sum(E_i*a_i) / sum(E_i) is off by at most
    sum(D_i*|a_i - a|) / (sum(E_i) - sum(D_i)); infinite on slivers where that is not above 0. A processor that
    interpolates a/w and 1/w on planes rounds either, by as much as they change across the picture, and on slivers
    that is more than a changes.
    """
    known = Uncertain(boxes.off, boxes.rounding, boxes.weight_error, boxes.attribute_error, float(boxes.viewport.step))
    own, slack = interpolated.astype(np.float64), np.empty(interpolated.shape)
    pixel = np.stack([column, row], axis=1).astype(np.int64)
    fill_slack(boxes.primitives, known, np.asarray(piece, np.int64), pixel, own, columns.start, slack)
    return slack


class LooseCorner(NamedTuple):
    """A vertex seen from a pixel, and how far it may be off; 1/w and the share that it may be off."""

    x: float
    y: float
    off_x: float
    off_y: float
    weight: float
    weight_error: float


@compiled
def fill_slack(primitives, known, piece, pixel, own, first, slack):
    """Fill `slack`, (N, A) as `own` is. pixel: int64 (N, 2), column and row. first: the column of the attributes."""
    corners, snapped = primitives.corners, primitives.snapped
    inverse_w, attributes = primitives.inverse_w, primitives.attributes
    off, errors, error, step = known.off, known.weight_error, known.attribute_error, known.step
    for n in range(len(piece)):
        i, j, k = corners[piece[n], 0], corners[piece[n], 1], corners[piece[n], 2]
        a = corner(snapped, inverse_w, off, errors, step, i, pixel[n, 0], pixel[n, 1])
        b = corner(snapped, inverse_w, off, errors, step, j, pixel[n, 0], pixel[n, 1])
        c = corner(snapped, inverse_w, off, errors, step, k, pixel[n, 0], pixel[n, 1])
        edge_a, change_a = weight(a, b, c)
        edge_b, change_b = weight(b, c, a)
        edge_c, change_c = weight(c, a, b)
        # how far a plane is rounded that changes by 1 over the piece, times twice the piece's area
        rounding = known.rounding[piece[n], 0] * extent(a.y, b.y, c.y)
        rounding += known.rounding[piece[n], 1] * extent(a.x, b.x, c.x)
        lost = rounding * extent(a.weight, b.weight, c.weight)
        least = abs(edge_a + edge_b + edge_c) - (change_a + change_b + change_c) - lost
        for number in range(own.shape[1]):
            here, column = own[n, number], first + number
            at_a, at_b = np.float64(attributes[i, column]), np.float64(attributes[j, column])
            at_c = np.float64(attributes[k, column])
            apart = change_a * abs(at_a - here) + change_b * abs(at_b - here) + change_c * abs(at_c - here)
            apart += rounding * extent(at_a * a.weight, at_b * b.weight, at_c * c.weight) + lost * abs(here)
            of_vertices = greater(greater(error[i, column], error[j, column]), error[k, column])
            slack[n, number] = (apart / least if least > 0 else np.inf) + of_vertices


@compiled
def corner(snapped, inverse_w, off, weight_error, step, vertex, column, row):
    """A vertex as it is seen from a pixel."""
    x, y = snapped[vertex, 0] / step - column, snapped[vertex, 1] / step - row
    return LooseCorner(x, y, off[vertex, 0], off[vertex, 1], np.float64(inverse_w[vertex]), weight_error[vertex])


@compiled
def weight(own, following, last):
    """The weight of a corner, the edge function of the two others times 1/w, and how far it may be off."""
    edge = following.x * last.y - last.x * following.y
    change = abs(following.x) * last.off_y + abs(last.y) * following.off_x + following.off_x * last.off_y
    change += abs(last.x) * following.off_y + abs(following.y) * last.off_x + following.off_y * last.off_x
    return edge * own.weight, (change + abs(edge) * own.weight_error) * own.weight


@compiled
def extent(a, b, c):
    """How far three numbers lie apart."""
    return greater(greater(a, b), c) - lesser(lesser(a, b), c)
