"""Loading a mesh: one list of triangles, whatever the file's format and however many parts it has.

The parts are joined in the order of the file's scene graph as trimesh walks it, each moved by its own transform; quads
and polygons arrive triangulated. That order is the scene order: it numbers the triangles in every buffer. Of the
file's materials only the colours are read. trimesh reads UVs of a glTF part only if the part has a material.
"""

import hashlib
import io
import re
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown
from sss_ref.mesh.materials import Material, gltf_colors, material_of
from sss_ref.mesh.normals import vertex_normals
from sss_ref.mesh.untrusted import BYTE_LIMIT, OwnFolder, check_declarations
from sss_ref.mesh.uv_tiles import Tiled, into_unit_square
from sss_ref.scene_file.shipped import MESH_SUFFIXES
from sss_ref.view.matrices import cross, dot, normal_matrix, transformed

FloatArray = NDArray[np.float32]
# Faces of an OBJ file that trimesh would change without a word: fewer than three corners, or a vertex numbered 0.
BROKEN_FACE = re.compile(rb"^f(?:[ \t]+\S+){0,2}[ \t\r]*$|^f[ \t](?:.*[ \t])?0(?:[/ \t\r].*)?$", re.MULTILINE)


@dataclass(frozen=True, eq=False)
class Mesh:
    """A surface in mesh space, triangles counter-clockwise seen from outside."""

    name: str  # the file's name
    positions: FloatArray  # (V, 3), scene units before the scene's scale
    normals: FloatArray  # (V, 3), as stored or of length 1; 0 where the triangles around a vertex have no area
    uvs: FloatArray | None  # (V, 2), origin bottom-left, as moved by uv_tiles; None unless every part has them
    triangles: NDArray[np.int32]  # (T, 3), indices of vertices
    material: NDArray[np.int32]  # (T,), indices of materials
    materials: tuple[Material, ...]
    normals_source: Literal["file", "computed"]
    shifted: int = 0  # triangles whose UVs were moved into the unit square
    charts: int = 0  # of UVs that `unwrap` made; 0 for the file's own
    notes: tuple[str, ...] = ()  # what of the file was changed or not used, and why

    @property
    def attributes(self) -> dict[str, FloatArray]:
        """What a vertex stage reads of each vertex, by its names, (V, C); a mesh without UVs has uv 0."""
        uv = np.zeros((len(self.positions), 2), np.float32) if self.uvs is None else self.uvs
        return {"position": self.positions, "normal": self.normals, "uv": uv}

    def hashes(self) -> dict[str, str]:
        """Name of each array -> its `array_hash`."""
        arrays = ((field.name, getattr(self, field.name)) for field in fields(self))
        return {name: array_hash(name, array) for name, array in arrays if isinstance(array, np.ndarray)}


@dataclass(frozen=True, eq=False)
class _Part:
    """One geometry of a file, moved to its place; None for what the file does not have."""

    positions: FloatArray
    normals: FloatArray | None
    uvs: FloatArray | None
    triangles: NDArray[np.int64]
    material: Material


def load_mesh(path: Path) -> Mesh:
    """The mesh in the OBJ, PLY, STL, OFF, glTF or GLB file at `path`.

    Stored normals are kept if every part has them, all finite and none 0, otherwise all normals are computed
    (rule R6); which of the two, `normals_source` and `notes` say. Raises MeshError for anything that cannot be drawn.
    """
    _check_file(path)
    parts = [part for part in _parts(path) if len(part.triangles)]
    if not parts:
        raise _refused(path, "at least one triangle", "none", "export the mesh as triangles or polygons")
    positions = np.concatenate([part.positions for part in parts])
    if (positions == positions[0]).all():
        raise _refused(path, "a mesh of some size", "all vertices at one point", "correct them")
    triangles = _joined_triangles(path, parts)
    uvs, uv_notes = _joined_uvs(path, parts)
    normals, normal_notes = _joined_normals(path, parts)
    source: Literal["file", "computed"] = "computed" if normals is None else "file"
    if normals is None:
        normals = vertex_normals(positions, triangles)
    material, materials = _joined_materials(parts)
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
        notes=uv_notes + normal_notes + tiled.notes,
    )


