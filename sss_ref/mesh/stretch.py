"""How long a step of UV is on the surface: the stretch of each triangle of a UV layout."""

import numpy as np
from numpy.typing import NDArray

LONGEST = 1e30  # where UVs are nearly without area: beyond it nothing is told apart, and products stay finite


def stretch_of(
    points: NDArray[np.float64], uvs: NDArray[np.float32], triangles: NDArray[np.int32]
) -> NDArray[np.float64]:
    """|dP/du| and |dP/dv| of each triangle, scene units per unit of UV, (T, 2); 0 where its UVs have no area.

    points: world positions (V, 3). uvs: (V, 2). triangles: (T, 3). With the edges e of a triangle on the surface and
    (a, b) in the layout, dP/du = (e1*b2 - e2*b1)/det and dP/dv = (e2*a1 - e1*a2)/det, det = a1*b2 - a2*b1. On a
    triangle both are the same everywhere.
    """
    corner, first, second = np.moveaxis(points[triangles], 1, 0)
    flat, flat_first, flat_second = np.moveaxis(uvs.astype(np.float64)[triangles], 1, 0)
    e1, e2 = first - corner, second - corner
    (a1, b1), (a2, b2) = (flat_first - flat).T[..., None], (flat_second - flat).T[..., None]
    det = a1 * b2 - a2 * b1
    safe = np.where(det == 0, 1.0, det)
    steps = np.stack([(e1 * b2 - e2 * b1) / safe, (e2 * a1 - e1 * a2) / safe], axis=1)
    squares = steps * steps
    lengths = np.sqrt((squares[..., 0] + squares[..., 1]) + squares[..., 2])
    bounded: NDArray[np.float64] = np.where(det == 0, 0.0, np.minimum(lengths, LONGEST))
    return bounded
