"""OBJ as its specification and other programs read it. Right values: the manual, Blender, assimp and MeshLab agree."""

import numpy as np
import pytest
from mesh_texts import TETRAHEDRON, centres, corners, loaded, measured, refusal

from sss_ref.mesh.materials import Material

V = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
F = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
AGAIN = "; export the mesh again"

# One tetrahedron, written in many ways.
SAME = {
    "tabs": (V + F).replace(" ", "\t"),
    "leading blanks": "".join(f" \t{line}\n" for line in (V + F).splitlines()),
    "runs of blanks": (V + F).replace(" ", "  \t ").replace("\n", "  \n"),
    "comments behind": "".join(f"{line} # {k} 9\n" for k, line in enumerate((V + F).splitlines())),
    "comments without a blank": (V + F).replace("\n", "#9 9 9\n"),
    "carriage returns": (V + F).replace("\n", "\r"),
    "carriage returns and line feeds": (V + F).replace("\n", "\r\n"),
    "a byte-order mark": b"\xef\xbb\xbf" + (V + F).encode(),
    "continued": (V + F).replace("f 1 3 2", "f 1 \\\n3 \\\n 2"),
    "continued after \\r\\n": (V + F).replace("v 0 0 1", "v 0 \\\n0 1").replace("\n", "\r\n"),
    "continued after \\r": (V + F).replace("v 0 0 1", "v 0 \\\n0 1").replace("\n", "\r"),
    "continued after a blank": (V + F).replace("f 1 3 2", "f 1 \\ \t\n3 2"),
    "a comment that ends in a backslash": "# C:\\meshes\\\n" + V + F,
    "no last line end": V + F.rstrip(),
    "relative": V + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
    "vertices behind faces": F + V,
    "names of groups": V + "o a b\ng f 1 2 3\ns 1\n" + F.replace("\nf 2", "\ng v\ns off\nf 2"),
    "Latin-1 in a name": "o Kopf\u00e4\n".encode("latin-1") + (V + F).encode(),
    "Latin-1 in a comment": "# Kopf\u00e4\n".encode("latin-1") + (V + F).encode(),
    "UTF-8 in a name": "g K\u00f6pfe \u9aa8\nusemtl \u9aa8\n" + V + F,
    "control bytes": b"g \x00\x01\xff\xfe\n" + (V + F).encode(),
    "forms of numbers": V.replace("v 1 0", "v +1.e0 .0").replace("v 0 1 0", "v 0 10e-1 -0.").replace(" 0\n", " 0E5\n")
    + F,
    "colours": V.replace("\n", " .5 .25 nan\n") + F,
    "five numbers": V.replace("\n", " 1 .5\n") + F,
    "seven numbers": V.replace("\n", " 1 .5 .25 1\n") + F,
    "weights of 1": V.replace("\n", " 1.0\n") + F,
    "empty UVs": V + F.replace(" ", "/ ").replace("f/", "f").replace("\n", "/\n"),
    "empty UVs and normals": V + F.replace(" ", "// ").replace("f//", "f").replace("\n", "//\n"),
    "outlines of old": V + F.replace("f ", "fo "),
    "capitals": (V + F).upper(),
}


@pytest.mark.parametrize("name", SAME)
def test_the_same_tetrahedron(tmp_path, name):
    mesh = loaded(tmp_path, "a.obj", SAME[name])
    assert mesh.notes == (("the colours of 4 vertices are not used",) if name in ("colours", "seven numbers") else ())
    assert measured(mesh) == TETRAHEDRON and len(mesh.positions) == 4
    assert centres(mesh) == [1, 1, 0, 1]


def test_relative_references_count_from_the_last_so_far(tmp_path):
    """Of positions, UVs and normals each on its own: two blocks that refer to what was last given."""
    block = "v {0} 0 0\nv {1} 0 0\nv {0} 1 0\nvt 0 {0}\nvt 1 {0}\nvn 0 {1} 1\nf -3/-2/-1 -2/-1/-1 -1/-2/-1\n"
    mesh = loaded(
        tmp_path, "a.obj", block.format(5, 6) + "vn 9 9 9\nvt 9 9\n" + block.format(0, 1) + "vt 8 8\nv 3 3 3\n"
    )
    assert corners(mesh)[:, :, 0].tolist() == [[5, 6, 5], [0, 1, 0]]
    assert mesh.uvs[mesh.triangles].tolist() == [[[0, 5], [1, 5], [0, 5]], [[0, 0], [1, 0], [0, 0]]] or mesh.shifted
    assert mesh.normals[mesh.triangles][:, 0].tolist() == [[0, 6, 1], [0, 1, 1]]