def _check_file(path: Path) -> None:
    if path.suffix.lower() not in MESH_SUFFIXES:
        raise _refused(path, f"one of {', '.join(MESH_SUFFIXES)}", path.suffix or "no suffix", "convert the mesh")
    try:
        if not path.is_file() and path.exists():  # reading a pipe or a device may never end
            raise _refused(path, "a readable file", "a folder or a device", "check the path")
        with path.open("rb") as file:
            size = file.seek(0, 2)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise _refused(path, "a readable file", reason, "check the path") from None
    if size > BYTE_LIMIT:
        raise _refused(path, f"at most {BYTE_LIMIT} bytes", str(size), "simplify the mesh")
    if path.suffix.lower() == ".obj":
        _check_faces(path)


def _check_faces(path: Path) -> None:
    broken = BROKEN_FACE.search(path.read_bytes().replace(b"\\\n", b""))
    if broken:
        face = shown(broken.group().decode(errors="replace").strip())
        raise _refused(path, "faces of at least three vertices, numbered from 1", face, "export the mesh again")


def _parts(path: Path) -> Iterator[_Part]:
    """The triangle meshes of a file in graph order; points and lines are passed over."""
    placed = _read(path)
    exact = gltf_colors(path)
    for geometry, transform in placed:
        if hasattr(geometry, "faces"):
            yield _placed(path, geometry, np.asarray(transform, np.float64), material_of(geometry.visual, exact))


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
            placed = [(scene.geometry[name], place) for place, name in map(scene.graph.get, scene.graph.nodes_geometry)]
    except MeshError:
        raise
    except Exception as error:  # whatever a broken file makes trimesh raise
        reason = f"one that cannot be read ({type(error).__name__}: {error})".splitlines()[0]
        raise _refused(path, f"a valid {suffix[1:]} file", reason, "export the mesh again") from None
    if folder.refusal:
        raise folder.refusal
    return placed


def _has_uvs_by_triangle(path: Path) -> bool:
    """Whether a PLY file stores its UVs with the triangles. trimesh then splits vertices, and leaves normals behind."""
    if path.suffix.lower() != ".ply":
        return False
    with path.open("rb") as file:
        return b"texcoord" in file.read(1 << 16).partition(b"end_header")[0]


def _placed(path: Path, geometry: Any, transform: NDArray[np.float64], material: Material) -> _Part:
    """A geometry under its node's transform: float64, rounded once. Mirrored parts are turned right side out."""
    mirrored, matrix = _orientation(path, transform)
    positions = _points(path, geometry.vertices, 3, "positions")
    normals = _stored_normals(geometry)
    uvs = getattr(geometry.visual, "uv", None)
    moves = not np.array_equal(transform, np.eye(4))
    if normals is not None and moves:
        normals = transformed(matrix, normals)
    return _Part(
        _float32(path, transformed(transform, positions) if moves else positions, "positions"),
        None if normals is None else _rounded(normals),
        None if uvs is None else _float32(path, _points(path, uvs, 2, "UVs"), "UVs"),
        _indices(path, geometry.faces, len(positions))[:, :: -1 if mirrored else 1],
        material,
    )


def _orientation(path: Path, transform: NDArray[np.float64]) -> tuple[bool, NDArray[np.float64]]:
    """Whether a node's transform mirrors, and the 4 x 4 matrix for its normals."""
    matrix = np.eye(4)
    with np.errstate(all="ignore"):
        matrix[:3, :3] = normal_matrix(transform)
    if not (np.isfinite(transform).all() and np.isfinite(matrix).all()):
        raise _refused(path, "transforms that can be inverted", "one that cannot", "apply them before exporting")
    x, y, z = transform[:3, :3]
    return dot(x, cross(y, z)) < 0, matrix


def _stored_normals(geometry: Any) -> NDArray[np.float64] | None:
    """The file's normals (V, 3). trimesh would compute missing ones; its exporters tell the two apart like this."""
    return geometry.vertex_normals if "vertex_normals" in geometry._cache else None


def _points(path: Path, points: Any, width: int, what: str) -> NDArray[np.float64]:
    points = np.asarray(points, np.float64)
    if points.ndim != 2 or points.shape[1] != width:
        raise _refused(path, f"{what} of {width} numbers", f"shape {points.shape}", "export the mesh again")
    return points


