"""Polygons as the files of most formats have them, and the triangles they become (rule R6)."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.ear_clipping import CLIPPED_LIMIT, Cut, cut
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import FileContent, Part, finite32, refused, rounded

IntArray = NDArray[np.int64]
FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Attribute:
    """What corners have besides a position: UVs or normals."""

    values: FloatArray  # (N, C)
    corner: IntArray  # (K,): which of them each corner has; < 0 or >= N where it has none


@dataclass(frozen=True, eq=False)
class Polygons:
    """The polygons of a file in its order, counter-clockwise seen from outside."""

    positions: FloatArray  # (V, 3)
    sizes: IntArray  # (F,): corners of each polygon
    corner: IntArray  # (K,): the vertex of each corner, polygon after polygon
    uvs: Attribute | None = None
    normals: Attribute | None = None
    material: NDArray[np.int32] | None = None  # (F,), indices of materials
    materials: tuple[Material, ...] = (Material(),)
    notes: tuple[str, ...] = ()


def in_triangles(path: Path, polygons: Polygons) -> FileContent:
    """The content of a file of polygons: one part, in which corners that agree in all they have are one vertex.

    Vertices are in the order of the positions; those that no triangle uses are left out. Raises MeshError for corners
    that are no vertices, and for positions or UVs that float32 does not hold.
    """
    _check_corners(path, polygons)
    polygons, notes = _without_small(polygons)
    uvs, normals = (_complete(each) for each in (polygons.uvs, polygons.normals))
    if polygons.uvs and not uvs:
        notes += ("UVs not used: the file does not give them for every corner",)
    if polygons.normals and not normals:
        notes += ("normals computed: the file does not give them for every corner",)
    given = [each for each in (uvs, normals) if each]
    vertex, chosen = _vertices([polygons.corner, *(each.corner for each in given)], len(polygons.positions))
    positions = _finite(path, polygons.positions, polygons.corner[chosen], "positions")
    triangles, crossed = _cut(polygons.positions[polygons.corner], polygons.sizes)
    if crossed:
        what = f"fold or cross themselves or have more than {CLIPPED_LIMIT} corners"
        notes += (f"{crossed} polygons {what}: they were cut into fans",)
    part = Part(
        positions,
        rounded(normals.values[normals.corner[chosen]]) if normals else None,
        _finite(path, uvs.values, uvs.corner[chosen], "UVs") if uvs else None,
        vertex[triangles],
        polygons.materials[0] if polygons.materials else Material(),
    )
    if polygons.material is None:
        return FileContent([part], notes)
    return FileContent([part], notes, (np.repeat(polygons.material, polygons.sizes - 2), polygons.materials))


def counted(sizes: IntArray) -> IntArray:
    """0, 1 ... for each size in turn: [2, 3] gives 0, 1, 0, 1, 2."""
    return np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)


def _cut(points: FloatArray, sizes: IntArray) -> Cut:
    """points: (K, 3), maybe not finite, which the caller refuses."""
    if (sizes == 3).all():
        return Cut(np.arange(len(points)).reshape(-1, 3), 0)
    with np.errstate(all="ignore"):
        return cut(points, sizes)


def _check_corners(path: Path, polygons: Polygons) -> None:
    last = len(polygons.positions) - 1
    bad = np.flatnonzero((polygons.corner < 0) | (polygons.corner > last))
    if len(bad):
        ends = np.cumsum(polygons.sizes)
        face = int(np.searchsorted(ends, bad[0], side="right"))
        indices = polygons.corner[ends[face] - polygons.sizes[face] : ends[face]].tolist()
        came = f"{indices[:8]} in face {face} ({len(bad)} corners in all)"
        raise refused(path, f"vertex indices from 0 to {last}", came, "export the mesh again")


def _without_small(polygons: Polygons) -> tuple[Polygons, tuple[str, ...]]:
    """Without what has fewer than three corners, and the notes."""
    small = polygons.sizes < 3
    if not small.any():
        return polygons, polygons.notes
    kept = np.repeat(~small, polygons.sizes)
    uvs, normals = (each and Attribute(each.values, each.corner[kept]) for each in (polygons.uvs, polygons.normals))
    without = replace(
        polygons,
        sizes=polygons.sizes[~small],
        corner=polygons.corner[kept],
        uvs=uvs,
        normals=normals,
        material=None if polygons.material is None else polygons.material[~small],
    )
    return without, (*polygons.notes, f"{np.count_nonzero(small)} faces of fewer than three corners were passed over")


def _complete(attribute: Attribute | None) -> Attribute | None:
    """An attribute that every corner has, else None."""
    if attribute is None or not len(attribute.corner):
        return None
    every = (attribute.corner >= 0).all() and (attribute.corner < len(attribute.values)).all()
    return attribute if every else None


def _vertices(keys: list[IntArray], positions: int) -> tuple[IntArray, IntArray]:
    """For each corner the number of its vertex (K,), and for each vertex one of its corners (V',).

    keys: what tells vertices apart, of each corner; the first is the number of a position, of which there are so many.
    """
    number = keys[0]
    if len(keys) > 1:
        for key in keys[1:]:
            _, number = np.unique(number * (np.max(key, initial=0) + 1) + key, return_inverse=True)
    else:
        there = np.zeros(positions, bool)
        there[number] = True
        number = (np.cumsum(there) - 1)[number]
    chosen = np.zeros(np.max(number, initial=-1) + 1, np.int64)
    chosen[number] = np.arange(len(number))
    return number, chosen


def _finite(path: Path, values: FloatArray, used: IntArray, what: str) -> NDArray[np.float32]:
    """The used values in float32; an error names the file's number of the first that is not finite."""
    result = rounded(values[used])
    if not np.isfinite(result).all():
        kept = np.zeros(len(values), bool)
        kept[used] = True
        finite32(path, np.where(kept[:, np.newaxis], values, 0), what)
    return result