@pytest.mark.parametrize(
    "corner, uvs, normals",
    [("{0}", False, False), ("{0}/{0}", True, False), ("{0}//{0}", False, True), ("{0}/{0}/{0}", True, True)],
)
def test_what_corners_refer_to(tmp_path, corner, uvs, normals):
    face = "f " + " ".join(corner.format(k) for k in (1, 2, 3)) + "\n"
    values = ("vt .1 .2\nvt .3 .2 0\nvt .5\n" if uvs else "") + ("vn 0 0 2\nvn 0 1 0\nvn 1 0 0\n" if normals else "")
    mesh = loaded(tmp_path, "a.obj", V + values + face)
    assert mesh.notes == () and mesh.normals_source == ("file" if normals else "computed")
    assert (mesh.uvs is None) == (not uvs)
    if uvs:
        assert np.array_equal(mesh.uvs[mesh.triangles[0]], np.array([[0.1, 0.2], [0.3, 0.2], [0.5, 0]], np.float32))
    if normals:
        assert mesh.normals[mesh.triangles[0]].tolist() == [[0, 0, 2], [0, 1, 0], [1, 0, 0]]


MIXED = {
    "UVs of some faces": "vt 0 0\nf 1/1 2/1 3/1\nf 1 2 4\n",
    "UVs of some corners": "vt 0 0\nf 1/1 2/1 3\nf 1 2 4\n",
    "UVs that are not there": "f 1/1 2/2 3/3\n",
    "UVs numbered 0": "vt 0 0\nf 1/0 2/1 3/1\n",
    "UVs before the first": "vt 0 0\nf 1/-2 2/-1 3/-1\n",
}


@pytest.mark.parametrize("name", MIXED)
def test_uvs_that_some_corner_lacks_are_noted(tmp_path, name):
    mesh = loaded(tmp_path, "a.obj", V + MIXED[name])
    assert mesh.uvs is None and mesh.notes == ("UVs not used: the file does not give them for every corner",)


@pytest.mark.parametrize("lines", ["vn 0 0 1\nf 1 2 3\n", "f 1//1 2//1 3//1\n"])
def test_normals_that_no_corner_has_are_noted(tmp_path, lines):
    mesh = loaded(tmp_path, "a.obj", V + lines)
    assert mesh.normals_source == "computed"
    assert mesh.notes == ("normals computed: the file does not give them for every corner",)


def test_concave_polygons(tmp_path):
    """An L of area 3 whose first corner is a bad place for a fan, which would cover 4."""
    text = "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n"
    assert measured(loaded(tmp_path, "a.obj", text)) == {"triangles": 4, "area": 3, "volume": 0}


def test_triangles_and_materials_in_the_files_order(tmp_path):
    """Materials that are switched to and fro, a quad between triangles, groups: nothing moves a triangle."""
    points = "".join(f"v {x} 0 0\nv {x} 1 0\n" for x in range(8))
    faces = (
        "usemtl b\nf 1 3 2\nusemtl a\nf 3 5 6 4\ng x\nusemtl b\nf 7 9 8\nusemtl c d\nf 11 13 12\nusemtl a\nf 13 15 14\n"
    )
    mesh = loaded(tmp_path, "a.obj", points + faces)
    assert centres(mesh) == [1, 5, 4, 10, 16, 19]
    names = [mesh.materials[k].name for k in mesh.material]
    assert names == ["b", "a", "a", "b", "c d", "a"] and len(mesh.materials) == 3


def test_triangles_before_the_first_material(tmp_path):
    mesh = loaded(tmp_path, "a.obj", V + "f 1 3 2\nusemtl a\nf 1 2 4\n")
    assert mesh.materials == (Material(), Material("a")) and mesh.material.tolist() == [0, 1]


NOTED = {
    "points": ("p 1 2\np 3\n", "passed over, for only faces are drawn: points (2)"),
    "lines": ("l 1 2 3\n", "passed over, for only faces are drawn: lines (1)"),
    "surfaces": ("cstype bezier\nsurf 0 1 0 1 1 2 3\nend\n", "passed over, for only faces are drawn: surfaces (1)"),
    "other files": ("call b.obj\n", "passed over, for only faces are drawn: calls of other files (1)"),
    "an unknown statement": (
        "f\u00a01 2 3\n",
        'passed over, for OBJ has no such statement: "f\\u00a01 2 3" in line 9 (1 in all)',
    ),
    "unknown statements": (
        "vv 1\nf: 1 2 3\n",
        'passed over, for OBJ has no such statement: "vv 1" in line 9 (2 in all)',
    ),
    "colours": ("v 1 2 3 .1 .2 .3\n", "the colours of 1 vertices are not used"),
    "colours behind weights": ("v 1 2 3 1 .1 .2 .3\n", "the colours of 1 vertices are not used"),
    "weights": ("v 1 2 3 2\n", "the weights w of 1 vertices are not used: only free-form surfaces have any"),
}