def _float32(path: Path, points: NDArray[np.float64], what: str) -> FloatArray:
    rounded = _rounded(points)
    bad = np.flatnonzero(~np.isfinite(rounded).all(axis=1))
    if len(bad):
        came = f"{points[bad[0]].tolist()} at vertex {bad[0]} ({len(bad)} in all)"
        raise _refused(path, f"{what} that are finite in float32", came, "correct them")
    return rounded


def _rounded(points: NDArray[np.float64]) -> FloatArray:
    with np.errstate(over="ignore"):
        return points.astype(np.float32)


def _indices(path: Path, faces: Any, vertices: int) -> NDArray[np.int64]:
    triangles = np.asarray(faces, np.int64).reshape(-1, 3)
    bad = np.flatnonzero(((triangles < 0) | (triangles >= vertices)).any(axis=1))
    if len(bad):
        came = f"{triangles[bad[0]].tolist()} in triangle {bad[0]} ({len(bad)} in all)"
        raise _refused(path, f"vertex indices from 0 to {vertices - 1}", came, "export the mesh again")
    return triangles


def _joined_triangles(path: Path, parts: list[_Part]) -> NDArray[np.int32]:
    starts = np.cumsum([0] + [len(part.positions) for part in parts])
    if starts[-1] > np.iinfo(np.int32).max:
        raise _refused(path, "fewer than 2^31 vertices", str(starts[-1]), "simplify the mesh")
    shifted = [part.triangles + start for part, start in zip(parts, starts[:-1], strict=True)]
    return np.ascontiguousarray(np.concatenate(shifted), np.int32)


def _joined_materials(parts: list[_Part]) -> tuple[NDArray[np.int32], tuple[Material, ...]]:
    """The number of each triangle's material, and the materials, each once."""
    materials = tuple(dict.fromkeys(part.material for part in parts))
    numbers = [materials.index(part.material) for part in parts]
    return np.repeat(np.array(numbers, np.int32), [len(part.triangles) for part in parts]), materials


def _joined_uvs(path: Path, parts: list[_Part]) -> tuple[FloatArray | None, tuple[str, ...]]:
    stored = [part.uvs for part in parts if part.uvs is not None]
    if not stored:
        return None, ("UVs not used: the file does not give them for every corner",) if _declares(path, "vt") else ()
    if len(stored) < len(parts):
        return None, (f"UVs not used: {len(parts) - len(stored)} of {len(parts)} parts have none",)
    if any(len(uvs) != len(part.positions) for uvs, part in zip(stored, parts, strict=True)):
        raise _refused(path, "one UV per vertex", "another number", "export the mesh again")
    return np.concatenate(stored), ()


def _joined_normals(path: Path, parts: list[_Part]) -> tuple[FloatArray | None, tuple[str, ...]]:
    """The stored normals, or None if they are not usable throughout, and what to tell the user about that."""
    stored = [part.normals for part in parts if part.normals is not None]
    if not stored:
        return None, ("normals computed: the file does not give them for every corner",) if _declares(
            path, "vn"
        ) else ()
    if len(stored) < len(parts):
        return None, (f"normals computed: {len(parts) - len(stored)} of {len(parts)} parts have none",)
    if _has_uvs_by_triangle(path):
        return None, ("normals computed: the file's UVs are stored by triangle",)
    normals = np.concatenate(stored)
    unusable = np.count_nonzero(~(np.isfinite(normals).all(axis=1) & normals.any(axis=1)))
    if unusable:
        return None, (f"normals computed: {unusable} of the file's {len(normals)} are zero or not finite",)
    return normals, ()


def _declares(path: Path, keyword: str) -> bool:
    """Whether an OBJ file has lines of this kind; trimesh drops them all if a face refers to one that is not there."""
    return path.suffix.lower() == ".obj" and bool(re.search(rf"(?m)^{keyword}\s".encode(), path.read_bytes()))


def array_hash(name: str, array: NDArray[Any]) -> str:
    """SHA-256 in hexadecimal of an input as decoded: over its name, type, shape and little-endian bytes (rule A5)."""
    array = np.ascontiguousarray(array, array.dtype.newbyteorder("<"))
    shape = ",".join(map(str, array.shape))
    header = f"sss_ref input 1\n{name}\n{array.dtype.str}\n{shape}\n"
    return hashlib.sha256(header.encode() + array.tobytes()).hexdigest()


def _refused(path: Path, expected: str, got: str, remedy: str) -> MeshError:
    return MeshError(f"{path}: expected {expected}, got {got}; {remedy}")
