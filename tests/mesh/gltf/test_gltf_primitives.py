"""Triangles of primitives in each mode, and what of them is not used (glTF 2.0, 3.7.2.1)."""

import numpy as np
import pytest
from gltf_files import CORNERS, FACES, GltfBuilder, area, corners, refusal, tetrahedron, volume

AGAIN = "; export the mesh again"
ROW = np.float32([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0]])  # a band, zigzag
ROUND = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0]])  # around the first


def of_mode(mode, indices, points, **attributes):
    builder = GltfBuilder()
    primitive = builder.primitive(indices, POSITION=points, **attributes)
    builder.add("meshes", {"primitives": [{**primitive, "mode": mode}]})
    return builder


@pytest.mark.parametrize("indices", [None, np.arange(6, dtype=np.uint8)])
def test_strip(tmp_path, indices):
    """p_i = {v_i, v_(i + (1 + i%2)), v_(i + (2 - i%2))}: all turn the same way, here clockwise."""
    loaded = of_mode(5, indices, ROW).loaded(tmp_path)
    assert loaded.triangles.tolist() == [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]]
    assert area(loaded) == 2
    a, b, c = np.moveaxis(corners(loaded), 1, 0)
    assert np.array_equal(np.cross(b - a, c - a), [[0, 0, -1]] * 4)


def test_strip_keeps_triangles_without_area_in_the_count(tmp_path):
    """They join two pieces; a graphics processor numbers them too."""
    stitched = np.uint16([0, 1, 2, 2, 3, 3, 4, 5])
    loaded = of_mode(5, stitched, ROW).loaded(tmp_path)
    assert loaded.triangles.tolist() == [[0, 1, 2], [1, 2, 2], [2, 2, 3], [2, 3, 3], [3, 3, 4], [3, 5, 4]]


@pytest.mark.parametrize("indices", [None, np.arange(5, dtype=np.uint16)])
def test_fan(tmp_path, indices):
    """p_i = {v_(i+1), v_(i+2), v_0}."""
    loaded = of_mode(6, indices, ROUND).loaded(tmp_path)
    assert loaded.triangles.tolist() == [[1, 2, 0], [2, 3, 0], [3, 4, 0]]
    assert area(loaded) == 1.5 and (loaded.normals == [0, 0, 1]).all()


def test_primitives_in_order(tmp_path):
    """A list of one triangle, which leaves a vertex out, then a fan of two: three triangles."""
    square = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    builder = GltfBuilder()
    first = builder.primitive(np.uint16([0, 1, 2]), POSITION=square)
    second = {**builder.primitive(np.uint16([0, 1, 2, 3]), POSITION=square), "mode": 6}
    builder.add("meshes", {"primitives": [first, second]})
    loaded = builder.loaded(tmp_path)
    assert loaded.triangles.tolist() == [[0, 1, 2], [4, 5, 3], [5, 6, 3]]


@pytest.mark.parametrize("mode", [0, 1, 2, 3])
def test_points_and_lines(tmp_path, mode):
    expected = "expected at least one triangle, got none; export the mesh as triangles or polygons"
    assert refusal(of_mode(mode, FACES, CORNERS), tmp_path) == expected
    builder = tetrahedron()
    builder.tables["meshes"][0]["primitives"].append({**builder.primitive(), "mode": mode})
    loaded = builder.loaded(tmp_path)
    assert len(loaded.triangles) == 4
    assert loaded.notes == ("meshes[0].primitives[1] not used: points or lines",)


def test_no_positions(tmp_path):
    builder = tetrahedron()
    builder.tables["meshes"][0]["primitives"].append({"attributes": {}})
    assert builder.loaded(tmp_path).notes == ("meshes[0].primitives[1] not used: no positions",)


COUNTS = [
    (4, np.uint16([0, 1, 2, 3]), "indices: expected a multiple of 3 corners, got 4"),
    (4, None, "expected a multiple of 3 corners, got 4"),
    (5, np.uint16([0, 1]), "indices: expected at least 3 corners, got 2"),
    (6, np.uint16([0]), "indices: expected at least 3 corners, got 1"),
    (4, np.uint16([0, 1, 4]), "indices: expected vertex indices from 0 to 3, got [0, 1, 4] in triangle 0 (1 in all)"),
    (4, np.uint8([0, 255, 1]),
     "indices: expected vertex indices from 0 to 3, got [0, 255, 1] in triangle 0 (1 in all)"),
    (4, np.float32([0, 1, 2]), "indices: expected SCALAR of unsigned byte or unsigned short or unsigned int, "
     "got SCALAR of float"),
    (4, np.int16([0, 1, 2]), "indices: expected SCALAR of unsigned byte or unsigned short or unsigned int, "
     "got SCALAR of short"),
]  # fmt: skip


@pytest.mark.parametrize("mode, indices, expected", COUNTS)
def test_bad_corners(tmp_path, mode, indices, expected):
    place = "meshes[0].primitives[0]" + ("." if expected.startswith("indices") else ": ")
    assert refusal(of_mode(mode, indices, CORNERS), tmp_path) == f"{place}{expected}{AGAIN}"


def test_bad_mode(tmp_path):
    assert refusal(of_mode(7, FACES, CORNERS), tmp_path) == (
        f"meshes[0].primitives[0].mode: expected 0, 1, 2, 3, 4, 5 or 6, got 7{AGAIN}"
    )


def test_uvs_of_a_primitive_without_material(tmp_path):
    uvs = np.float32([[0, 0], [1, 0], [0.25, 0.5], [1, 1]])
    loaded = of_mode(4, FACES, CORNERS, TEXCOORD_0=uvs).loaded(tmp_path)
    assert np.array_equal(loaded.uvs, [[0, 1], [1, 1], [0.25, 0.5], [1, 0]])


def test_uvs_that_are_not_finite(tmp_path):
    uvs = np.float32([[0, 0], [1, np.inf], [0, 1], [1, 1]])
    assert refusal(of_mode(4, FACES, CORNERS, TEXCOORD_0=uvs), tmp_path) == (
        "meshes[0].primitives[0]: expected UVs that are finite in float32, got [1.0, -inf] at vertex 1 (1 in all); "
        "correct them"
    )


def test_attributes_that_are_not_used_are_not_looked_at(tmp_path):
    builder = tetrahedron()
    builder.tables["meshes"][0]["primitives"][0]["attributes"] |= {"COLOR_0": 99, "TANGENT": 98, "_OWN": 97}
    assert volume(builder.loaded(tmp_path)) == pytest.approx(1 / 6)


def test_draco(tmp_path):
    """Read where the uncompressed data is there too; else refused by name."""
    name = "KHR_draco_mesh_compression"
    builder = tetrahedron(extensionsUsed=[name])
    builder.tables["meshes"][0]["primitives"][0]["extensions"] = {name: {"bufferView": 0, "attributes": {}}}
    assert volume(builder.loaded(tmp_path)) == pytest.approx(1 / 6)
    del builder.tables["accessors"][1]["bufferView"]
    builder.tables["extensionsRequired"] = [name]
    assert refusal(builder, tmp_path) == (
        f"meshes[0].primitives[0]: expected uncompressed data, got {name} alone; export it without compression"
    )


def test_colours_of_vertices_are_noted(tmp_path):
    """They multiply the material's colour in a renderer that has them (glTF 2.0, 3.9.2)."""
    loaded = of_mode(6, None, ROUND, COLOR_0=np.float32([[0.5, 0.5, 0.5]] * 5)).loaded(tmp_path)
    assert loaded.materials[0].color == (1, 1, 1)
    assert loaded.notes == ("colours of vertices (COLOR_0) are not used",)
