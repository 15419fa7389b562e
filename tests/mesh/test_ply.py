"""PLY in its three forms. Right values: Turk's description of the format; Blender, assimp and MeshLab agree."""

import struct
import tracemalloc

import numpy as np
import pytest
from mesh_texts import FACES, POINTS, TETRAHEDRON, centres, corners, loaded, measured, refusal

from sss_ref.mesh.ply_rows import Rows

AGAIN = "; export the mesh again"
NO_TRIANGLE = "expected at least one triangle, got none; export the mesh as triangles or polygons"
FORMS = ["ascii", "binary_little_endian", "binary_big_endian"]
CODES = {
    **{"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"},
    **{"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I"},
    **{"float32": "f", "float64": "d"},
}
XYZ = ["float x", "float y", "float z"]
LIST = ["list uchar int vertex_indices"]


def ply(*elements, form="ascii", end="\n", comments=()):
    """A file of elements (name, properties, rows); a row has a number or a list for each property."""
    lines = ["ply", f"format {form} 1.0", *comments]
    for name, properties, rows in elements:
        lines += [f"element {name} {len(rows)}", *(f"property {each}" for each in properties)]
    header = end.join([*lines, "end_header", ""]).encode()
    body = b""
    for _, properties, rows in elements:
        for row in rows:
            body += _row(properties, row, form, end.encode())
    return header + body


def _row(properties, row, form, end):
    if form == "ascii":
        flat = [n for value in row for n in ((len(value), *value) if isinstance(value, (tuple, list)) else (value,))]
        return " ".join(map(str, flat)).encode() + end
    order, packed = "<" if "little" in form else ">", b""
    for each, value in zip(properties, row, strict=True):
        words = each.split()
        if words[0] == "list":
            packed += struct.pack(order + CODES[words[1]], len(value))
            packed += struct.pack(f"{order}{len(value)}{CODES[words[2]]}", *value)
        else:
            packed += struct.pack(order + CODES[words[0]], value)
    return packed


VERTEX = ("vertex", XYZ, POINTS)
FACE = ("face", LIST, [(face,) for face in FACES])
CAMERA = ("camera", ["float a", "list uchar short b", "uchar c"], [(1.0, (1, 2, 3), 4), (2.0, (), 5)])
STRIPS = ["list int int vertex_indices"]

SAME = {
    "plain": [VERTEX, FACE],
    "faces first": [FACE, VERTEX],
    "other elements": [CAMERA, VERTEX, CAMERA, FACE, ("edge", ["int a", "int b"], [(0, 1)])],
    "properties in another order": [
        (
            "vertex",
            ["uchar red", "double z", "float32 x", "short q", "float64 y"],
            [(9, z, x, -1, y) for x, y, z in POINTS],
        ),
        ("face", ["uchar red", *LIST, "float quality"], [(1, face, 0.5) for face in FACES]),
    ],
    "another name": [VERTEX, ("face", ["list uint8 uint32 vertex_index"], FACE[2])],
    "counts of four bytes": [VERTEX, ("face", ["list uint uint vertex_indices"], FACE[2])],
    "small indices": [VERTEX, ("face", ["list short char vertex_indices"], FACE[2])],
    "whole positions": [("vertex", ["char x", "ushort y", "int z"], POINTS), FACE],
    "lists at vertices": [
        ("vertex", [*XYZ, "list uchar float w"], [(*point, (0.5,) * k) for k, point in enumerate(POINTS)]),
        FACE,
    ],
    "one strip": [VERTEX, ("tristrips", STRIPS, [((0, 2, 1, 3, 0, 2),)])],
    "strips that start again": [VERTEX, ("tristrips", STRIPS, [((0, 2, 1, -1, 0, 1, 3, 2, -1, 0, 3, 2),)])],
    "a strip each": [VERTEX, ("tristrips", STRIPS, [(face,) for face in FACES])],
    "strips of no triangle between": [
        VERTEX,
        ("tristrips", STRIPS, [(FACES[0],), ((3,),), ((),), (FACES[1],), ((1, 0),), (FACES[2],), (FACES[3],)]),
    ],
    "a strip behind faces": [VERTEX, ("face", LIST, FACE[2][:2]), ("tristrips", STRIPS, [((0, 3, 2, 1),)])],
}

