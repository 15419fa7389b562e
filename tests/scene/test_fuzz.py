"""Random damage to meshes and scenes: whatever comes, a result or one of our own errors, soon and in bounds."""

import json
import os
import re
import struct
import subprocess
import sys
import tempfile
from copy import deepcopy
from pathlib import Path

import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st

from sss_ref.errors import MeshError, SceneError
from sss_ref.scene import Mesh, Scene, load_mesh, load_scene
from sss_ref.scene_file.reading import TABLES

EXAMPLES = int(os.environ.get("SSS_REF_FUZZ_EXAMPLES", "200"))
MEMORY = 3 * 2**30  # bytes of address space, most of it reserved by the libraries' threads
QUICK = settings(max_examples=EXAMPLES, database=None)

CORNERS = (0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
FACES = (0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
TEXT_ROWS = "".join(f"{x} {y} {z}\n" for x, y, z in zip(*[iter(CORNERS)] * 3, strict=True))
TEXT_FACES = "".join(f"3 {a} {b} {c}\n" for a, b, c in zip(*[iter(FACES)] * 3, strict=True))


def obj():
    rows = "".join(f"v {row}\nvt .1 .{n}\nvn 0 0 1\n" for n, row in enumerate(TEXT_ROWS.splitlines()))
    corners = iter(FACES)
    faces = "".join(
        "f " + " ".join(f"{n + 1}/{n + 1}/{n + 1}" for n in face) + "\n" for face in zip(*[corners] * 3, strict=True)
    )
    return ("mtllib a.mtl\no one\nusemtl m\n" + rows + faces).encode()


def ply(form):
    names = "".join(f"property float {name}\n" for name in ("x", "y", "z"))
    header = f"ply\nformat {form} 1.0\nelement vertex 4\n{names}element face 4\nproperty list uchar int vertex_index\n"
    faces = b"".join(struct.pack("<B3i", 3, *face) for face in zip(*[iter(FACES)] * 3, strict=True))
    body = (TEXT_ROWS + TEXT_FACES).encode() if form == "ascii" else struct.pack("<12f", *CORNERS) + faces
    return header.encode() + b"end_header\n" + body


def stl(text):
    points = [CORNERS[3 * n : 3 * n + 3] for n in FACES]
    if text:
        loops = ("vertex {} {} {}\n" * 3).join(["facet normal 0 0 1\nouter loop\n", "endloop\nendfacet\n"])
        return ("solid a\n" + (loops * 4).format(*[x for point in points for x in point]) + "endsolid a\n").encode()
    triangles = [struct.pack("<12fH", 0, 0, 1, *sum(points[n : n + 3], ()), 0) for n in range(0, 12, 3)]
    return bytes(80) + struct.pack("<I", 4) + b"".join(triangles)


def gltf_parts():
    """Four placings of a mesh: as it is, mirrored below a node, copied, and hanging on joints, each with a target."""
    binary = struct.pack("<12f12I", *CORNERS, *FACES) + bytes(16) + struct.pack("<4f", 1, 0, 0, 0) * 4 + b"\3\0\0\0"
    attributes = {"POSITION": 0, "NORMAL": 0, "TEXCOORD_0": 2, "JOINTS_0": 3, "WEIGHTS_0": 4}
    texture = {"index": 0, "extensions": {"KHR_texture_transform": {"rotation": 1.5, "scale": [0.5, 0.25]}}}
    views = [(0, 48), (48, 48), (96, 16), (112, 64), (176, 4)]
    sparse = {
        "count": 1,
        "indices": {"bufferView": 4, "componentType": 5121},
        "values": {"bufferView": 0, "byteOffset": 12},
    }
    primitive = {"attributes": attributes, "indices": 1, "material": 0, "targets": [{"POSITION": 5}]}
    return binary, {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 1, 3, 4]}],
        "nodes": [
            {"mesh": 0},
            {"translation": [1, 0, 0], "rotation": [0, 0, 0, 1], "children": [2]},
            {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
            {"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}},
            {"mesh": 0, "skin": 0, "weights": [1]},
        ],
        "skins": [{"joints": [1]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "baseColorTexture": texture}}],
        "meshes": [{"primitives": [primitive], "weights": [0.5]}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5125, "count": 12, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5123, "normalized": True, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5121, "count": 4, "type": "VEC4"},
            {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC4"},
            {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": sparse},
        ],
    }


def glb():
    binary, document = gltf_parts()
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def gltf():
    document = gltf_parts()[1]
    return json.dumps(document | {"buffers": [{"uri": "a.bin", "byteLength": 180}]}).encode()


MESHES = {
    "a.obj": obj(),
    "b.ply": ply("ascii"),
    "c.ply": ply("binary_little_endian"),
    "d.stl": stl(True),
    "e.stl": stl(False),
    "f.off": f"OFF\n4 4 0\n{TEXT_ROWS}{TEXT_FACES}".encode(),
    "g.glb": glb(),
    "h.gltf": gltf(),
}

NUMBERS = ["nan", "-inf", "1e400", "-1", "0", "4294967295", "99999999999999999999", "1e-400", "0x10", "1_0", "٣"]
TOKENS = [
    text.encode() for text in [*NUMBERS, *(f" {n} " for n in NUMBERS), "\n", "\0", "/", "//", "#", "{}", "[]", "null"]
]
TOKENS += [struct.pack("<I", n) for n in (0, 1, 2**16, 2**31, 2**32 - 1)] + [struct.pack("<f", float("nan"))]
MUTATIONS = st.lists(
    st.tuples(
        st.sampled_from(["flip", "cut", "copy", "put", "over"]),
        st.integers(0),
        st.integers(0, 64),
        st.sampled_from(TOKENS),
    ),
    min_size=1,
    max_size=6,
)


def mutated(data, mutations):
    """The bytes after flipping a bit, cutting the end or copying a stretch, inserting or overwriting with a token."""
    for kind, where, size, token in mutations:
        at = where % (len(data) + 1)
        data = {
            "flip": data[:at] + bytes(byte ^ 1 << size % 8 for byte in data[at : at + 1]) + data[at + 1 :],
            "cut": data[:at] + data[at + size :] if size else data[:at],
            "copy": data[:at] + data[at : at + size] * 2 + data[at + size :],
            "put": data[:at] + token + data[at:],
            "over": data[:at] + token + data[at + len(token) :],
        }[kind]
    return data


def check_mesh(folder, name, content):
    path = folder / name
    path.write_bytes(content)
    (folder / "a.bin").write_bytes(gltf_parts()[0])
    (folder / "a.mtl").write_text("newmtl m\nKd 1 .5 .25\n")
    try:
        assert isinstance(load_mesh(path), Mesh)
    except MeshError as error:
        assert re.match(rf"{re.escape(str(path))}: (\S+: )?expected .*, got .*; .*\Z", str(error))
        assert "MemoryError" not in str(error)


@pytest.mark.parametrize("name", MESHES)
def test_meshes_before_they_are_damaged(tmp_path, name):
    (tmp_path / "a.bin").write_bytes(gltf_parts()[0])
    (tmp_path / name).write_bytes(MESHES[name])
    assert len(load_mesh(tmp_path / name).triangles) == (28 if name[0] in "gh" else 4)


@seed(1)
@QUICK
@given(st.sampled_from(sorted(MESHES)), MUTATIONS)
def test_damaged_mesh(name, mutations):
    with tempfile.TemporaryDirectory() as folder:
        check_mesh(Path(folder), name, mutated(MESHES[name], mutations))


JSON_VALUES = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-2, 2**33),
    st.floats(),
    st.sampled_from([[], {}, "", "a.bin", [0], [[0]], 5126]),
)


