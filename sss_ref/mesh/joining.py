"""The parts of a mesh file joined to one list of triangles, in the order they come."""

from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.materials import Material
from sss_ref.mesh.normals import vertex_normals
from sss_ref.mesh.part import FileContent, FloatArray, Part, refused, without_unused
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.uv_tiles import Tiled, into_unit_square

Note = tuple[str, ...]


def joined(path: Path, content: FileContent) -> Mesh:
    """One mesh of all parts that have triangles.

    Stored normals are kept if every part has them, all finite and none 0, otherwise all normals are computed
    (rule R6). Raises MeshError for what cannot be drawn.
    """
    parts = [without_unused(part) for part in content.parts if len(part.triangles)]
    if not parts:
        raise refused(path, "at least one triangle", "none", "export the mesh as triangles or polygons")
    positions = np.concatenate([part.positions for part in parts])
    if (positions == positions[0]).all():
        raise refused(path, "a mesh of some size", "all vertices at one point", "correct them")
    triangles = joined_triangles(path, parts)
    uvs, uv_notes = _joined_uvs(path, parts)
    normals, normal_notes = _joined_normals(parts)
    source: Literal["file", "computed"] = "computed" if normals is None else "file"
    if normals is None:
        normals = vertex_normals(positions, triangles)
    material, materials = content.materials or _joined_materials(parts)
    tiled = Tiled(uvs, triangles) if uvs is None else into_unit_square(uvs, triangles)
    return Mesh(
        path.name,
        positions[tiled.vertices],
        normals[tiled.vertices],
        tiled.uvs,
        tiled.triangles,
        material,
        materials,
        source,
        tiled.shifted,
        notes=content.notes + uv_notes + normal_notes + tiled.notes,
    )


def joined_triangles(path: Path, parts: list[Part]) -> NDArray[np.int32]:
    """The triangles of all parts, (T, 3), as indices of all vertices; raises MeshError where int32 is too small."""
    starts = np.cumsum([0] + [len(part.positions) for part in parts])
    if starts[-1] > np.iinfo(np.int32).max:
        raise refused(path, "fewer than 2^31 vertices", str(starts[-1]), "simplify the mesh")
    shifted = [part.triangles + start for part, start in zip(parts, starts[:-1], strict=True)]
    return np.ascontiguousarray(np.concatenate(shifted), np.int32)


def _joined_materials(parts: list[Part]) -> tuple[NDArray[np.int32], tuple[Material, ...]]:
    """The number of each triangle's material, and the materials, each once."""
    materials = tuple(dict.fromkeys(part.material for part in parts))
    numbers = [materials.index(part.material) for part in parts]
    return np.repeat(np.array(numbers, np.int32), [len(part.triangles) for part in parts]), materials


def _joined_uvs(path: Path, parts: list[Part]) -> tuple[FloatArray | None, Note]:
    stored = [part.uvs for part in parts if part.uvs is not None]
    if not stored:
        return None, ()
    if len(stored) < len(parts):
        return None, (f"UVs not used: {len(parts) - len(stored)} of {len(parts)} parts have none",)
    if any(len(uvs) != len(part.positions) for uvs, part in zip(stored, parts, strict=True)):
        raise refused(path, "one UV per vertex", "another number", "export the mesh again")
    return np.concatenate(stored), ()


def _joined_normals(parts: list[Part]) -> tuple[FloatArray | None, Note]:
    """The stored normals, or None if they are not usable throughout, and what to tell the user about that."""
    stored = [part.normals for part in parts if part.normals is not None]
    if not stored:
        return None, ()
    if len(stored) < len(parts):
        return None, (f"normals computed: {len(parts) - len(stored)} of {len(parts)} parts have none",)
    normals = np.concatenate(stored)
    unusable = np.count_nonzero(~(np.isfinite(normals).all(axis=1) & normals.any(axis=1)))
    if unusable:
        return None, (f"normals computed: {unusable} of the file's {len(normals)} are zero or not finite",)
    return normals, ()
