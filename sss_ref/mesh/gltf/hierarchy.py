"""The nodes of a glTF scene in the order they are drawn, and their transforms (glTF 2.0, 3.5)."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.gltf.gltf_document import Entry, GltfDocument, GltfNode, GltfScene, Vec3, Vec4
from sss_ref.view.matrices import product, scaling, translation

Matrix = NDArray[np.float64]

NODE_LIMIT = 2**17  # of a file
UNIT_TOLERANCE = 0.01  # of a quaternion's length: a byte a component leaves 0.008


class Visibility(Entry):
    """The extension KHR_node_visibility of a node."""

    visible: bool = True


class Placed(NamedTuple):
    """A node of the scene."""

    number: int
    node: GltfNode
    world: Matrix  # (4, 4), world_from_node


class Hierarchy:
    """All nodes of a file."""

    def __init__(self, document: GltfDocument) -> None:
        self._document = document
        count = len(document.top.nodes)
        if count > NODE_LIMIT:
            raise document.refused("nodes", f"at most {NODE_LIMIT}", str(count), "simplify the mesh")
        self._nodes = [document.entry(GltfNode, number, "nodes") for number in range(count)]
        self._parents = self._checked_parents()
        self._worlds: dict[int, Matrix] = {}
        self.hidden = 0  # nodes that `placed` passed over

    def _checked_parents(self) -> dict[int, int]:
        parents: dict[int, int] = {}
        for number, node in enumerate(self._nodes):
            for place, child in enumerate(node.children):
                self._document.entry(GltfNode, child, f"nodes[{number}].children[{place}]")
                if child in parents:
                    came = f"nodes[{parents[child]}] and nodes[{number}]"
                    raise self._document.refused(f"nodes[{child}]", "one parent", came)
                parents[child] = number
        return parents

    def placed(self) -> Iterator[Placed]:
        """The visible nodes of the scene, each before its children, children in the order of the file."""
        waiting = self._roots()[::-1]
        while waiting:
            number = waiting.pop()
            node = self._nodes[number]
            visibility = self._document.extension(Visibility, "KHR_node_visibility", node, ("nodes", number))
            if visibility and not visibility.visible:
                self.hidden += 1
                continue
            yield Placed(number, node, self.world(number))
            waiting += node.children[::-1]

    def _roots(self) -> list[int]:
        """The nodes of the scene that is shown: the file's choice, else its first; without scenes all roots."""
        top = self._document.top
        if not top.scenes and top.scene is None:
            return [number for number in range(len(self._nodes)) if number not in self._parents]
        number = top.scene or 0
        scene = self._document.entry(GltfScene, number, "scene")
        for place, root in enumerate(scene.nodes):
            self._document.entry(GltfNode, root, f"scenes[{number}].nodes[{place}]")
            if root in self._parents or root in scene.nodes[:place]:
                reason = f"a child of nodes[{self._parents[root]}]" if root in self._parents else "twice"
                came = f"nodes[{root}], {reason}"
                raise self._document.refused(f"scenes[{number}].nodes[{place}]", "a root node, once", came)
        return scene.nodes

    def world(self, number: int) -> Matrix:
        """world_from_node of any node: the product of the matrices from its root to it."""
        chain = [number]
        while chain[-1] not in self._worlds and chain[-1] in self._parents:
            chain.append(self._parents[chain[-1]])
            if len(chain) > len(self._nodes):
                raise self._document.refused(f"nodes[{number}]", "a node below a root", "one inside itself")
        for child in reversed(chain):
            if child not in self._worlds:
                parent = self._parents.get(child)
                local = self._local(child)
                self._worlds[child] = local if parent is None else product(self._worlds[parent], local)
        return self._worlds[number]

    def _local(self, number: int) -> Matrix:
        """parent_from_node: the node's matrix, or translation * rotation * scale."""
        node, place = self._nodes[number], f"nodes[{number}]"
        if node.matrix is None:
            return placement(self._document, place, node.translation, node.rotation, node.scale)
        if node.translation or node.rotation or node.scale:
            raise self._document.refused(place, "a matrix, or translation, rotation and scale", "both")
        matrix = np.array(node.matrix).reshape(4, 4).T
        if not np.array_equal(matrix[3], [0, 0, 0, 1]):
            came = str(matrix[3].tolist())
            raise self._document.refused(f"{place}.matrix", "[0, 0, 0, 1] as last row", came)
        return matrix


def placement(
    document: GltfDocument, place: str, offset: Vec3 | None, quaternion: Vec4 | None, factors: Vec3 | None
) -> Matrix:
    """translation * rotation * scale, each the identity where it is not given. quaternion: x, y, z, w."""
    matrix = scaling(np.array(factors if factors is not None else [1.0, 1.0, 1.0]))
    if quaternion is not None:
        matrix = product(_rotation(document, place, quaternion), matrix)
    return matrix if offset is None else product(translation(np.array(offset)), matrix)


def _rotation(document: GltfDocument, place: str, quaternion: Vec4) -> Matrix:
    """The rotation of a unit quaternion; what rounding left of its length other than 1 is divided out."""
    x, y, z, w = map(float, quaternion)
    squared = ((x * x + y * y) + z * z) + w * w
    if not (1 - UNIT_TOLERANCE) ** 2 <= squared <= (1 + UNIT_TOLERANCE) ** 2:
        raise document.refused(f"{place}.rotation", "a quaternion of length 1", str([x, y, z, w]))
    s = 2 / squared
    return np.array(
        [
            [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), 0],
            [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), 0],
            [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), 0],
            [0, 0, 0, 1],
        ]
    )
