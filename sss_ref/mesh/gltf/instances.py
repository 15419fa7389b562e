"""Copies of a mesh that a node asks for: the extension EXT_mesh_gpu_instancing."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.gltf.accessors import AccessorForm, Accessors
from sss_ref.mesh.gltf.gltf_document import Entry, GltfAccessor, GltfDocument, Whole
from sss_ref.mesh.gltf.hierarchy import Matrix, Placed, placement
from sss_ref.view.matrices import product

NAME = "EXT_mesh_gpu_instancing"
FORMS = {
    "TRANSLATION": AccessorForm("VEC3", ("float",)),
    "ROTATION": AccessorForm("VEC4", ("float", "byte normalized", "short normalized")),
    "SCALE": AccessorForm("VEC3", ("float",)),
}


class Instancing(Entry):
    """The accessors of the copies' transforms."""

    attributes: dict[str, Whole]


def copies(document: GltfDocument, accessors: Accessors, placed: Placed) -> list[Matrix]:
    """world_from_mesh of each copy in order: the node's own * translation * rotation * scale; without copies one."""
    owner = ("nodes", placed.number)
    instancing = document.extension(Instancing, NAME, placed.node, owner)
    if instancing is None:
        return [placed.world]
    place = f"nodes[{placed.number}].extensions.{NAME}"
    if placed.node.skin is not None:
        raise document.refused(place, "a mesh without skin", "a skinned one", "export it without instances")
    used = {name: number for name, number in instancing.attributes.items() if name in FORMS}
    if not used:
        raise document.refused(place, f"one of {', '.join(FORMS)}", "none")
    count = document.entry(GltfAccessor, next(iter(used.values())), f"{place}.attributes").count
    accessors.spend(count)
    values: dict[str, list[Any]] = {}
    for name, number in used.items():
        numbers = accessors.numbers(number, FORMS[name], f"{place}.attributes.{name}", count)
        if not np.isfinite(numbers).all():
            raise document.refused(f"{place}.attributes.{name}", "finite numbers", "others")
        values[name] = numbers.tolist()
    columns = [values.get(name, [None] * count) for name in FORMS]
    return [
        product(placed.world, placement(document, f"{place}[{order}]", *each))
        for order, each in enumerate(zip(*columns, strict=True))
    ]


def is_collapsed(matrix: NDArray[np.float64]) -> bool:
    """Whether a transform takes everything to one point, as a scale of 0 does, which hides a node (glTF 2.0, 3.5.3)."""
    return not matrix[:3, :3].any()
