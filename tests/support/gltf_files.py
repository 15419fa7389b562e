"""glTF files of a few triangles, made of arrays, for the tests of their reader."""

import base64
import json
import struct

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.scene import load_mesh

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)  # of a tetrahedron
FACES = np.array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], np.uint16)  # its triangles, counter-clockwise from outside
COMPONENT_TYPES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class GltfBuilder:
    """A document that grows; each method that adds an entry returns its number."""

    def __init__(self, **top):
        self.binary = b""
        self.tables = {
            "asset": {"version": "2.0"},
            "accessors": [],
            "bufferViews": [],
            "nodes": [{"mesh": 0}],
            "scenes": [{"nodes": [0]}],
            "scene": 0,
            **top,
        }

    def view(self, content, **changes):
        self.binary += bytes(-len(self.binary) % 4)
        self.tables["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(content), **changes}
        )
        self.binary += bytes(content)
        return len(self.tables["bufferViews"]) - 1

    def accessor(self, array, **changes):
        """Elements (N,) or (N, C), tightly packed in a view of their own."""
        array = np.asarray(array)
        width = 1 if array.ndim == 1 else array.shape[1]
        self.tables["accessors"].append(
            {
                "bufferView": self.view(array.tobytes()),
                "componentType": COMPONENT_TYPES[array.dtype.str[1:]],
                "count": len(array),
                "type": TYPES[width],
                **changes,
            }
        )
        return len(self.tables["accessors"]) - 1

    def add(self, table, entry):
        self.tables.setdefault(table, []).append(entry)
        return len(self.tables[table]) - 1

    def primitive(self, indices=FACES, **attributes):
        """A primitive of arrays or of accessors' numbers; POSITION is the tetrahedron's unless it is given."""
        attributes = {"POSITION": CORNERS, **attributes}
        numbers = {name: each if isinstance(each, int) else self.accessor(each) for name, each in attributes.items()}
        indices = indices if indices is None or isinstance(indices, int) else self.accessor(indices)
        return {"attributes": numbers, **({} if indices is None else {"indices": indices})}

    def document(self, buffer):
        tables = {"buffers": [{"byteLength": len(self.binary), **buffer}], **self.tables}
        return {key: value for key, value in tables.items() if value is not None and value != []}

    def written(self, folder, name="a.gltf"):
        """The file with its buffer in it."""
        path = folder / name
        if name.endswith(".glb"):
            path.write_bytes(glb(json.dumps(self.document({})).encode(), self.binary))
        else:
            data = "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
            path.write_text(json.dumps(self.document({"uri": data})))
        return path

    def loaded(self, folder, name="a.gltf"):
        return load_mesh(self.written(folder, name))


def glb(text, binary):
    """A GLB file of two chunks."""
    text, binary = text + b" " * (-len(text) % 4), binary + bytes(-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def tetrahedron(**top):
    """A builder with one mesh of one primitive."""
    builder = GltfBuilder(**top)
    builder.add("meshes", {"primitives": [builder.primitive()]})
    return builder


def message(path):
    """What load_mesh says of a file, without its name; it must be one line."""
    with pytest.raises(MeshError) as error:
        load_mesh(path)
    assert str(error.value).startswith(f"{path}: ") and "\n" not in str(error.value)
    return str(error.value).removeprefix(f"{path}: ")


def refusal(builder, folder):
    """The same of a builder's file."""
    return message(builder.written(folder))


def corners(mesh):
    """The corners of the triangles (T, 3, 3), in order."""
    return mesh.positions[mesh.triangles]


def area(mesh):
    """Of the whole surface."""
    a, b, c = np.moveaxis(corners(mesh).astype(np.float64), 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def volume(mesh):
    """Enclosed; positive only if the triangles run counter-clockwise seen from outside."""
    a, b, c = np.moveaxis(corners(mesh).astype(np.float64), 1, 0)
    return (a * np.cross(b, c)).sum() / 6
