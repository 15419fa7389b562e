"""Questions about the surface as a whole, asked of positions: UV seams split vertices, not the surface."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int32]


def merged(positions: NDArray[np.float32]) -> NDArray[np.int64]:
    """For every vertex (V, 3) the number of its position, the same for equal positions; -0 equals +0 (rule R6)."""
    _, number = np.unique(positions + np.float32(0), axis=0, return_inverse=True)
    return number.reshape(-1).astype(np.int64)


def is_watertight(positions: NDArray[np.float32], triangles: IntArray) -> bool:
    """Whether every edge joins exactly two triangles that run along it in opposite directions.

    Triangles that use a position twice have no area and do not count.
    """
    corners = merged(positions)[triangles]
    a, b, c = corners.T
    corners = corners[(a != b) & (b != c) & (c != a)]
    start, end = corners.reshape(-1), np.roll(corners, -1, axis=1).reshape(-1)
    along = np.unique(start * len(positions) + end)
    against = np.unique(end * len(positions) + start)
    return len(along) == len(start) > 0 and bool(np.array_equal(along, against))


def is_inside(point: FloatArray, corners: FloatArray) -> bool:
    """Whether a ray from `point` along +X crosses a closed surface (T, 3 corners, xyz) an odd number of times."""
    a, b, c = np.moveaxis(corners - point, 1, 0)
    edges = (_turn(b, c), _turn(c, a), _turn(a, b))
    sides = [_side(edge, p, q) for edge, p, q in zip(edges, (b, c, a), (c, a, b), strict=True)]
    pierced = (sides[0] == sides[1]) & (sides[1] == sides[2])
    ahead = sides[0] * ((edges[0] * a[:, 0] + edges[1] * b[:, 0]) + edges[2] * c[:, 0]) > 0
    return np.count_nonzero(pierced & ahead) % 2 == 1


def _turn(p: FloatArray, q: FloatArray) -> FloatArray:
    """Twice the area the origin spans with p, q in the YZ plane; exchanging p and q changes its sign and no more."""
    return p[:, 1] * q[:, 2] - p[:, 2] * q[:, 1]


def _side(turn: FloatArray, p: FloatArray, q: FloatArray) -> FloatArray:
    """The sign of `turn`; for a ray through an edge, the sign after moving it by (e, e * e), e > 0 and tiny.

    So a ray through a shared edge or corner crosses the surface exactly once.
    """
    moved = np.where(p[:, 2] != q[:, 2], p[:, 2] - q[:, 2], q[:, 1] - p[:, 1])
    return np.sign(np.where(turn != 0, turn, moved))
