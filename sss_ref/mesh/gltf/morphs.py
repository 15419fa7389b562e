"""Morph targets at rest: what a mesh's or node's weights add to the attributes (glTF 2.0, 3.7.2.2)."""

from typing import NamedTuple

from sss_ref.mesh.gltf.accessors import AccessorForm, Accessors, Numbers
from sss_ref.mesh.gltf.gltf_document import GltfDocument, GltfMesh, GltfNode, GltfPrimitive

SIGNED = ("byte", "byte normalized", "short", "short normalized")
EITHER = ("float", "byte normalized", "short normalized", "unsigned byte normalized", "unsigned short normalized")
DELTAS = {"VEC3": AccessorForm("VEC3", ("float",), SIGNED), "VEC2": AccessorForm("VEC2", EITHER, SIGNED)}


def weights_of(node: GltfNode, mesh: GltfMesh) -> list[float]:
    """The weights of a node's mesh: the node's, else the mesh's; none given means 0."""
    return node.weights or mesh.weights or []


class Morphs(NamedTuple):
    """A primitive with its targets; those of weight 0 are not looked at."""

    document: GltfDocument
    accessors: Accessors
    place: str
    primitive: GltfPrimitive
    weights: list[float]

    def applied(self, name: str, form: AccessorForm, count: int | None) -> Numbers:
        """An attribute (V, C) plus the weighted sum of its displacements, added in the order of the targets."""
        user = f"{self.place}.attributes.{name}"
        values = self.accessors.numbers(self.primitive.attributes[name], form, user, count)
        if self.weights and len(self.weights) != len(self.primitive.targets):
            came = f"{len(self.weights)} weights"
            expected = f"a weight for each of {len(self.primitive.targets)} targets"
            raise self.document.refused(self.place, expected, came)
        for number, (weight, target) in enumerate(zip(self.weights, self.primitive.targets, strict=False)):
            if weight and name in target:
                self.accessors.spend(len(values))
                user = f"{self.place}.targets[{number}].{name}"
                values += weight * self.accessors.numbers(target[name], DELTAS[form.type], user, len(values))
        return values
