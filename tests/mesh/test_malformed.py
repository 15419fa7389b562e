"""Files of bad or hostile content: each gives an exact mesh or an exact message."""

import os
import struct

import numpy as np
import pytest

from sss_ref.errors import MeshError, SceneError
from sss_ref.mesh import mesh_file as mesh
from sss_ref.mesh import untrusted
from sss_ref.scene import load_mesh, load_scene

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
CORNERS = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
NO_TRIANGLE = "expected at least one triangle, got none; export the mesh as triangles or polygons"
FACES = "expected faces of at least three vertices, numbered from 1, got {}; export the mesh again"
VERTICES = "expected faces of the vertices 1 to {} that the file has, got {}; export the mesh again"

# triangles and bounds, or the message after the file's name
ASSETS = {
    "malformed/BoxBadNormals.glb": (12, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)),
    "malformed/IndexOutOfRange/IndexOutOfRange.gltf": "meshes[0].primitives[0].indices: "
    "expected vertex indices from 0 to 23, got [255, 1, 2] in triangle 0 (1 in all); export the mesh again",
    "malformed/box_without_lineending.obj": (12, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)),
    "malformed/concave_polygon.obj": (64, (-1.146, 1.6575, 1.6055), (-1.146, 3.1425, 3.0905)),
    "malformed/cube_compressed.obj": (12, (-1, -1, -1), (1, 1, 1.000001)),
    "malformed/cubevt.obj": (12, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)),
    "malformed/empty.obj": NO_TRIANGLE,
    "malformed/empty.ply": NO_TRIANGLE,
    "malformed/empty_nodes.glb": NO_TRIANGLE,
    "malformed/face_in_group_name.obj": NO_TRIANGLE,
    "malformed/issue623.ply": NO_TRIANGLE,
    "malformed/joined_tetrahedra.obj": (8, (-0.5, -0.8660254, -1), (1, 0.8660254, 1)),
    "malformed/malformed.obj": VERTICES.format(8, '"f 4 12 2 1" in line 23'),
    "malformed/mirror.ply": (286, (-0.726235, 5.22131, 7.69071), (0.391765, 6.33931, 7.80871)),
    "malformed/nancolor.obj": (12, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)),
    "malformed/negative_indices.obj": (12, (-1, -1, -1), (1, 1, 1)),
    "malformed/notenoughindices.obj": FACES.format('"f 1// 2//" in line 9'),
    "malformed/number_formats.obj": (1, (-1, -2, -3), (1, 2, 3)),
    "malformed/obj_with_no_face_in_chunk.obj": (1, (1, 2, 3), (4, 5, 6)),
    "malformed/points_emptyface.ply": NO_TRIANGLE,
    "malformed/polygonfaces.obj": (3, (-500, 0, -500), (500, 500, 500)),
    "malformed/singlevn.obj": (2, (-500, 0, -500), (500, 0, 500)),
    "malformed/whitespace.off": (12, (-1.632993, -1.632993, -1.154701), (1.632993, 1.632993, 1.154701)),
    "gltf/AlphaBlendModeTest.glb": (61, (-4.3, -0.100000024, -0.75), (4.3, 2.2995334, 0.55)),
    "gltf/nested.glb": (36, (-1.1670133, -2.3365953, -0.2693815), (0.26938146, 0.99999994, 0.2693815)),
    "gltf/no_indices_3storybuilding.glb": (72, (-23.207142, -1.4069059e-14, 0), (32.873, 9, 63.36141)),
    "gltf/rgb_cube_with_primitives.gltf": (12, (-1, -1, -1), (1, 1, 1)),
}


@pytest.mark.parametrize("name, expected", ASSETS.items())
def test_asset(asset, name, expected):
    path = asset(name)
    if isinstance(expected, str):
        assert message(path) == expected
    else:
        loaded = load_mesh(path)
        bounds = loaded.positions.min(axis=0), loaded.positions.max(axis=0)
        assert len(loaded.triangles) == expected[0]
        assert np.array_equal(bounds, np.array(expected[1:], np.float32))


def test_every_asset_is_in_the_table(asset):
    folder = asset("malformed/empty.obj").parents[1]
    suffixes = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}
    found = {path for name in ("malformed", "gltf") for path in (folder / name).rglob("*") if path.suffix in suffixes}
    assert {path.relative_to(folder).as_posix() for path in found} == set(ASSETS)


def message(path):
    """What load_mesh says of a file, without its name."""
    with pytest.raises(MeshError) as error:
        load_mesh(path)
    assert str(error.value).startswith(f"{path}: ") and "\n" not in str(error.value)
    return str(error.value).removeprefix(f"{path}: ")


def test_mesh_that_is_a_pipe(tmp_path):
    os.mkfifo(tmp_path / "a.obj")
    assert message(tmp_path / "a.obj") == "expected a readable file, got a folder or a device; check the path"


@pytest.fixture
def folder(tmp_path):
    """A folder with a secret beside it."""
    (tmp_path / "inside").mkdir()
    (tmp_path / "secret.bin").write_bytes(CORNERS)
    return tmp_path / "inside"