NOT_USED = {
    "properties in another order": ("of each vertex not used: red, q", "of each face not used: red, quality"),
    "lists at vertices": ("of each vertex not used: w",),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", SAME)
def test_the_same_tetrahedron(tmp_path, name, form):
    mesh = loaded(tmp_path, "a.ply", ply(*SAME[name], form=form))
    assert mesh.notes == NOT_USED.get(name, ())
    assert measured(mesh) == TETRAHEDRON and len(mesh.positions) == 4
    assert sorted(centres(mesh)) == [0, 1, 1, 1]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_line_ends_and_comments(tmp_path, form, end):
    comments = ("comment made by end_header K\u00f6pfe", "obj_info 1", "comment", "")
    mesh = loaded(tmp_path, "a.ply", ply(VERTEX, FACE, form=form, end=end, comments=comments))
    assert measured(mesh) == TETRAHEDRON and centres(mesh) == [1, 1, 0, 1]


@pytest.mark.parametrize("form", FORMS)
def test_rows_alike_are_not_read_one_by_one(tmp_path, form, monkeypatch):
    """The loop over rows is for lists of unlike lengths."""
    monkeypatch.delattr(Rows, "_row_by_row")
    assert measured(loaded(tmp_path, "a.ply", ply(VERTEX, FACE, form=form))) == TETRAHEDRON


def test_latin_1_in_a_comment(tmp_path):
    content = ply(VERTEX, FACE).replace(b"1.0\n", b"1.0\ncomment K\xf6pfe\n", 1)
    assert measured(loaded(tmp_path, "a.ply", content)) == TETRAHEDRON


PYRAMID = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)]
SIDES = [((0, 3, 2, 1),), ((0, 1, 4),), ((1, 2, 4),), ((2, 3, 4),), ((3, 0, 4),)]


@pytest.mark.parametrize("form", FORMS)
def test_quads_and_triangles(tmp_path, form):
    """A pyramid, 1 + 4 * sqrt(5)/4 of area and 1/3 of volume, as Blender writes it."""
    mesh = loaded(tmp_path, "a.ply", ply(("vertex", XYZ, PYRAMID), ("face", LIST, SIDES), form=form))
    assert measured(mesh) == {"triangles": 6, "area": 3.23607, "volume": 0.33333}


@pytest.mark.parametrize("form", FORMS)
def test_mixed_polygons_of_a_mean_size(tmp_path, form):
    """A quad, a triangle and a pentagon, four corners each in the mean, in the file's order."""
    points = [
        (x, y, 0)
        for x, y in [(0, 0), (1, 0), (1, 1), (0, 1), (3, 0), (4, 0), (3, 1), (6, 0), (8, 0), (8, 2), (7, 1), (6, 2)]
    ]
    faces = [((0, 1, 2, 3),), ((4, 5, 6),), ((7, 8, 9, 10, 11),)]
    mesh = loaded(tmp_path, "a.ply", ply(("vertex", XYZ, points), ("face", LIST, faces), form=form))
    assert measured(mesh) == {"triangles": 6, "area": 4.5, "volume": 0}
    assert [value > 5 * 3 for value in centres(mesh)] == [False, False, False, True, True, True]