@pytest.mark.parametrize("name", NOTED)
def test_what_is_not_drawn_is_noted(tmp_path, name):
    lines, note = NOTED[name]
    mesh = loaded(tmp_path, "a.obj", V + F + lines)
    assert measured(mesh) == TETRAHEDRON and mesh.notes == (note,)


def test_statements_of_the_manual_are_not_spoken_of(tmp_path):
    lines = "o a\ng b\ns 1\nS off\nmg 0\nusemap off\nlod 2\nvp 1 2\nbevel on\nc_interp off\nshadow_obj a\n"
    assert loaded(tmp_path, "a.obj", V + lines + F).notes == ()


FEW = "expected faces of at least three vertices, numbered from 1, got "
THERE = "expected faces of the vertices 1 to 4 that the file has, got "
REFUSED = {
    "0": ("f 1 0 2\n", FEW + '"f 1 0 2" in line 5'),
    "two corners": ("f 1 2 3\nf 1 2 # 3\n", FEW + '"f 1 2 # 3" in line 6'),
    "no corner": ("f\n", FEW + '"f " in line 5'),
    "0 between vertices": ("f 1 0 2\nv 1 1 1\n", FEW + '"f 1 0 2" in line 5'),
    "slashes alone": ("f 1 2 3\nf 1 2 3\nf 1/ 2// ///\n", FEW + '"f 1/ 2// ///" in line 7'),
    "no number": ("f 1 2 x\n", FEW + '"f 1 2 x" in line 5'),
    "no whole number": ("f 1 2 3.5\n", FEW + '"f 1 2 3.5" in line 5'),
    "a UV alone": ("f 1 2 3\nf 1 2 /3\n", FEW + '"f 1 2 /3" in line 6'),
    "four parts": ("f 1 2 3/1/1/1\n", FEW + '"f 1 2 3/1/1/1" in line 5'),
    "beyond the last": ("\n# five\nf 1 2 5\n", THERE + '"f 1 2 5" in line 7'),
    "far beyond": (f"f 1 2 {10**20}\n", THERE + f'"f 1 2 {10**20}" in line 5'),
    "before the first": (
        "f 1 2 -5\nv 0 0 0\n",
        'expected faces of the vertices 1 to 5 that the file has, got "f 1 2 -5" in line 5',
    ),
    "behind a continuation": ("g a \\\n b \\\n c\nf 1 2 9\n", THERE + '"f 1 2 9" in line 8'),
    "a vertex that is none": ("v 1,5 2 3\nf 1 2 5\n", 'expected positions of 3 numbers, got "v 1,5 2 3" in line 5'),
    "a vertex of two numbers": ("v 1 2\nf 1 2 -1\n", 'expected positions of 3 numbers, got "v 1 2" in line 5'),
    "NaN of another program": (
        "v 1.#QNAN 2 3\nf 1 2 5\n",
        'expected positions of 3 numbers, got "v 1.#QNAN 2 3" in line 5',
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_face(tmp_path, name):
    lines, expected = REFUSED[name]
    assert refusal(tmp_path, "a.obj", V + lines) == expected + AGAIN


def test_the_first_number_that_is_not_finite_is_told_before_words_that_are_none(tmp_path):
    """A weight or a colour behind it may be anything."""
    lines = "v 0 nan 1 red\nv x 0 0\nf 1 5 6\n"
    expected = "expected positions that are finite in float32, got [0.0, nan, 1.0] at vertex 4 (2 in all); correct them"
    assert refusal(tmp_path, "a.obj", V + lines) == expected


def test_a_uv_of_no_number(tmp_path):
    expected = "expected UVs that are finite in float32, got [nan, nan] at vertex 0 (1 in all); correct them"
    assert refusal(tmp_path, "a.obj", V + "vt\nf 1/1 2/1 3/1\n") == expected


def test_an_empty_first_line_is_a_line(tmp_path):
    assert refusal(tmp_path, "a.obj", f"\n{V}f 1 2 9\n") == THERE + '"f 1 2 9" in line 6' + AGAIN


def test_vertices_that_no_face_uses_may_be_anything(tmp_path):
    assert measured(loaded(tmp_path, "a.obj", V + "v x y z\nv 1e9 nan\n" + F)) == TETRAHEDRON


@pytest.mark.parametrize("code", ["utf-16", "utf-16-be"])
def test_two_bytes_a_letter(tmp_path, code):
    text = ("" if code == "utf-16" else "\ufeff") + V + F
    assert (
        refusal(tmp_path, "a.obj", text.encode(code)) == "expected text in UTF-8, got text in UTF-16; save it as UTF-8"
    )


def test_the_result_needs_no_package_that_guesses_encodings(tmp_path, monkeypatch):
    for package in ("charset_normalizer", "chardet"):
        monkeypatch.setitem(__import__("sys").modules, package, None)
    assert measured(loaded(tmp_path, "a.obj", SAME["Latin-1 in a name"])) == TETRAHEDRON
