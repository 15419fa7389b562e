"""A glTF or GLB file as parts, one for each primitive at each place, in the order of the file.

Nodes come depth first, each before its children; of a mesh the primitives in order, and of a primitive its copies.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sss_ref.mesh.gltf.accessors import Accessors
from sss_ref.mesh.gltf.gltf_document import GltfMesh, GltfPrimitive
from sss_ref.mesh.gltf.gltf_file import opened
from sss_ref.mesh.gltf.gltf_primitives import GltfSurface, PrimitiveReader
from sss_ref.mesh.gltf.hierarchy import Hierarchy, Matrix, Placed
from sss_ref.mesh.gltf.instances import NAME, copies, is_collapsed
from sss_ref.mesh.gltf.morphs import weights_of
from sss_ref.mesh.gltf.skins import Skins
from sss_ref.mesh.part import FileContent, Part, placed

PART_LIMIT = 2**16  # primitives over all nodes and copies


def read_gltf(path: Path) -> FileContent:
    """The parts of a glTF or GLB file; raises MeshError for one that is broken, hostile or needs what is not known."""
    with np.errstate(all="ignore"):  # numbers that are too large: positions and UVs are checked when they are rounded
        return _GltfReader(path).content()


class _GltfReader:
    def __init__(self, path: Path) -> None:
        file = opened(path)
        self._document, self._notes = file.document, dict.fromkeys(file.notes)
        self._accessors = Accessors(file)
        self._hierarchy = Hierarchy(file.document)
        self._skins = Skins(file.document, self._accessors, self._hierarchy)
        self._primitives = PrimitiveReader(file.document, self._accessors)

    def content(self) -> FileContent:
        parts = []
        for node in self._hierarchy.placed():
            for part in self._parts(node):
                parts.append(part)
                if len(parts) > PART_LIMIT:
                    expected = f"at most {PART_LIMIT} primitives over all nodes"
                    raise self._document.refused("nodes", expected, "more", "simplify the mesh")
        hidden = (f"{self._hierarchy.hidden} hidden nodes not read",) if self._hierarchy.hidden else ()
        return FileContent(parts, (*self._notes, *self._primitives.notes, *hidden))

    def _parts(self, node: Placed) -> Iterator[Part]:
        number = node.node.mesh
        if number is None:
            if NAME in node.node.extensions:
                self._notes[f"nodes[{node.number}]: {NAME} not used: it has no mesh"] = None
            return
        mesh = self._document.entry(GltfMesh, number, f"nodes[{node.number}].mesh")
        transforms = copies(self._document, self._accessors, node)
        for order, value in enumerate(mesh.primitives):
            self._accessors.spend(1)
            primitive = self._document.checked(GltfPrimitive, value, ("meshes", number, "primitives", order))
            place = f"meshes[{number}].primitives[{order}]"
            surface = self._primitives.surface(place, primitive, weights_of(node.node, mesh))
            if surface is not None:
                yield from self._placed(surface, node, transforms)

    def _placed(self, surface: GltfSurface, node: Placed, transforms: list[Matrix]) -> Iterator[Part]:
        if node.node.skin is not None:
            surface = self._skins.posed(surface, node.node.skin, f"nodes[{node.number}].skin")
            transforms = [np.eye(4)]
        self._accessors.spend((len(transforms) - 1) * (len(surface.positions) + 3 * len(surface.triangles)))
        for transform in transforms:
            if is_collapsed(transform):
                self._notes[f"nodes[{node.number}] not read: a scale of 0 hides it"] = None
                continue
            where = f"{self._document.path}: {surface.place} at nodes[{node.number}]"
            positions, normals, triangles = placed(
                where, transform, surface.positions, surface.normals, surface.triangles
            )
            yield Part(positions, normals, surface.uvs, triangles, surface.material)
