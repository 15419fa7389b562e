"""A mesh as everything above sees it: one list of triangles, numbered as in the file."""

import hashlib
from dataclasses import dataclass, fields
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.materials import Material

FloatArray = NDArray[np.float32]


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
    tangents: FloatArray | None = None  # (V, 4), see mesh.tangents; None for a mesh without normal map

    @property
    def attributes(self) -> dict[str, FloatArray]:
        """What a vertex stage reads of each vertex, by its names, (V, C); a mesh without UVs has uv 0."""
        uv = np.zeros((len(self.positions), 2), np.float32) if self.uvs is None else self.uvs
        tangents = {} if self.tangents is None else {"tangent": self.tangents}
        return {"position": self.positions, "normal": self.normals, "uv": uv, **tangents}

    def hashes(self) -> dict[str, str]:
        """Name of each array -> its `array_hash`."""
        arrays = ((field.name, getattr(self, field.name)) for field in fields(self))
        return {name: array_hash(name, array) for name, array in arrays if isinstance(array, np.ndarray)}


def array_hash(name: str, array: NDArray[Any]) -> str:
    """SHA-256 in hexadecimal of an input as decoded: over its name, type, shape and little-endian bytes (rule A5)."""
    array = np.ascontiguousarray(array, array.dtype.newbyteorder("<"))
    shape = ",".join(map(str, array.shape))
    header = f"sss_ref input 1\n{name}\n{array.dtype.str}\n{shape}\n"
    return hashlib.sha256(header.encode() + array.tobytes()).hexdigest()
