"""Mesh files as trimesh reads them, its parts in the order of its scene graph; quads and polygons arrive triangulated.

Of the file's materials only the colours are read.
"""

import io
import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown
from sss_ref.mesh.materials import Material, material_of
from sss_ref.mesh.part import FileContent, Part, finite32, placed, refused, vertex_indices
from sss_ref.mesh.untrusted import OwnFolder, check_declarations

# Faces of an OBJ file that trimesh would change without a word: fewer than three corners, or a vertex numbered 0.
BROKEN_FACE = re.compile(rb"^f(?:[ \t]+\S+){0,2}[ \t\r]*$|^f[ \t](?:.*[ \t])?0(?:[/ \t\r].*)?$", re.MULTILINE)


def read_by_trimesh(path: Path) -> FileContent:
    """The parts of a mesh file; raises MeshError for one that cannot be read."""
    if path.suffix.lower() == ".obj":
        _check_faces(path)
    parts = list(_parts(path))
    notes: tuple[str, ...] = ()
    if all(part.uvs is None for part in parts) and _declares(path, "vt"):
        notes += ("UVs not used: the file does not give them for every corner",)
    if all(part.normals is None for part in parts) and _declares(path, "vn"):
        notes += ("normals computed: the file does not give them for every corner",)
    if any(part.normals is not None for part in parts) and _has_uvs_by_triangle(path):
        parts = [Part(part.positions, None, part.uvs, part.triangles, part.material) for part in parts]
        notes += ("normals computed: the file's UVs are stored by triangle",)
    return FileContent(parts, notes)


def _check_faces(path: Path) -> None:
    broken = BROKEN_FACE.search(path.read_bytes().replace(b"\\\n", b""))
    if broken:
        face = shown(broken.group().decode(errors="replace").strip())
        raise refused(path, "faces of at least three vertices, numbered from 1", face, "export the mesh again")


def _parts(path: Path) -> Iterator[Part]:
    """The triangle meshes of a file in graph order; points and lines are passed over."""
    for geometry, transform in _read(path):
        if hasattr(geometry, "faces"):
            yield _part(path, geometry, np.asarray(transform, np.float64), material_of(geometry.visual))


def _read(path: Path) -> list[tuple[Any, Any]]:
    """The geometries of a file and their transforms as trimesh reads them, vertices untouched.

    The vertices of a PLY file would be renumbered by their UVs, which only UVs stored by triangle need.
    """
    import trimesh

    data, folder = path.read_bytes(), OwnFolder(path)
    check_declarations(path, data)
    suffix = path.suffix.lower()
    options: dict[str, dict[str, Any]] = {
        ".ply": {"skip_materials": True, "fix_texture": _has_uvs_by_triangle(path)},
    }
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            chosen = {"process": False, "file_type": suffix[1:], "resolver": folder, **options.get(suffix, {})}
            scene = trimesh.load_scene(io.BytesIO(data), **chosen)
            read = [(scene.geometry[name], place) for place, name in map(scene.graph.get, scene.graph.nodes_geometry)]
    except MeshError:
        raise
    except Exception as error:  # whatever a broken file makes trimesh raise
        reason = f"one that cannot be read ({type(error).__name__}: {error})".splitlines()[0]
        raise refused(path, f"a valid {suffix[1:]} file", reason, "export the mesh again") from None
    if folder.refusal:
        raise folder.refusal
    return read


def _has_uvs_by_triangle(path: Path) -> bool:
    """Whether a PLY file stores its UVs with the triangles. trimesh then splits vertices, and leaves normals behind."""
    if path.suffix.lower() != ".ply":
        return False
    with path.open("rb") as file:
        return b"texcoord" in file.read(1 << 16).partition(b"end_header")[0]


def _part(path: Path, geometry: Any, transform: NDArray[np.float64], material: Material) -> Part:
    """A geometry under its node's transform."""
    points = _points(path, geometry.vertices, 3, "positions")
    triangles = vertex_indices(path, geometry.faces, len(points))
    uvs = getattr(geometry.visual, "uv", None)
    positions, normals, triangles = placed(path, transform, points, _stored_normals(geometry), triangles)
    checked = None if uvs is None else finite32(path, _points(path, uvs, 2, "UVs"), "UVs")
    return Part(positions, normals, checked, triangles, material)


def _stored_normals(geometry: Any) -> NDArray[np.float64] | None:
    """The file's normals (V, 3). trimesh would compute missing ones; its exporters tell the two apart like this."""
    return geometry.vertex_normals if "vertex_normals" in geometry._cache else None


def _points(path: Path, points: Any, width: int, what: str) -> NDArray[np.float64]:
    points = np.asarray(points, np.float64)
    if points.ndim != 2 or points.shape[1] != width:
        raise refused(path, f"{what} of {width} numbers", f"shape {points.shape}", "export the mesh again")
    return points


def _declares(path: Path, keyword: str) -> bool:
    """Whether an OBJ file has lines of this kind; trimesh drops them all if a face refers to one that is not there."""
    return path.suffix.lower() == ".obj" and bool(re.search(rf"(?m)^{keyword}\s".encode(), path.read_bytes()))
