"""What every reader of a mesh file gives: its parts in the file's order, moved to their places, and what to tell."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.errors.wording import told
from sss_ref.mesh.materials import Material
from sss_ref.view.matrices import mirrors, normal_matrix, transformed

FloatArray = NDArray[np.float32]

EXACT = 2.0**53  # below which float64 has every whole number


@dataclass(frozen=True, eq=False)
class Part:
    """One geometry of a file in mesh space, with one material; None for what the file does not have."""

    positions: FloatArray  # (V, 3), finite
    normals: FloatArray | None  # (V, 3), as stored
    uvs: FloatArray | None  # (V, 2), finite, origin bottom-left
    triangles: NDArray[np.int64]  # (T, 3), indices of the part's vertices, counter-clockwise seen from outside
    material: Material


def without_unused(part: Part) -> Part:
    """The part without the vertices that no triangle uses (rule R10), the others in their order."""
    used = np.unique(part.triangles)
    if len(used) == len(part.positions):
        return part
    return replace(
        part,
        positions=part.positions[used],
        normals=None if part.normals is None else part.normals[used],
        uvs=None if part.uvs is None else part.uvs[used],
        triangles=np.searchsorted(used, part.triangles),
    )


class FileContent(NamedTuple):
    """A mesh file as read."""

    parts: list[Part]  # in the order that numbers their triangles
    notes: tuple[str, ...] = ()  # what of the file was changed or not used, and why
    materials: tuple[NDArray[np.int32], tuple[Material, ...]] | None = None  # where one part has several: by triangle


def placed(
    where: object,
    transform: NDArray[np.float64],
    positions: NDArray[np.float64],
    normals: NDArray[np.float64] | None,
    triangles: NDArray[np.int64],
) -> tuple[FloatArray, FloatArray | None, NDArray[np.int64]]:
    """Positions, normals and triangles under a 4 x 4 transform: float64, rounded once (rule R6).

    Triangles of a mirrored part are turned right side out. where: file and element, for the MeshError raised where
    the transform cannot be inverted or a position does not fit float32.
    """
    mirrored, matrix = _orientation(where, transform)
    if not np.array_equal(transform, np.eye(4)):
        positions = transformed(transform, positions)
        normals = None if normals is None else transformed(matrix, normals)
    return (
        finite32(where, positions, "positions"),
        None if normals is None else rounded(normals),
        triangles[:, ::-1] if mirrored else triangles,
    )


def _orientation(where: object, transform: NDArray[np.float64]) -> tuple[bool, NDArray[np.float64]]:
    """Whether a node's transform mirrors, and the 4 x 4 matrix for its normals."""
    matrix = np.eye(4)
    with np.errstate(all="ignore"):
        matrix[:3, :3] = normal_matrix(transform)
    if not (np.isfinite(transform).all() and np.isfinite(matrix).all()):
        raise refused(where, "transforms that can be inverted", "one that cannot", "apply them before exporting")
    return mirrors(transform), matrix


def whole(where: object, values: NDArray[np.number], role: str) -> NDArray[np.int64]:
    """The same numbers as integers. role: "as vertex indices". Raises MeshError where one is none, or too large."""
    if not ((values == np.rint(values)) & (np.abs(values) < EXACT)).all():
        raise refused(where, f"whole numbers below 2^53 {role}", "others", "export the mesh again")
    return values.astype(np.int64)


def finite32(where: object, points: NDArray[np.float64], what: str) -> FloatArray:
    """Points (N, C) rounded to float32; raises MeshError where one of them is not finite then."""
    result = rounded(points)
    bad = np.flatnonzero(~np.isfinite(result).all(axis=1))
    if len(bad):
        came = f"{points[bad[0]].tolist()} at vertex {bad[0]} ({len(bad)} in all)"
        raise refused(where, f"{what} that are finite in float32", came, "correct them")
    return result


def rounded(points: NDArray[np.float64]) -> FloatArray:
    """To float32, infinite where that does not reach."""
    with np.errstate(over="ignore"):
        return points.astype(np.float32)


def vertex_indices(where: object, triangles: NDArray[np.integer], vertices: int) -> NDArray[np.int64]:
    """Triangles (T, 3); raises MeshError where one of them has a corner that is no vertex."""
    triangles = np.asarray(triangles, np.int64).reshape(-1, 3)
    bad = np.flatnonzero(((triangles < 0) | (triangles >= vertices)).any(axis=1))
    if len(bad):
        came = f"{triangles[bad[0]].tolist()} in triangle {bad[0]} ({len(bad)} in all)"
        raise refused(where, f"vertex indices from 0 to {vertices - 1}", came, "export the mesh again")
    return triangles


def refused(where: object, expected: str, came: str, remedy: str) -> MeshError:
    """The error of a mesh file. where: its path, or path and element as in `a.gltf: nodes[0].scale`."""
    return MeshError(told(str(where), expected, came, remedy))
