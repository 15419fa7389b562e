"""PLY, in text and binary: polygons or triangle strips, their UVs and normals (G. Turk, "The PLY Polygon File Format").

UVs are columns of the vertices, under any of the names in UV_COLUMNS, or a list of each face, which then counts.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.part import refused, whole
from sss_ref.mesh.ply_header import PlyHeader, parsed
from sss_ref.mesh.ply_rows import Column, Rows
from sss_ref.mesh.polygons import Attribute, Polygons
from sss_ref.mesh.untrusted import check_text

IntArray = NDArray[np.int64]

CORNERS = ("vertex_indices", "vertex_index")
UV_COLUMNS = ("s t", "u v", "texture_u texture_v", "texcoord_u texcoord_v", "tu tv")
WANTED = {*CORNERS, "texcoord", *" ".join(("x y z nx ny nz", *UV_COLUMNS)).split()}
ELEMENTS = ("vertex", "face", "tristrips")
AGAIN = "export the mesh again"
RESTART = -1  # in a strip


def read_ply(path: Path, data: bytes) -> Polygons:
    """The polygons of a PLY file, then the triangles of its strips. Raises MeshError for one that is none."""
    header = parsed(path, data)
    if not header.order:
        check_text(path, data)
    if not any(element.count for element in header.elements if element.name in ("face", "tristrips")):
        raise refused(path, "at least one triangle", "none", "export the mesh as triangles or polygons")
    rows = Rows(path, header, data)
    names = [element.name for element in header.elements]
    twice = [name for name in ELEMENTS if names.count(name) > 1]
    if twice:
        raise refused(path, "each element once", f"{twice[0]} {names.count(twice[0])} times", AGAIN)
    read = {element.name: rows.read(element, WANTED) for element in header.elements}
    vertex, faces, strips = read.get("vertex", {}), read.get("face"), read.get("tristrips")
    positions = _columns(vertex, "x y z")
    if positions is None:
        raise refused(path, "vertices with the properties x, y and z", "others", AGAIN)
    sizes, corner = _joined(_corners(path, faces), _in_triangles(_corners(path, strips)))
    texcoord = (faces or {}).get("texcoord")
    return Polygons(
        positions,
        sizes,
        corner,
        _per_vertex(vertex, corner) if texcoord is None else _per_face(texcoord, sizes),
        _attribute(_columns(vertex, "nx ny nz"), corner),
        notes=tuple(_not_used(header, rows.left)),
    )


def _not_used(header: PlyHeader, left: str) -> Iterator[str]:
    """Notes on properties of vertices and faces that mean nothing here, such as colours, and on what is left."""
    for element in header.elements:
        names = [each.name for each in element.properties if each.name not in WANTED]
        if names and element.name in ELEMENTS:
            yield f"of each {element.name} not used: {', '.join(names)}"
    if left:
        yield f"{left} behind the last element are not used"


def _columns(rows: dict[str, Column], names: str) -> NDArray[np.float64] | None:
    """Properties side by side, (N, C) float64; None unless all are there."""
    found = [rows[name].values for name in names.split() if name in rows and rows[name].sizes is None]
    return np.stack(found, axis=1).astype(np.float64) if len(found) == len(names.split()) else None


def _per_vertex(vertex: dict[str, Column], corner: IntArray) -> Attribute | None:
    found = (_columns(vertex, names) for names in UV_COLUMNS)
    return _attribute(next((uvs for uvs in found if uvs is not None), None), corner)


def _attribute(values: NDArray[np.float64] | None, corner: IntArray) -> Attribute | None:
    return None if values is None else Attribute(values, corner)


def _per_face(texcoord: Column, sizes: IntArray) -> Attribute:
    """Two numbers for every corner of a face, in one list; a face whose list has another length has no UVs."""
    assert texcoord.sizes is not None
    given = np.concatenate([texcoord.sizes, np.zeros(len(sizes) - len(texcoord.sizes), np.int64)])
    fits = given == 2 * sizes
    kept = texcoord.values.astype(np.float64)[np.repeat(fits, given)[: len(texcoord.values)]]
    number = np.full(sizes.sum(), -1)
    number[np.repeat(fits, sizes)] = np.arange(len(kept) // 2)
    return Attribute(kept.reshape(-1, 2), number)


def _corners(path: Path, rows: dict[str, Column] | None) -> tuple[IntArray, IntArray]:
    """The sizes (F,) and the corners (K,) of faces or strips, none where the file has none."""
    if rows is None:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    for name in CORNERS:
        column = rows.get(name)
        if column is not None and column.sizes is not None:
            return column.sizes, whole(path, column.values, f"in {name}")
    raise refused(path, "faces with a list vertex_indices", "others", AGAIN)


def _in_triangles(strips: tuple[IntArray, IntArray]) -> tuple[IntArray, IntArray]:
    """The triangles of strips: every corner but a strip's first two ends one, every second of which is turned round."""
    sizes, corner = strips
    starts = np.zeros(len(corner) + 1, bool)
    starts[(np.cumsum(sizes) - sizes)[sizes > 0]] = True
    restart = corner == RESTART
    starts[1:] |= restart
    since = np.arange(len(corner)) - np.maximum.accumulate(np.where(starts[:-1], np.arange(len(corner)), 0))
    last = np.flatnonzero((since >= 2) & ~restart)
    odd = since[last] % 2
    triangles = np.stack([corner[last - 2 + odd], corner[last - 1 - odd], corner[last]], axis=1)
    return np.full(len(triangles), 3), triangles.reshape(-1)


def _joined(*parts: tuple[IntArray, IntArray]) -> tuple[IntArray, IntArray]:
    sizes, corners = zip(*parts, strict=True)
    return np.concatenate(sizes), np.concatenate(corners)