@pytest.mark.parametrize("library", ["mtllib ../a.mtl", "mtllib a.mtl"])
def test_materials_outside_the_folder(folder, library):
    """A material library elsewhere, or one here whose picture is elsewhere."""
    for path in (folder / "a.mtl", folder.parent / "a.mtl"):
        path.write_text("newmtl m\nmap_Kd ../secret.bin\n")
    (folder / "a.obj").write_text(f"{library}\nusemtl m\n{TRIANGLE}")
    named = "../a.mtl" if "../" in library else "../secret.bin"
    assert message(folder / "a.obj") == (
        f'expected references to files in its own folder, got "{named}"; copy the file there'
    )


@pytest.mark.parametrize("magic, name", untrusted.COMPRESSED.items())
def test_compressed_file(tmp_path, magic, name):
    path = tmp_path / "a.stl"
    path.write_bytes(magic + bytes(100))
    assert message(path) == f"expected an uncompressed file, got {name}; unpack it"


def ply(vertices, faces, form="ascii"):
    header = (
        f"ply\nformat {form} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
    )
    return (header + f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n").encode()


ROWS = b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
COUNT = "expected element counts from 0 to 16777216, got {}; simplify the mesh"
DECLARED = "expected the {} elements it declares, got {}; export the mesh again"
DECLARATIONS = [
    ("a.ply", ply(3, 2) + ROWS, DECLARED.format(5, "4 lines")),
    ("a.ply", ply(3, 40, "binary_little_endian") + CORNERS, DECLARED.format(43, "36 bytes")),
    ("a.ply", ply(10**10, 1) + ROWS, COUNT.format('"10000000000"')),
    ("a.ply", ply(-3, 1) + ROWS, COUNT.format('"-3"')),
    ("a.ply", ply("9" * 5000, 1) + ROWS, COUNT.format('"' + "9" * 56 + "...")),
    ("a.off", b"OFF # of one\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", DECLARED.format(5, "4 lines")),
    ("a.off", b"OFF\n99999999 1 0\n0 0 0\n", COUNT.format('"99999999"')),
    ("a.off", b"OFF\n3 -1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", COUNT.format('"-1"')),
]


@pytest.mark.parametrize("name, content, expected", DECLARATIONS)
def test_more_declared_than_there_is(tmp_path, name, content, expected):
    (tmp_path / name).write_bytes(content)
    assert message(tmp_path / name) == expected


def test_declared_exactly(tmp_path):
    (tmp_path / "a.ply").write_bytes(ply(3, 1) + ROWS)
    (tmp_path / "a.off").write_bytes(b"# COFF\nOFF 3 1 0\n" + ROWS.rstrip())
    for name in ("a.ply", "a.off"):
        assert len(load_mesh(tmp_path / name).triangles) == 1


@pytest.mark.parametrize("name, content", [("a.obj", TRIANGLE), ("a.off", "OFF\n"), ("a.ply", ply(0, 0).decode())])
def test_text_has_a_lower_limit(tmp_path, monkeypatch, name, content):
    monkeypatch.setattr(untrusted, "TEXT_LIMIT", 3)
    (tmp_path / name).write_text(content)
    assert message(tmp_path / name) == (
        f"expected at most 3 bytes of text, got {len(content)}; convert it to a binary format"
    )


def test_all_is_wrong_with_a_scene_and_no_work_is_done(small, monkeypatch):
    """Typos, wrong types, nan, zero sizes, a camera at its target, near beyond far and too large buffers at once."""
    monkeypatch.setattr(mesh, "load_mesh", None)
    monkeypatch.setattr("sss_ref.scene.load.recent_mesh", None)
    small["camera"] = {"type": "look_at", "eye": [1, 2, 3], "target": [1, 2, 3], "near": 5, "far": 4, "width": 0}
    small["shadow_map"] = {"heigth": 1, "bias_abs": float("nan")}
    small["phong"] = {"ambient": True}
    with pytest.raises(SceneError) as error:
        load_scene(small)
    assert str(error.value).split("\n") == [
        "scene: camera.far: expected a distance beyond near = 5, got 4; make it larger or near smaller",
        "scene: camera.width: expected a whole number from 1 to 16384, got 0; choose another value",
        "scene: camera.target: expected a point other than where it is looked from, got [1, 2, 3]; move one of the two",
        "scene: shadow_map.bias_abs: expected a finite number, got NaN; nan and inf are not accepted",
        "scene: shadow_map.heigth: expected a known key, got this one; did you mean height?",
        "scene: phong.ambient: expected a number, got true; write it without quotes, such as 1.5",
    ]


@pytest.mark.parametrize("value, kind", [(10**5000, "int"), ({(1, 2): 3}, "dict")], ids=["int", "dict"])
def test_value_that_cannot_be_shown(small, value, kind):
    with pytest.raises(SceneError, match=f"^scene: mm_per_unit: expected .*, got a value of type {kind}; "):
        load_scene({**small, "mm_per_unit": value})


def test_override_with_an_endless_index(small):
    with pytest.raises(
        SceneError, match=r"^override: lights\.9+\.near: expected an index below 1, got 9{397}\.\.\.; correct it"
    ):
        load_scene(small, **{f"lights.{'9' * 5000}.near": 1})
