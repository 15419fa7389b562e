"""Of a glTF document, what decides how much is allocated and how long it is walked: checked against stated limits.

A few bytes of JSON can place a large mesh a million times, or slice a buffer into a million overlapping views, so the
sums are taken before anything is read. See the glTF 2.0 specification for the tables and their keys.
"""

import io
import json
import warnings
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, Field, ValidationError

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown, told, written

VIEW_BYTE_LIMIT = 2**30  # of all bufferViews together, and of all accessors
VERTEX_LIMIT = 2**24  # corners and vertices, over all placed primitives
NODE_LIMIT = 2**14  # of the file
DEPTH_LIMIT = 64  # of the nodes: trimesh takes the cube of it to walk them
PIXEL_LIMIT = 2**26  # of an image

COMPRESSIONS = {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}
COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}

Whole = Annotated[int, Field(strict=True, ge=0)]


class BufferView(BaseModel):
    """A stretch of a buffer."""

    buffer: Whole
    byteLength: Whole
    byteOffset: Whole = 0


class Accessor(BaseModel):
    """Numbers in a view. Without one, or with sparse changes, trimesh would put zeros in their place."""

    bufferView: Whole
    componentType: Literal[5120, 5121, 5122, 5123, 5125, 5126]
    count: Whole
    type: Literal["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]
    sparse: None = None

    @property
    def size(self) -> int:
        """Bytes."""
        return self.count * COMPONENTS[self.type] * COMPONENT_BYTES[self.componentType]


class Primitive(BaseModel):
    """One draw: its vertices and, unless they are drawn in order, its corners."""

    attributes: dict[str, Whole]
    indices: Whole | None = None


class Mesh(BaseModel):
    """What a node places."""

    primitives: list[Primitive]


class Node(BaseModel):
    """A place in the hierarchy."""

    mesh: Whole | None = None
    children: list[Whole] = []


class Image(BaseModel):
    """A picture in the file or beside it."""

    bufferView: Whole | None = None


class Document(BaseModel):
    """The JSON of a glTF file; keys that cost nothing are passed over."""

    extensionsUsed: list[str] = []
    bufferViews: list[BufferView] = []
    accessors: list[Accessor] = []
    meshes: list[Mesh] = []
    nodes: list[Node] = []
    images: list[Image] = []

    def placed(self) -> int:
        """Vertices and corners of all primitives once, and again for each node; a primitive counts at least 1."""
        costs: dict[int | None, int] = {
            number: sum(max(1, self._cost(primitive)) for primitive in mesh.primitives)
            for number, mesh in enumerate(self.meshes)
        }
        return sum(costs.values()) + sum(costs.get(node.mesh, 0) for node in self.nodes)

    def _cost(self, primitive: Primitive) -> int:
        used = (primitive.attributes.get("POSITION"), primitive.indices)
        return sum(accessor.count for number, accessor in enumerate(self.accessors) if number in used)

    def is_shallow_forest(self) -> bool:
        """Whether every node has at most one parent, and at most DEPTH_LIMIT of them up to a root."""
        parents = {child: number for number, node in enumerate(self.nodes) for child in node.children}
        if len(parents) < sum(len(node.children) for node in self.nodes):
            return False
        reached = set(parents)
        for _ in range(DEPTH_LIMIT):
            reached = {node for node in reached if parents[node] in reached}
        return not reached


def check_gltf(path: Path, text: bytes, binary: bytes) -> None:
    """Raise MeshError if a glTF document is not one, or asks for too much.

    text: its JSON; binary: the first chunk of binary data of a GLB file, which holds the images.
    """
    document = _parsed(path, text)
    _require(path, not COMPRESSIONS & set(document.extensionsUsed), "an uncompressed mesh", "a compressed one")
    sizes = [
        (VIEW_BYTE_LIMIT, "bytes in buffer views", sum(view.byteLength for view in document.bufferViews)),
        (VIEW_BYTE_LIMIT, "bytes in accessors", sum(accessor.size for accessor in document.accessors)),
        (VERTEX_LIMIT, "vertices and corners over all nodes", document.placed()),
        (NODE_LIMIT, "nodes", len(document.nodes)),
    ]
    for limit, what, size in sizes:
        _require(path, size <= limit, f"at most {limit} {what}", str(size))
    shallow = f"nodes with one parent each, at most {DEPTH_LIMIT} deep"
    _require(path, document.is_shallow_forest(), shallow, "others")
    _check_images(path, document, binary)


def _parsed(path: Path, text: bytes) -> Document:
    try:
        return Document.model_validate(json.loads(text.decode()))
    except ValidationError as error:
        first = error.errors()[0]
        came = f"{shown(first['input'])} at {written(tuple(first['loc']))} ({first['msg']})"
        raise MeshError(told(str(path), "a valid glTF document", came, "export the mesh again")) from None
    except (ValueError, RecursionError) as error:
        raise MeshError(told(str(path), "a valid glTF document", str(error), "export the mesh again")) from None


def _check_images(path: Path, document: Document, binary: bytes) -> None:
    views = dict[int | None, BufferView](enumerate(document.bufferViews))
    for number, image in enumerate(document.images):
        view = views.get(image.bufferView)
        content = binary[view.byteOffset : view.byteOffset + view.byteLength] if view else b""
        expected = f"images of at most {PIXEL_LIMIT} pixels"
        _require(path, _pixels(content) <= PIXEL_LIMIT, expected, f"more in images[{number}]")


def _pixels(content: bytes) -> int:
    """How many pixels an image declares, none decoded; 0 for what is no image, which the reader of textures refuses."""
    from PIL import Image as pillow

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            width, height = pillow.open(io.BytesIO(content)).size
        except pillow.DecompressionBombError:
            return PIXEL_LIMIT + 1
        except (OSError, ValueError, SyntaxError):
            return 0
    return width * height


def _require(path: Path, holds: bool, expected: str, came: str) -> None:
    if not holds:
        raise MeshError(told(str(path), expected, came, "export the mesh again, simpler"))
