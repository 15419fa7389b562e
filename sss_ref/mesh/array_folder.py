"""A mesh as a folder of NPY arrays, bit for bit as the passes use it: what a bundle holds of its mesh.

position, normal (V, 3) and uv (V, 2) float32; triangles (T, 3) and material (T,) int32; mesh.json says the rest.
Under a normal map there is tangent (V, 4) float32 for other renderers; here it is computed anew from the other arrays.
"""

import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, ValidationError

from sss_ref.errors import MeshError
from sss_ref.errors.array_file import mapped_array
from sss_ref.errors.text_file import check_regular, text_of
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import finite32, refused, vertex_indices
from sss_ref.mesh.triangles import Mesh

FACTS = "mesh.json"
AGAIN = "write the bundle again"


class MeshRecord(BaseModel):
    """mesh.json: what the arrays do not say. has_uvs: whether uv is the mesh's, and not 0 for want of any."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)

    name: str
    normals: Literal["file", "computed"]
    has_uvs: bool
    materials: tuple[Material, ...]
    notes: tuple[str, ...] = ()


def write_arrays(mesh: Mesh, folder: Path) -> None:
    """Write a mesh into a folder, which is there already."""
    for name, array in {**mesh.attributes, "triangles": mesh.triangles, "material": mesh.material}.items():
        np.save(folder / f"{name}.npy", array)
    record = MeshRecord(
        name=mesh.name,
        normals=mesh.normals_source,
        has_uvs=mesh.uvs is not None,
        materials=mesh.materials,
        notes=mesh.notes,
    )
    (folder / FACTS).write_text(json.dumps(record.model_dump(mode="json"), indent=1) + "\n", encoding="utf-8")


def is_array_folder(path: Path) -> bool:
    """Whether `write_arrays` wrote it, as far as the names of its files tell."""
    return (path / FACTS).is_file()


def read_arrays(folder: Path) -> Mesh:
    """The mesh of a folder. Raises MeshError for files that are not there, damaged, or do not fit each other."""
    record = _record(folder / FACTS)
    triangles = _array(folder / "triangles.npy", np.int32, (3,))
    material = _array(folder / "material.npy", np.int32, ())
    positions, normals = (_array(folder / f"{name}.npy", np.float32, (3,)) for name in ("position", "normal"))
    uvs = _array(folder / "uv.npy", np.float32, (2,))
    _check_lengths(folder, {"position": len(positions), "normal": len(normals), "uv": len(uvs)})
    _check_lengths(folder, {"triangles": len(triangles), "material": len(material)})
    vertex_indices(folder / "triangles.npy", triangles, len(positions))
    if ((material < 0) | (material >= len(record.materials))).any():
        raise refused(folder / "material.npy", f"numbers of {len(record.materials)} materials", "others", AGAIN)
    for name, array in (("position", positions), ("normal", normals), ("uv", uvs)):
        finite32(folder / f"{name}.npy", array.astype(np.float64), "numbers")
    if (positions == positions[0]).all():
        raise refused(folder / "position.npy", "a mesh of some size", "all vertices at one point", AGAIN)
    return Mesh(
        record.name,
        positions,
        normals,
        uvs if record.has_uvs else None,
        triangles,
        material,
        record.materials,
        record.normals,
        notes=record.notes,
    )


def _record(path: Path) -> MeshRecord:
    try:
        return MeshRecord.model_validate_json(text_of(path, "what a bundle says of its mesh", MeshError))
    except ValidationError as error:
        where = ".".join(map(str, error.errors()[0]["loc"])) or "file"
        raise refused(f"{path}: {where}", "what a bundle says of its mesh", "something else", AGAIN) from None


def _array(path: Path, dtype: Any, element: tuple[int, ...]) -> NDArray[Any]:
    """An array (N, *element), at least one; it is mapped first, which takes no memory if the file is too short."""
    check_regular(path, "an NPY file", MeshError)
    try:
        found = mapped_array(path)
    except OSError as error:
        raise refused(path, "an NPY file", error.strerror or "a damaged one", AGAIN) from None
    except Exception:  # whatever a broken file makes NumPy raise
        raise refused(path, "a whole NPY file", "one that is damaged or cut off", AGAIN) from None
    expected = f"{np.dtype(dtype)} ({', '.join(['N', *map(str, element)])})"
    if found is None:
        raise refused(path, expected, "an archive", AGAIN)
    if (found.dtype, found.shape[1:]) != (np.dtype(dtype), element) or not found.size:
        raise refused(path, expected, f"{found.dtype} {found.shape}", AGAIN)
    return np.array(found)


def _check_lengths(folder: Path, lengths: dict[str, int]) -> None:
    if len(set(lengths.values())) > 1:
        came = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise refused(folder, f"as many rows in {' and '.join(lengths)}", came, AGAIN)