@pytest.mark.parametrize("form", FORMS)
def test_strips_turn_every_second_triangle(tmp_path, form):
    points = [(k // 2, k % 2, 0) for k in range(6)]
    strips = [((1, 0, 3, 2, 5, 4),)]
    mesh = loaded(tmp_path, "a.ply", ply(("vertex", XYZ, points), ("tristrips", STRIPS, strips), form=form))
    a, b, c = np.moveaxis(corners(mesh), 1, 0)
    assert np.cross(b - a, c - a)[:, 2].tolist() == [1, 1, 1, 1]
    assert centres(mesh) == [1, 2, 4, 5]


@pytest.mark.parametrize("names", ["s t", "u v", "texture_u texture_v", "texcoord_u texcoord_v", "tu tv"])
@pytest.mark.parametrize("form", FORMS)
def test_uvs_and_normals_of_vertices(tmp_path, form, names):
    properties = ["float nx", "float ny", "float nz", *(f"float {name}" for name in names.split()), *XYZ]
    rows = [(0, 0, k + 1, 0.25 * k, 0.125, *point) for k, point in enumerate(POINTS)]
    mesh = loaded(tmp_path, "a.ply", ply(("vertex", properties, rows), FACE, form=form))
    assert measured(mesh) == TETRAHEDRON and mesh.normals_source == "file" and mesh.notes == ()
    assert mesh.uvs.tolist() == [[0, 0.125], [0.25, 0.125], [0.5, 0.125], [0.75, 0.125]]
    assert mesh.normals.tolist() == [[0, 0, k] for k in (1, 2, 3, 4)]


@pytest.mark.parametrize("form", FORMS)
def test_uvs_of_faces(tmp_path, form):
    """Of a quad and triangles, under other UVs of the vertices; the number of the texture is passed over."""
    vertices = ("vertex", [*XYZ, "float s", "float t"], [(*point, 0.9, 0.9) for point in PYRAMID])
    uvs = [[0.125 * k + 0.0625 * n for k in range(2 * len(side[0]))] for n, side in enumerate(SIDES)]
    properties = [*LIST, "list uchar float texcoord", "int texnumber"]
    faces = ("face", properties, [(*side, uv, 7) for side, uv in zip(SIDES, uvs, strict=True)])
    mesh = loaded(tmp_path, "a.ply", ply(vertices, faces, form=form))
    assert measured(mesh)["triangles"] == 6 and mesh.notes == ("of each face not used: texnumber",)
    found = mesh.uvs[mesh.triangles]
    quad = np.array(uvs[0]).reshape(4, 2)
    assert found[:2].tolist() == [quad[[0, 1, 2]].tolist(), quad[[2, 3, 0]].tolist()]
    assert found[2:].reshape(4, 6).tolist() == uvs[1:]


@pytest.mark.parametrize("form", FORMS)
def test_uvs_that_some_face_lacks(tmp_path, form):
    properties = [*LIST, "list uchar float texcoord"]
    faces = [(face, (0.1,) * (6 * (number != 2))) for number, face in enumerate(FACES)]
    mesh = loaded(tmp_path, "a.ply", ply(VERTEX, ("face", properties, faces), form=form))
    assert measured(mesh) == TETRAHEDRON and mesh.uvs is None
    assert mesh.notes == ("UVs not used: the file does not give them for every corner",)


def test_uvs_of_faces_beside_strips(tmp_path):
    faces = ("face", [*LIST, "list uchar float texcoord"], [((0, 2, 1), (0.5,) * 6), ((0, 1, 3), (0.5,) * 6)])
    mesh = loaded(tmp_path, "a.ply", ply(VERTEX, faces, ("tristrips", STRIPS, [((0, 3, 2, 1),)])))
    assert measured(mesh) == TETRAHEDRON and mesh.uvs is None and len(mesh.notes) == 1


@pytest.mark.parametrize("form", FORMS)
def test_faces_of_fewer_than_three_corners(tmp_path, form):
    faces = [((),), *FACE[2], ((0,),), ((1, 2),)]
    mesh = loaded(tmp_path, "a.ply", ply(VERTEX, ("face", LIST, faces), form=form))
    assert measured(mesh) == TETRAHEDRON and mesh.notes == ("3 faces of fewer than three corners were passed over",)


@pytest.mark.parametrize("form", FORMS)
def test_indices_out_of_range(tmp_path, form):
    for index in (4, -1):
        content = ply(VERTEX, ("face", LIST, [*FACE[2], ((0, 1, index),)]), form=form)
        assert refusal(tmp_path, "a.ply", content) == (
            f"expected vertex indices from 0 to 3, got [0, 1, {index}] in face 4 (1 corners in all)" + AGAIN
        )


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("elements", [[VERTEX, FACE], [("vertex", XYZ, PYRAMID), ("face", LIST, SIDES)]])
def test_cut_short_anywhere(tmp_path, form, elements):
    content = ply(*elements, form=form)
    header = content.index(b"end_header") + 11
    declared = sum(len(rows) for _, _, rows in elements)
    for size in range(header, len(content) - 2, 7):
        assert refusal(tmp_path, "a.ply", content[:size]).startswith(
            f"expected the {declared} elements it declares, got "
        )


@pytest.mark.parametrize("count", ["-1", "2.5", "nan", "1e300", "1000"])
@pytest.mark.parametrize("row", [b"3 0 2 1\n", b"3 1 2 3\n"])
def test_a_list_whose_length_is_none(tmp_path, count, row):
    content = ply(VERTEX, FACE).replace(row, row.replace(b"3", count.encode(), 1))
    assert refusal(tmp_path, "a.ply", content) == "expected the 8 elements it declares, got 28 numbers" + AGAIN


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_list_of_less_than_no_numbers(tmp_path, order):
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    content = ply(VERTEX, ("face", ["list char int vertex_indices"], FACE[2]), form=form)
    at = len(content) - 4 * 13
    assert content[at] == 3
    wrong = content[:at] + b"\xff" + content[at + 1 :]
    assert refusal(tmp_path, "a.ply", wrong) == "expected the 8 elements it declares, got 100 bytes" + AGAIN


@pytest.mark.parametrize("form", FORMS)
def test_what_is_behind_the_last_element_is_noted(tmp_path, form):
    behind = b"1 2\n3\n" if form == "ascii" else b"12345"
    mesh = loaded(tmp_path, "a.ply", ply(VERTEX, FACE, form=form) + behind)
    what = "3 numbers" if form == "ascii" else "5 bytes"
    assert measured(mesh) == TETRAHEDRON and mesh.notes == (f"{what} behind the last element are not used",)


REFUSED = {
    "another format": (b"solid", "expected a valid ply file, got one that does not begin with the line ply" + AGAIN),
    "a longer word": (b"plyx\n", "expected a valid ply file, got one that does not begin with the line ply" + AGAIN),
    "no end of the header": (
        ply(VERTEX, FACE).partition(b"end_header")[0],
        "expected a ply header that ends with end_header, got none" + AGAIN,
    ),
    "an endless header": (
        ply(VERTEX, FACE, comments=["comment " + "x" * 2**20]),
        "expected a ply header that ends with end_header, got none" + AGAIN,
    ),
    "no format": (
        ply(VERTEX, FACE).replace(b"format ascii 1.0\n", b""),
        'expected a ply header: format, element and property lines, got "end_header" in line 8' + AGAIN,
    ),
    "another form": (
        ply(VERTEX, FACE).replace(b"ascii", b"binary"),
        'expected a ply header: format, element and property lines, got "format binary 1.0" in line 2' + AGAIN,
    ),
    "a type that is none": (
        ply(VERTEX, FACE).replace(b"float y", b"half y"),
        'expected a ply header: format, element and property lines, got "property half y" in line 5' + AGAIN,
    ),
    "a list counted in fractions": (
        ply(VERTEX, FACE).replace(b"list uchar", b"list float"),
        'expected a ply header: format, element and property lines, got "property list float int vertex_indices" in '
        "line 8" + AGAIN,
    ),
    "no positions": (
        ply(VERTEX, FACE).replace(b"float x", b"float a"),
        "expected vertices with the properties x, y and z, got others" + AGAIN,
    ),
    "corners of another name": (
        ply(VERTEX, FACE).replace(b"vertex_indices", b"corners"),
        "expected faces with a list vertex_indices, got others" + AGAIN,
    ),
    "no whole numbers": (
        ply(VERTEX, FACE).replace(b"3 0 2 1", b"3 0 2 x"),
        "expected whole numbers below 2^53 in vertex_indices, got others" + AGAIN,
    ),
    "an infinite corner": (
        ply(VERTEX, FACE).replace(b"3 0 2 1", b"3 0 2 inf"),
        "expected whole numbers below 2^53 in vertex_indices, got others" + AGAIN,
    ),
    "an element twice": (
        ply(VERTEX, FACE, FACE),
        "expected each element once, got face 2 times" + AGAIN,
    ),
    "points alone": (ply(VERTEX), NO_TRIANGLE),
    "no faces": (ply(VERTEX, ("face", LIST, [])), NO_TRIANGLE),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(tmp_path, name):
    content, expected = REFUSED[name]
    assert refusal(tmp_path, "a.ply", content) == expected


def test_memory_is_held_to_the_bytes_there_are(tmp_path):
    """A million rows of lists that are all used, for which there is a byte each: refused before memory is taken."""
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 1048576\n"
    header += "".join(
        f"property list uchar uchar {name}\n"
        for name in ["x", "y", "z", "nx", "ny", "nz", "s", "t", "u", "v", "tu", "tv"]
    )
    header += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    tracemalloc.start()
    assert refusal(tmp_path, "a.ply", header.encode() + bytes(range(128)) * 8193) == (
        "expected the 1048577 elements it declares, got 1048704 bytes" + AGAIN
    )
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 16 * 2**20
