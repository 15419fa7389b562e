"""Cutting polygons into triangles: fans where they are right, else ears (G. H. Meisters, "Polygons have ears", 1975).

All polygons of one size are cut together. Their corners are looked at along the axis nearest to the polygon's normal.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

IntArray = NDArray[np.int64]
FloatArray = NDArray[np.float64]
Mask = NDArray[np.bool_]

ROUNDING = 2.0**-40  # of a polygon's area: what float64 may leave of corners that lie on one line
CLIPPED_LIMIT = 2**12  # corners of a polygon that is cut by ears, whose work grows with their square


class Cut(NamedTuple):
    """Polygons in triangles."""

    corners: IntArray  # (T, 3): numbers of corners, polygon after polygon
    crossed: int  # polygons that cross themselves, which fans cut all the same


def cut(points: FloatArray, sizes: IntArray) -> Cut:
    """Triangles of polygons with at least three corners each.

    points: (C, 3), the corners of all polygons; sizes: (P,), how many each has. A polygon whose fan around its first
    corner folds nowhere gives (0, 1, 2), (2, 3, 0), (3, 4, 0) ...; of any other, ears are cut off. Both leave n - 2
    triangles, which turn as the polygon does.
    """
    starts = np.cumsum(sizes) - sizes
    first = np.cumsum(sizes - 2) - (sizes - 2)
    corners = np.empty((int((sizes - 2).sum()), 3), np.int64)
    crossed = 0
    for size in np.unique(sizes).tolist():
        chosen = np.flatnonzero(sizes == size)
        local = np.broadcast_to(fan(size), (len(chosen), size - 2, 3))
        if size > 3:
            local, wrong = _cut_of_one_size(points[starts[chosen, np.newaxis] + np.arange(size)])
            crossed += wrong
        corners[first[chosen, np.newaxis] + np.arange(size - 2)] = local + starts[chosen, np.newaxis, np.newaxis]
    return Cut(corners, crossed)


def fan(size: int) -> IntArray:
    """The fan around the first of `size` corners (size - 2, 3); every triangle but the first begins at the new edge."""
    k = np.arange(1, size - 1)
    around = np.stack([k, k + 1, np.zeros_like(k)], axis=1)
    around[0] = 0, 1, 2
    return around


def _cut_of_one_size(points: FloatArray) -> tuple[IntArray, int]:
    """Triangles (P, n - 2, 3) of polygons (P, n, 3), and how many cross themselves."""
    count, size = points.shape[:2]
    result = np.tile(fan(size), (count, 1, 1))
    flat, folded = _seen(points)
    chosen = np.flatnonzero(folded)
    crossing = _cross_themselves(flat[chosen]) if size <= CLIPPED_LIMIT else np.ones(len(chosen), bool)
    clipped = chosen[~crossing]
    result[clipped], left = _clipped(flat[clipped])
    return result, int(np.count_nonzero(crossing) + np.count_nonzero(left))


def _seen(points: FloatArray) -> tuple[FloatArray, Mask]:
    """The polygons (P, n, 3) seen so that they turn left (P, n, 2), and which of their fans fold back."""
    spokes = points[:, 1:] - points[:, :1]
    areas = _cross3(spokes[:, :-1], spokes[:, 1:])
    normal = areas.sum(axis=1)
    sizes = np.abs(areas).sum(axis=2)
    nothing = np.abs(normal).sum(axis=1) <= ROUNDING * sizes.sum(axis=1)
    largest = np.take_along_axis(areas, sizes.argmax(axis=1)[:, np.newaxis, np.newaxis], axis=1)[:, 0]
    normal = np.where(nothing[:, np.newaxis], largest, normal)
    axis = np.abs(normal).argmax(axis=1)
    ways = np.take_along_axis(normal, axis[:, np.newaxis], axis=1)
    kept = np.where(ways > 0, np.stack([axis + 1, axis + 2], axis=1), np.stack([axis + 2, axis + 1], axis=1)) % 3
    flat = np.take_along_axis(points, kept[:, np.newaxis, :], axis=2)
    along = np.take_along_axis(areas, axis[:, np.newaxis, np.newaxis], axis=2)[:, :, 0] * np.sign(ways)
    return flat, (along < -ROUNDING * np.abs(along).sum(axis=1, keepdims=True)).any(axis=1)


def _cross3(a: FloatArray, b: FloatArray) -> FloatArray:
    (ax, ay, az), (bx, by, bz) = np.moveaxis(a, -1, 0), np.moveaxis(b, -1, 0)
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=-1)


def _turn(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Twice the area of the triangles a, b, c (..., 2), > 0 where they turn left."""
    ab, ac = b - a, c - a
    return ab[..., 0] * ac[..., 1] - ab[..., 1] * ac[..., 0]


