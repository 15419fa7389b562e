import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh import mesh_file as mesh
from sss_ref.scene import load_mesh

# A unit cube of quads whose UVs split every corner by face, as most exporters write it.
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
QUADS = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
for number, quad in enumerate(QUADS):
    CUBE += "".join(f"vt .{number}{x} .{y}\n" for x, y in ((0, 0), (5, 0), (5, 5), (0, 5)))
    CUBE += "f " + " ".join(f"{v}/{4 * number + t}" for t, v in enumerate(quad, 1)) + "\n"

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def written(folder, name, content):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def ply(properties, rows, face_properties="", faces=("3 0 1 2",)):
    header = ["ply", "format ascii 1.0", f"element vertex {len(rows)}", *(f"property float {p}" for p in properties)]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    return "\n".join([*header, *filter(None, [face_properties]), "end_header", *rows, *faces]) + "\n"


def test_cube_with_split_uvs(tmp_path):
    cube = load_mesh(written(tmp_path, "cube.obj", CUBE))
    assert (cube.positions.shape, cube.triangles.shape, cube.uvs.shape) == ((24, 3), (12, 3), (24, 2))
    assert (cube.normals_source, cube.notes, cube.name) == ("computed", (), "cube.obj")
    assert (cube.positions.dtype, cube.triangles.dtype, cube.uvs.dtype) == (np.float32, np.int32, np.float32)
    # A corner's normal is the sum over all triangles at its position, whatever the UVs: each axis counts 1 or 2.
    for position, normal in zip(cube.positions, cube.normals, strict=True):
        around = cube.positions[cube.triangles[(cube.positions[cube.triangles] == position).all(axis=2).any(axis=1)]]
        count = [(around == position)[..., axis].all(axis=1).sum() for axis in range(3)]
        assert sum(count) == len(around) and set(count) <= {1, 2}
        outward = np.array(count) * (position.astype(float) * 2 - 1)
        assert np.array_equal(normal, (outward / np.sqrt(outward @ outward)).astype(np.float32))


def test_obj_keeps_its_normals_and_rounds_positions_once(tmp_path):
    text = "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nf 1//1 2//1 3//1\n"
    loaded = load_mesh(written(tmp_path, "a.obj", text))
    assert loaded.normals_source == "file" and loaded.uvs is None
    assert np.array_equal(loaded.normals, [[0, 0, 2]] * 3)
    assert loaded.positions[0, 0] == np.float32(0.1)


def test_ply_normals_stay_with_their_vertices(tmp_path):
    """A vertex that no triangle uses would make trimesh renumber the vertices by their UVs, and drop the normals."""
    rows = ["9 9 9 0 0 1 0 0", "0 0 0 0 0 1 .9 .9", "1 0 0 0 1 0 .5 .5", "0 1 0 1 0 0 .1 .1"]
    text = ply(["x", "y", "z", "nx", "ny", "nz", "s", "t"], rows, faces=["3 1 2 3"])
    loaded = load_mesh(written(tmp_path, "a.ply", text))
    assert loaded.normals_source == "file"
    assert np.array_equal(loaded.normals[loaded.triangles[0]], [[0, 0, 1], [0, 1, 0], [1, 0, 0]])
    assert np.array_equal(loaded.uvs[loaded.triangles[0], 0], np.array([0.9, 0.5, 0.1], np.float32))


def test_ply_with_uvs_per_triangle_keeps_its_normals(tmp_path):
    """One vertex that no triangle uses, which is left out, and two that are split where UVs differ."""
    rows = ["9 9 9 0 0 1", "0 0 0 1 0 0", "1 0 0 0 1 0", "0 1 0 0 0 1", "1 1 0 1 1 0"]
    text = ply(
        ["x", "y", "z", "nx", "ny", "nz"],
        rows,
        "property list uchar float texcoord",
        ["3 1 2 3 6 .9 .9 .5 .5 .1 .1", "3 2 4 3 6 .5 .5 .3 .3 .4 .4"],
    )
    loaded = load_mesh(written(tmp_path, "a.ply", text))
    assert loaded.normals_source == "file" and loaded.notes == ()
    assert np.array_equal(loaded.positions[loaded.triangles[1]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]])
    assert np.array_equal(loaded.normals[loaded.triangles[1]], [[0, 1, 0], [1, 1, 0], [0, 0, 1]])
    assert np.array_equal(loaded.uvs[loaded.triangles[0], 0], np.array([0.9, 0.5, 0.1], np.float32))
    assert np.array_equal(loaded.uvs[loaded.triangles[1], 0], np.array([0.5, 0.3, 0.4], np.float32))
    assert len(loaded.positions) == 6  # each number of a UV is its own, equal or not


def test_uvs_or_normals_that_are_not_there_are_noted(tmp_path):
    uvs = load_mesh(written(tmp_path, "a.obj", TRIANGLE + "vt 0 0\nf 1/1 2/9 3/1\n"))
    normals = load_mesh(written(tmp_path, "b.obj", TRIANGLE + "vn 0 0 1\nf 1//1 2//9 3//1\n"))
    assert uvs.notes == ("UVs not used: the file does not give them for every corner",)
    assert normals.notes == ("normals computed: the file does not give them for every corner",)


def test_hashes_tell_arrays_apart(tmp_path):
    cube = load_mesh(written(tmp_path, "cube.obj", CUBE))
    again = load_mesh(written(tmp_path, "other.obj", CUBE))
    moved = load_mesh(written(tmp_path, "moved.obj", CUBE.replace("v 1 1 1", "v 1 1 2")))
    assert list(cube.hashes()) == ["positions", "normals", "uvs", "triangles", "material"]
    assert cube.hashes() == again.hashes()
    assert cube.hashes()["positions"] != moved.hashes()["positions"]
    assert cube.hashes()["triangles"] == moved.hashes()["triangles"]


