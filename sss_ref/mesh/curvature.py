"""How sharply a surface is bent at its vertices, and between them as a plane over each triangle."""

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.topology import merged

Array64 = NDArray[np.float64]


def triangle_curvatures(points: Array64, normals: Array64, triangles: NDArray[np.int32]) -> Array64:
    """Of each triangle how fast its normal turns, sqrt(sum |dN|^2 / sum |dP|^2) over its edges; 0 without a size, (T,).

    points: world positions (V, 3). normals: unit, world space (V, 3). On a ball of radius r each has 1/r.
    """
    turned, moved = (_squared_edges(each[triangles]) for each in (normals, points))
    ratio: Array64 = np.sqrt(np.where(moved > 0, turned, 0.0) / np.where(moved > 0, moved, 1.0))
    return ratio


def _squared_edges(corners: Array64) -> Array64:
    """The squares of the three edges of each triangle, summed, (T,)."""
    edges = corners - np.roll(corners, 1, axis=1)
    squares = edges * edges
    each = (squares[..., 0] + squares[..., 1]) + squares[..., 2]
    total: Array64 = (each[:, 0] + each[:, 1]) + each[:, 2]
    return total


def vertex_curvatures(
    positions: NDArray[np.float32], points: Array64, normals: Array64, triangles: NDArray[np.int32]
) -> Array64:
    """Of each vertex the mean of its triangles, each counting by its area, (V,); vertices at one place are one.

    positions: as the file has them (V, 3), which say which vertices are at one place.
    """
    area = _length(_normal(points[triangles]))
    own = triangle_curvatures(points, normals, triangles)
    group = merged(positions)
    total, weight = np.zeros((2, len(positions)))
    np.add.at(total, group[triangles].ravel(), np.repeat(area * own, 3))
    np.add.at(weight, group[triangles].ravel(), np.repeat(area, 3))
    mean: Array64 = np.where(weight > 0, total, 0.0) / np.where(weight > 0, weight, 1.0)
    return mean[group]


def over_triangles(values: Array64, points: Array64, triangles: NDArray[np.int32]) -> Array64:
    """Values of vertices as g.P + c over each triangle: (T, 4), g and c; a triangle without area has its first alone.

    With the edges e1, e2 of a triangle, n = cross(e1, e2) and the differences k1, k2 of its values along them,
    g = (cross(e2, n)*k1 + cross(n, e1)*k2) / |n|^2 and c = k0 - g.P0.
    """
    corner, first, second = np.moveaxis(points[triangles], 1, 0)
    at_corner, at_first, at_second = values[triangles].T
    e1, e2, n = first - corner, second - corner, _normal(points[triangles])
    square = _dot(n, n)
    raised = _cross(e2, n) * (at_first - at_corner)[:, None] + _cross(n, e1) * (at_second - at_corner)[:, None]
    gradient = np.where(square > 0, raised.T, 0.0) / np.where(square > 0, square, 1.0)
    return np.concatenate([gradient, (at_corner - _dot(gradient.T, corner))[None]]).T


def unit_rows(v: Array64) -> Array64:
    """Each row of (N, 3) at length 1; a row of length 0 stays."""
    long = _length(v)
    return v / np.where(long == 0, 1.0, long)[:, None]


def _normal(corners: Array64) -> Array64:
    return _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def _cross(a: Array64, b: Array64) -> Array64:
    """numpy.cross leaves the order of its operations to itself."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)


def _dot(a: Array64, b: Array64) -> Array64:
    total: Array64 = (a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1]) + a[:, 2] * b[:, 2]
    return total


def _length(v: Array64) -> Array64:
    root: Array64 = np.sqrt(_dot(v, v))
    return root
