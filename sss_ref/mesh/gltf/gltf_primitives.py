"""The triangles of a glTF primitive before any node moves them (glTF 2.0, 3.7.2)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.gltf.accessors import AccessorForm, Accessors, Numbers
from sss_ref.mesh.gltf.gltf_document import GltfDocument, GltfPrimitive
from sss_ref.mesh.gltf.gltf_materials import Appearance
from sss_ref.mesh.gltf.gltf_normal_maps import normal_map_notes
from sss_ref.mesh.gltf.morphs import Morphs
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import FloatArray, finite32, refused, vertex_indices

WHOLE = ("byte", "unsigned byte", "short", "unsigned short")
ANY_INTEGER = (*WHOLE, *(f"{form} normalized" for form in WHOLE))
POSITION = AccessorForm("VEC3", ("float",), ANY_INTEGER)
NORMAL = AccessorForm("VEC3", ("float",), ("byte normalized", "short normalized"))
TEXCOORD = AccessorForm("VEC2", ("float", "unsigned byte normalized", "unsigned short normalized"), ANY_INTEGER)
INDICES = AccessorForm("SCALAR", ("unsigned byte", "unsigned short", "unsigned int"), tight=True)

TRIANGLES, STRIP, FAN = 4, 5, 6


@dataclass(frozen=True, eq=False)
class GltfSurface:
    """A primitive in the space of its mesh, morphed; None for what the file does not have."""

    place: str  # of the primitive in the document
    primitive: GltfPrimitive
    positions: Numbers  # (V, 3)
    normals: Numbers | None  # (V, 3)
    uvs: FloatArray | None  # (V, 2), origin bottom-left
    triangles: NDArray[np.int64]  # (T, 3)
    material: Material


class PrimitiveReader:
    """The surfaces of a file's primitives, and what of them could not be used."""

    def __init__(self, document: GltfDocument, accessors: Accessors) -> None:
        self._document, self._accessors = document, accessors
        self.notes: dict[str, None] = {}  # in the order they came up, each once

    def surface(self, place: str, primitive: GltfPrimitive, weights: list[float]) -> GltfSurface | None:
        """A primitive with its morph targets at these weights; None, and a note, for what has no triangles."""
        if primitive.mode < TRIANGLES or "POSITION" not in primitive.attributes:
            reason = "points or lines" if primitive.mode < TRIANGLES else "no positions"
            self.notes[f"{place} not used: {reason}"] = None
            return None
        self._refuse_draco(place, primitive)
        if "COLOR_0" in primitive.attributes:
            self.notes["colours of vertices (COLOR_0) are not used"] = None
        appearance = Appearance(self._document, primitive.material, f"{place}.material")
        if appearance.normal_texture is not None:
            tangents = "TANGENT" in primitive.attributes
            notes = normal_map_notes(self._document, appearance.normal_texture, appearance.uv_set, tangents)
            self.notes |= dict.fromkeys(notes)
        morphs = Morphs(self._document, self._accessors, place, primitive, weights)
        positions = morphs.applied("POSITION", POSITION, None)
        count = len(positions)
        normals = morphs.applied("NORMAL", NORMAL, count) if "NORMAL" in primitive.attributes else None
        uvs = self._uvs(morphs, appearance, count)
        triangles = self._triangles(place, primitive, count)
        self._accessors.spend(count + 3 * len(triangles))
        return GltfSurface(place, primitive, positions, normals, uvs, triangles, appearance.material)

    def _refuse_draco(self, place: str, primitive: GltfPrimitive) -> None:
        """Draco's data is not read; where an accessor has no view, it is all there is."""
        name = "KHR_draco_mesh_compression"
        users = {f"{place}.attributes.{each}": number for each, number in primitive.attributes.items()}
        if primitive.indices is not None:
            users[f"{place}.indices"] = primitive.indices
        if name in primitive.extensions and not all(self._accessors.has_data(users[user], user) for user in users):
            remedy = "export it without compression"
            raise self._document.refused(place, "uncompressed data", f"{name} alone", remedy)

    def _uvs(self, morphs: Morphs, appearance: Appearance, count: int) -> FloatArray | None:
        """The UVs that the colour texture is looked up at, with v turned up."""
        name = f"TEXCOORD_{appearance.uv_set}"
        if name not in morphs.primitive.attributes:
            if appearance.uv_set:
                self.notes[f"UVs not used: {morphs.place} has no {name}, which its colour texture asks for"] = None
            return None
        uvs = appearance.looked_up(morphs.applied(name, TEXCOORD, count))
        uvs[:, 1] = 1.0 - uvs[:, 1]
        return finite32(f"{self._document.path}: {morphs.place}", uvs, "UVs")

    def _triangles(self, place: str, primitive: GltfPrimitive, count: int) -> NDArray[np.int64]:
        corners = np.arange(count)
        if primitive.indices is not None:
            place = f"{place}.indices"
            corners = self._accessors.integers(primitive.indices, INDICES, place)[:, 0].astype(np.int64)
        where = f"{self._document.path}: {place}"
        if len(corners) < 3 or (primitive.mode == TRIANGLES and len(corners) % 3):
            expected = "a multiple of 3 corners" if primitive.mode == TRIANGLES else "at least 3 corners"
            raise refused(where, expected, str(len(corners)), "export the mesh again")
        return vertex_indices(where, assembled(corners, primitive.mode), count)


def assembled(corners: NDArray[np.int64], mode: int) -> NDArray[np.int64]:
    """Triangles (T, 3) of corners in the order the specification draws them, those of no area too.

    Every other triangle of a strip is turned, so that all run the same way round. A fan's triangle begins with its
    second corner and ends with the fan's first.
    """
    if mode == TRIANGLES:
        return corners.reshape(-1, 3)
    if mode == FAN:
        return np.stack([corners[1:-1], corners[2:], np.full(len(corners) - 2, corners[0])], axis=1)
    triangles = np.stack([corners[:-2], corners[1:-1], corners[2:]], axis=1)
    triangles[1::2, 1:] = triangles[1::2, :0:-1]
    return triangles
