"""UDIM tiles: triangles beside the unit square of UV space are moved into it when a mesh is loaded (rule R7)."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float32]
IntArray = NDArray[np.int32]


class Tiled(NamedTuple):
    """A mesh after the move; vertices shared by triangles of different tiles are there once for each."""

    uvs: FloatArray | None  # (V', 2)
    triangles: IntArray  # (T, 3), in the order they had
    vertices: NDArray[np.int64] | slice = slice(None)  # (V',): which vertex each of them was; the first V are as before
    shifted: int = 0  # triangles that moved

    @property
    def notes(self) -> tuple[str, ...]:
        """What the user should know."""
        return (f"{self.shifted} triangles lie in other UV tiles and were moved to 0..1",) if self.shifted else ()


def into_unit_square(uvs: FloatArray, triangles: IntArray) -> Tiled:
    """Move every triangle that is wholly outside [0, 1] on an axis by a whole number of tiles along that axis.

    uvs: (V, 2), origin at the bottom left; triangles: (T, 3). The step is -floor(((u0 + u1) + u2) / 3) in float32
    where the smallest of the three is >= 1 or the largest <= 0 (rule R7). Triangles that reach inside stay.
    """
    shift = _shifts(uvs[triangles])
    moved = int(np.count_nonzero(shift.any(axis=1)))
    if not moved:
        return Tiled(uvs, triangles)
    corners = np.column_stack([triangles.reshape(-1), np.repeat(shift, 3, axis=0)])  # float64: both are exact in it
    pairs, number = np.unique(corners, axis=0, return_inverse=True)
    vertex, step = pairs[:, 0].astype(np.int64), pairs[:, 1:].astype(np.float32)
    again = np.append(False, vertex[1:] == vertex[:-1])
    vertices = np.concatenate([np.arange(len(uvs)), vertex[again]])
    place = vertex.copy()
    place[again] = len(uvs) + np.arange(np.count_nonzero(again))
    result = uvs[vertices]
    result[place] = np.where(step == 0, result[place], result[place] + step)
    return Tiled(result, place[number.reshape(triangles.shape)].astype(np.int32), vertices, moved)


def _shifts(corners: FloatArray) -> FloatArray:
    """The step of each triangle (T, 3 corners, 2) along u and v, 0 where it stays."""
    a, b, c = np.moveaxis(corners, 1, 0)
    outside = (corners.min(axis=1) >= 1) | (corners.max(axis=1) <= 0)
    with np.errstate(over="ignore"):
        step = -np.floor(((a + b) + c) / np.float32(3))
    return np.where(outside & np.isfinite(step), step, np.float32(0))