@st.composite
def damaged_documents(draw):
    """The glTF document with a few values replaced or keys removed, anywhere."""
    document = gltf_parts()[1] | {"buffers": [{"uri": "a.bin", "byteLength": 180}]}
    for _ in range(draw(st.integers(1, 3))):
        place = document
        key = draw(st.sampled_from(sorted(document)))
        while isinstance(place[key], dict | list) and place[key] and draw(st.integers(0, 5)):
            place = place[key]
            key = draw(st.sampled_from(sorted(place) if isinstance(place, dict) else range(len(place))))
        place[key] = deepcopy(draw(JSON_VALUES))  # a list drawn twice is one object: it must not end up in itself
    return json.dumps(document).encode()


@seed(2)
@QUICK
@given(damaged_documents())
def test_damaged_gltf_document(content):
    with tempfile.TemporaryDirectory() as folder:
        check_mesh(Path(folder), "h.gltf", content)


KEYS = sorted(
    {name for table in TABLES.values() for name in table.model_fields} | {"", "a.b", "0", "type", "²", "9" * 5000}
)
PATHS = [
    "lights.0",
    "lights",
    "lights.1",
    "lights.-1",
    *(".".join(p) for p in TABLES if p and "camera" not in p),
    "camera",
]
SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.sampled_from([10**400, -1, 0, 2**31, 16384, 3e38, 1e-46]),
    st.floats(),
    st.text(max_size=8),
    st.binary(max_size=3),
    st.sampled_from(["tetrahedron", "orbit", "free", "look_at", "robust", "a\0b", "x" * 5000, "/", "..", "hbh09"]),
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: (
        st.lists(inner, max_size=5)
        | st.dictionaries(st.sampled_from(KEYS) | st.text(max_size=4), inner, max_size=4)
        | st.lists(st.floats(-10, 10), min_size=3, max_size=3)
    ),
    max_leaves=12,
)
OVERRIDES = st.dictionaries(
    st.sampled_from(KEYS) | st.builds("{}.{}".format, st.sampled_from(PATHS), st.sampled_from(KEYS)), VALUES, max_size=5
)


def check_scene(scene, **overrides):
    try:
        assert isinstance(load_scene(scene, **overrides), Scene)
    except (SceneError, MeshError) as error:
        assert str(error) and "MemoryError" not in str(error)


@seed(3)
@QUICK
@given(st.dictionaries(st.sampled_from(KEYS), VALUES, max_size=6), OVERRIDES)
def test_random_scene(data, overrides):
    check_scene(data, **overrides)


@seed(4)
@QUICK
@given(overrides=OVERRIDES)
def test_random_overrides(small, overrides):
    check_scene(small, **overrides)


@seed(5)
@QUICK
@given(mutations=MUTATIONS)
def test_damaged_scene_file(data_folder, mutations):
    path = data_folder / "scenes" / "damaged.toml"
    path.write_bytes(mutated((data_folder / "scenes" / "small.toml").read_bytes(), mutations))
    check_scene(path)


LONG_RUN = """
import resource, sys, pytest
resource.setrlimit(resource.RLIMIT_AS, (int(sys.argv[2]),) * 2)
sys.exit(pytest.main([sys.argv[1], "-x", "-p", "no:cacheprovider"]))
"""


@pytest.mark.full
def test_for_longer_within_memory():
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2]), "SSS_REF_FUZZ_EXAMPLES": "2000"}
    command = [sys.executable, "-c", LONG_RUN, __file__, str(MEMORY)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=1800)
    assert done.returncode == 0, done.stdout + done.stderr