EXPORT = "export the mesh again"
NO_TRIANGLE = "expected at least one triangle, got none; export the mesh as triangles or polygons"
BROKEN = {
    ("a.txt", "x"): "expected one of .obj, .ply, .stl, .off, .glb, .gltf, got .txt; convert the mesh",
    ("a.obj", TRIANGLE): NO_TRIANGLE,
    ("b.obj", ""): NO_TRIANGLE,
    ("a.stl", b"\0\1garbage"): NO_TRIANGLE,
    (
        "a.ply",
        "garbage",
    ): f"expected a valid ply file, got one that does not begin with the line ply; {EXPORT}",
    (
        "c.obj",
        TRIANGLE + "f 1 2 9\n",
    ): 'expected faces of the vertices 1 to 3 that the file has, got "f 1 2 9" in line 4; ' + EXPORT,
    ("d.obj", TRIANGLE + "f 1 2 3\nf 0 1 2\n"): "expected faces of at least three vertices, numbered from 1, "
    f'got "f 0 1 2" in line 5; {EXPORT}',
    ("e.obj", TRIANGLE + "f 1 2 3\nf 1// 2//\n"): "expected faces of at least three vertices, numbered from 1, "
    f'got "f 1// 2//" in line 5; {EXPORT}',
    ("f.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n"): f'expected positions of 3 numbers, got "v 0 0" in line 1; {EXPORT}',
    ("g.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 1e39\nf 1 2 3\n"): "expected positions that are finite in float32, "
    "got [1.0, 0.0, nan] at vertex 1 (2 in all); correct them",
    ("h.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"): "expected a mesh of some size, "
    "got all vertices at one point; correct them",
    ("i.obj", TRIANGLE + "vt 0 0\nvt 0 inf\nf 1/1 2/2 3/1\n"): "expected UVs that are finite in float32, "
    "got [0.0, inf] at vertex 1 (1 in all); correct them",
}


@pytest.mark.parametrize("file, message", BROKEN.items(), ids=[name for name, _ in BROKEN])
def test_broken_file(tmp_path, file, message):
    path = written(tmp_path, *file)
    with pytest.raises(MeshError) as error:
        load_mesh(path)
    assert str(error.value) == f"{path}: {message}"


def test_missing_file(tmp_path):
    with pytest.raises(MeshError) as error:
        load_mesh(tmp_path / "a.obj")
    assert str(error.value) == (
        f"{tmp_path / 'a.obj'}: expected a readable file, got No such file or directory; check the path"
    )


def test_file_beyond_the_limit(tmp_path, monkeypatch):
    monkeypatch.setattr(mesh, "BYTE_LIMIT", 10)
    path = written(tmp_path, "a.obj", CUBE)
    with pytest.raises(MeshError) as error:
        load_mesh(path)
    assert str(error.value) == f"{path}: expected at most 10 bytes, got {path.stat().st_size}; simplify the mesh"


@pytest.mark.parametrize(
    "path, vertices, triangles, source, low, high",
    [
        ("head_lps/leeperrysmith.obj", 9223, 17672, "file", (-4.281, -3.977, -2.593), (4.281, 3.977, 2.593)),
        ("head_lps/leeperrysmith_283k.glb", 142918, 282752, "file", (-4.281, -3.977, -2.593), (4.281, 3.977, 2.593)),
        ("spot/spot_triangulated.obj", 3225, 5856, "computed", (-0.472, -0.737, -0.669), (0.472, 0.954, 1.049)),
        ("spot/cow.glb", 3225, 5856, "computed", (-0.472, -0.737, -0.669), (0.472, 0.954, 1.049)),
        ("bunny/bunny_hr.obj", 29834, 59664, "computed", (-0.77, -0.768, -0.597), (0.78, 0.77, 0.601)),
    ],
)
def test_asset(asset, path, vertices, triangles, source, low, high):
    loaded = load_mesh(asset(path))
    assert (len(loaded.positions), len(loaded.triangles), loaded.normals_source) == (vertices, triangles, source)
    assert np.array_equal(loaded.positions.min(axis=0).round(3), np.array(low, np.float32))
    assert np.array_equal(loaded.positions.max(axis=0).round(3), np.array(high, np.float32))
    assert loaded.notes == () and loaded.normals.any(axis=1).all()


MALFORMED = {
    "BoxBadNormals.glb": 12,
    "box_without_lineending.obj": 12,
    "concave_polygon.obj": 64,
    "cube_compressed.obj": 12,
    "cubevt.obj": 12,
    "joined_tetrahedra.obj": 8,
    "mirror.ply": 286,
    "nancolor.obj": 12,
    "negative_indices.obj": 12,
    "number_formats.obj": 1,
    "obj_with_no_face_in_chunk.obj": 1,
    "polygonfaces.obj": 3,
    "singlevn.obj": 2,
    "whitespace.off": 12,
    "empty.obj": None,
    "empty.ply": None,
    "empty_nodes.glb": None,
    "face_in_group_name.obj": None,
    "issue623.ply": None,
    "points_emptyface.ply": None,
    "malformed.obj": None,
    "notenoughindices.obj": None,
    "IndexOutOfRange/IndexOutOfRange.gltf": None,
}


@pytest.mark.parametrize("name, triangles", MALFORMED.items())
def test_malformed_asset(asset, name, triangles):
    path = asset(f"malformed/{name}")
    if triangles is None:
        with pytest.raises(MeshError, match=r": expected .*, got .*; "):
            load_mesh(path)
    else:
        assert len(load_mesh(path).triangles) == triangles