def _cross_themselves(flat: FloatArray) -> Mask:
    """Which polygons (P, n, 2) have two edges that cross at a point inside both."""
    found = np.zeros(len(flat), bool)
    ends = np.roll(flat, -1, axis=1)
    for number in range(flat.shape[1]):
        start, end = flat[:, number, np.newaxis], ends[:, number, np.newaxis]
        apart = _turn(start, end, flat) * _turn(start, end, ends) < 0
        found |= (apart & (_turn(flat, ends, start) * _turn(flat, ends, end) < 0)).any(axis=1)
    return found


class _Rings:
    """Polygons of one size while their ears are cut off: who is next to whom, and who is left."""

    def __init__(self, flat: FloatArray) -> None:
        self.flat = flat
        self.rows = np.arange(len(flat))
        order = np.tile(np.arange(flat.shape[1]), (len(flat), 1))
        self.before, self.after = np.roll(order, 1, axis=1), np.roll(order, -1, axis=1)
        self.left = np.ones(order.shape, bool)
        self.ears = np.stack([self.is_ear(self.rows, corner) for corner in order.T], axis=1)

    def is_ear(self, rows: IntArray, corner: IntArray, strictly: bool = True) -> Mask:
        """Whether the corner (R,) of each of the polygons `rows` (R,) can be cut off.

        It turns left, and no other corner lies in its triangle or, unless at one place with its own corners, on its
        edge; not `strictly`: corners on its edge do not count.
        """
        names = self.before[rows, corner], corner, self.after[rows, corner]
        a, b, c = (self.flat[rows, name][:, np.newaxis] for name in names)
        points = self.flat[rows]
        turns = np.stack([_turn(a, b, points), _turn(b, c, points), _turn(c, a, points)])
        inside = (turns >= 0).all(axis=0) if strictly else (turns > 0).all(axis=0)
        own = np.any([(points == each).all(axis=2) for each in (a, b, c)], axis=0)
        return (_turn(a, b, c)[:, 0] > 0) & ~(inside & ~own & self.left[rows]).any(axis=1)

    def cut_off(self, corner: IntArray) -> None:
        """Take one corner (P,) from each polygon."""
        before, after = self.before[self.rows, corner], self.after[self.rows, corner]
        self.left[self.rows, corner] = self.ears[self.rows, corner] = False
        self.after[self.rows, before], self.before[self.rows, after] = after, before
        for neighbour in (before, after):
            self.ears[self.rows, neighbour] = self.is_ear(self.rows, neighbour)

    def look_again(self) -> None:
        """Of polygons that show no ear, find those that others' removal has made; at last such that corners touch."""
        for strictly in (True, False):
            rows = np.flatnonzero(~self.ears.any(axis=1))
            for corner in range(self.flat.shape[1]) if len(rows) else ():
                names = np.full(len(rows), corner)
                self.ears[rows, corner] = self.is_ear(rows, names, strictly) & self.left[rows, corner]


def _clipped(flat: FloatArray) -> tuple[IntArray, Mask]:
    """Triangles (P, n - 2, 3) of polygons (P, n, 2), and where they turn right, which those of simple ones do not."""
    count, size = flat.shape[:2]
    rings = _Rings(flat)
    result = np.empty((count, size - 2, 3), np.int64)
    for step in range(size - 2):
        rings.look_again()
        corner = np.where(rings.ears.any(axis=1), rings.ears.argmax(axis=1), rings.left.argmax(axis=1))
        result[:, step, 0] = rings.before[rings.rows, corner]
        result[:, step, 1] = corner
        result[:, step, 2] = rings.after[rings.rows, corner]
        rings.cut_off(corner)
    a, b, c = (np.take_along_axis(flat, result[:, :, k, np.newaxis], axis=1) for k in range(3))
    turns = _turn(a, b, c)
    return result, (turns < -ROUNDING * np.abs(turns).sum(axis=1, keepdims=True)).any(axis=1)
