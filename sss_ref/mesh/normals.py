"""Vertex normals for meshes that come without (rule R6)."""

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.topology import merged


def vertex_normals(positions: NDArray[np.float32], triangles: NDArray[np.int32]) -> NDArray[np.float32]:
    """Unit normals (V, 3): the area-weighted mean of the triangles around a position, on both sides of a UV seam.

    positions: (V, 3) mesh space; triangles: (T, 3), counter-clockwise seen from outside. The sums are float64, taken
    in the order of the triangles; a vertex whose triangles cancel or have no area keeps the normal 0.
    """
    number = merged(positions)
    sums = np.zeros((len(positions), 3))
    np.add.at(sums, number[triangles].reshape(-1), np.repeat(_area_vectors(positions, triangles), 3, axis=0))
    return _normalized(sums)[number].astype(np.float32)


def _area_vectors(positions: NDArray[np.float32], triangles: NDArray[np.int32]) -> NDArray[np.float64]:
    """Cross product of two edges of each triangle (T, 3): its normal, twice its area long."""
    a, b, c = np.moveaxis(positions[triangles].astype(np.float64), 1, 0)
    (x1, y1, z1), (x2, y2, z2) = (b - a).T, (c - a).T
    return np.stack([y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2], axis=1)


def _normalized(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    x, y, z = vectors.T
    lengths = np.sqrt((x * x + y * y) + z * z)
    return vectors / np.where(lengths == 0, 1.0, lengths)[:, np.newaxis]
