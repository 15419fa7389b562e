"""Copies by EXT_mesh_gpu_instancing: node * translation * rotation * scale."""

import numpy as np
import pytest
from gltf_files import CORNERS, GltfBuilder, corners, refusal, tetrahedron, volume

NAME = "EXT_mesh_gpu_instancing"
PLACE = f"nodes[0].extensions.{NAME}"
OFFSETS = np.float32([[0, 0, 0], [5, 0, 0]])
AGAIN = "; export the mesh again"


def copied(node=None, primitives=1, **attributes):
    builder = GltfBuilder(extensionsUsed=[NAME])
    builder.add("meshes", {"primitives": [builder.primitive() for _ in range(primitives)]})
    numbers = {name: each if isinstance(each, int) else builder.accessor(each) for name, each in attributes.items()}
    builder.tables["nodes"] = [{"mesh": 0, **(node or {}), "extensions": {NAME: {"attributes": numbers}}}]
    return builder


def lows(mesh):
    """The least corner of each tetrahedron, in order."""
    return corners(mesh).reshape(-1, 12, 3).min(axis=1).tolist()


@pytest.mark.parametrize("required", [[], [NAME]])
def test_copies(tmp_path, required):
    """Two, reaching to (6, 1, 1), whether or not the file says it cannot do without."""
    builder = copied(TRANSLATION=OFFSETS)
    builder.tables["extensionsRequired"] = required
    loaded = builder.loaded(tmp_path)
    assert len(loaded.triangles) == 8 and loaded.positions.max(axis=0).tolist() == [6, 1, 1]
    assert lows(loaded) == [[0, 0, 0], [5, 0, 0]]


def test_the_copy_comes_before_the_node(tmp_path):
    half = np.float32(0.5**0.5)
    builder = copied(
        {"scale": [10, 10, 10]},
        TRANSLATION=OFFSETS[1:],
        ROTATION=np.float32([[0, 0, half, half]]),
        SCALE=np.float32([[2, 3, 4]]),
    )
    loaded = builder.loaded(tmp_path)
    naive = np.stack([-3 * CORNERS[:, 1] + 5, 2 * CORNERS[:, 0], 4 * CORNERS[:, 2]], axis=1) * 10
    assert loaded.positions == pytest.approx(naive, abs=1e-5)
    assert volume(loaded) == pytest.approx(24 * 1000 / 6)


@pytest.mark.parametrize("dtype", [np.int8, np.int16])
def test_normalized_rotations(tmp_path, dtype):
    """A quarter turn about x; what rounding leaves of the length is divided out."""
    largest = np.iinfo(dtype).max
    turn = np.round(np.array([[0.5**0.5, 0, 0, 0.5**0.5]]) * largest).astype(dtype)
    builder = copied(ROTATION=turn)
    builder.tables["accessors"][-1]["normalized"] = True
    expected = CORNERS[:, [0, 2, 1]] * [1, -1, 1]
    assert builder.loaded(tmp_path).positions == pytest.approx(expected, abs=1e-7)


def test_mirroring_copies(tmp_path):
    loaded = copied(SCALE=np.float32([[1, 1, 1], [-2, 1, 1]])).loaded(tmp_path)
    assert volume(loaded) == pytest.approx(3 / 6)


def test_each_primitive_is_copied_before_the_next(tmp_path):
    """As it is drawn: one call for all copies of a primitive."""
    builder = copied(primitives=2, TRANSLATION=OFFSETS)
    builder.tables["accessors"][2] = {**builder.tables["accessors"][2]}
    second = builder.primitive(POSITION=CORNERS + np.float32([0, 0, 9]))
    builder.tables["meshes"][0]["primitives"][1] = second
    assert lows(builder.loaded(tmp_path)) == [[0, 0, 0], [5, 0, 0], [0, 0, 9], [5, 0, 9]]


def test_attributes_of_an_application_are_not_looked_at(tmp_path):
    assert len(copied(TRANSLATION=OFFSETS, _ID=99).loaded(tmp_path).triangles) == 8


def test_copies_of_nothing_are_noted(tmp_path):
    """The extension defines none for a node without mesh."""
    builder = copied(TRANSLATION=OFFSETS)
    builder.tables["nodes"] = [{"children": [1], **builder.tables["nodes"][0]}, {"mesh": 0}]
    del builder.tables["nodes"][0]["mesh"]
    loaded = builder.loaded(tmp_path)
    assert len(loaded.triangles) == 4 and loaded.notes == (f"nodes[0]: {NAME} not used: it has no mesh",)


BAD = {
    "none": (copied(), f"{PLACE}: expected one of TRANSLATION, ROTATION, SCALE, got none{AGAIN}"),
    "different counts": (
        copied(TRANSLATION=OFFSETS, SCALE=np.ones((3, 3), np.float32)),
        f"{PLACE}.attributes.SCALE: expected 2 elements, as many as the others, got 3{AGAIN}",
    ),
    "no number": (
        copied(TRANSLATION=np.float32([[0, np.nan, 0]])),
        f"{PLACE}.attributes.TRANSLATION: expected finite numbers, got others{AGAIN}",
    ),
    "no unit quaternion": (
        copied(ROTATION=np.float32([[0, 0, 0, 1], [0, 0, 0, 0]])),
        f"{PLACE}[1].rotation: expected a quaternion of length 1, got [0.0, 0.0, 0.0, 0.0]{AGAIN}",
    ),
    "a skin": (
        copied({"skin": 0}, TRANSLATION=OFFSETS),
        f"{PLACE}: expected a mesh without skin, got a skinned one; export it without instances",
    ),
    "no attributes": (
        tetrahedron(nodes=[{"mesh": 0, "extensions": {NAME: {}}}]),
        f"{PLACE}.attributes: expected a value, got nothing{AGAIN}",
    ),
}


@pytest.mark.parametrize("builder, expected", BAD.values(), ids=BAD)
def test_bad_copies(tmp_path, builder, expected):
    assert refusal(builder, tmp_path) == expected
