"""MTL: the colours of materials, from one library or several, and what is said of their pictures."""

import pytest
from mesh_texts import loaded, refusal

from sss_ref.mesh.materials import Material

OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl red\nf 1 2 3\nusemtl grey\nf 2 4 3\n"
RED, GREY = Material("red", (1, 0.25, 0)), Material("grey", (0.5, 0.5, 0.5))
TEXT = "newmtl red\nKd 1 .25 0\nnewmtl grey\nKd .5 .5 .5\n"


def materials(folder, mtl, library="mtllib a.mtl", obj=OBJ):
    (folder / "a.mtl").write_bytes(mtl if isinstance(mtl, bytes) else mtl.encode())
    return loaded(folder, "a.obj", f"{library}\n{obj}")


SAME = {
    "plain": TEXT,
    "tabs": TEXT.replace(" ", "\t"),
    "indented": TEXT.replace("Kd", "\t Kd"),
    "comments": TEXT.replace("0\n", "0 # red\n"),
    "carriage returns": TEXT.replace("\n", "\r"),
    "carriage returns and line feeds": TEXT.replace("\n", "\r\n"),
    "a byte-order mark": b"\xef\xbb\xbf" + TEXT.encode(),
    "Latin-1 in a comment": b"# K\xf6pfe\n" + TEXT.encode(),
    "Latin-1 in another name": b"newmtl K\xf6pfe\nKd 0 0 1\n" + TEXT.encode(),
    "one number is grey": TEXT.replace("Kd .5 .5 .5", "Kd .5"),
    "the last Kd counts": TEXT.replace("Kd 1", "Kd 0 0 0\nKd 1"),
    "other keys": TEXT.replace("Kd", "Ka 1 1 1\nNs 10\nillum 2\nKd"),
    "the first of a name counts": TEXT + "newmtl red\nKd 0 0 0\n",
}


@pytest.mark.parametrize("name", SAME)
def test_the_same_colours(tmp_path, name):
    mesh = materials(tmp_path, SAME[name])
    assert mesh.materials == (RED, GREY) and mesh.material.tolist() == [0, 1] and mesh.notes == ()


@pytest.mark.parametrize("color", ["", "Kd", "Kd -1 0 0", "Kd nan 0 0", "Kd 1 0", "Kd spectral a.rfl 1", "Kd 1e39 0 0"])
def test_what_is_no_colour(tmp_path, color):
    assert materials(tmp_path, f"newmtl red\n{color}\nnewmtl grey\nKd .5 .5 .5\n").materials == (Material("red"), GREY)


LIBRARIES = {
    "a line": "mtllib a.mtl b.mtl",
    "two lines": "mtllib a.mtl\nmtllib b.mtl",
    "runs of blanks": "mtllib \t a.mtl  \t b.mtl ",
    "a comment": "mtllib a.mtl b.mtl # both",
}


@pytest.mark.parametrize("name", LIBRARIES)
def test_several_libraries(tmp_path, name):
    (tmp_path / "b.mtl").write_text("newmtl grey\nKd .5 .5 .5\n")
    assert materials(tmp_path, "newmtl red\nKd 1 .25 0\n", LIBRARIES[name]).materials == (RED, GREY)


@pytest.mark.parametrize(
    "line", ["my head.mtl", "my head.mtl a.mtl", "a.mtl my head.mtl", "./my head.mtl", "my%20head.mtl"]
)
def test_libraries_with_blanks_in_their_names(tmp_path, line):
    (tmp_path / "my head.mtl").write_text(TEXT)
    assert materials(tmp_path, "newmtl other\n", f"mtllib {line}").materials == (RED, GREY)


def test_names_with_blanks_and_marks_of_comments(tmp_path):
    mtl = "newmtl skin of #1\nKd 1 0 0\nnewmtl skin of #2\nKd 0 1 0\nnewmtl bone\nKd 0 0 1\n"
    obj = OBJ.replace("red", "skin of #2").replace("grey", "bone # not skin")
    assert [each.color for each in materials(tmp_path, mtl, obj=obj).materials] == [(0, 1, 0), (0, 0, 1)]


def test_names_beyond_ascii_in_either_encoding(tmp_path):
    obj = OBJ.replace("red", "H\u00e4ute")
    mesh = materials(tmp_path, "newmtl H\u00e4ute\nKd 1 0 0\n".encode("latin-1"), obj=obj)
    assert mesh.materials[0] == Material("H\u00e4ute", (1, 0, 0))


def test_a_library_that_is_not_there(tmp_path):
    mesh = loaded(tmp_path, "a.obj", f"mtllib none.mtl\n{OBJ}")
    assert mesh.materials == (Material("red"), Material("grey"))
    assert mesh.notes == ('materials of "none.mtl" not used: there is no such file beside the mesh',)


def test_materials_that_the_libraries_do_not_have(tmp_path):
    note = 'material "red" is not in a.mtl (2 in all)'
    assert materials(tmp_path, "newmtl red\nKd 1 0 0\n".encode("utf-16")).notes == (note,)
    assert materials(tmp_path, "newmtl red\n").notes == ('material "grey" is not in a.mtl (1 in all)',)


@pytest.mark.parametrize("name", ["\0", "a" * 5000, "a/" * 3000])
def test_a_library_whose_name_is_none(tmp_path, name):
    assert len(loaded(tmp_path, "a.obj", f"mtllib {name}\n{OBJ}").notes) >= 1


PICTURES = {
    "map_Kd skin.png": (),
    "map_kd  skin of a head.png": (),
    "map_Kd -s 2 2 1 skin.png": ('material "red": map_Kd -s 2 2 1 is not applied',),
    "map_Kd -o .5 -clamp on skin.png": ('material "red": map_Kd -o .5 -clamp on is not applied',),
    "map_Kd -s 2 -mm 0 .5 -blendu off -texres 512 2.png": (
        'material "red": map_Kd -s 2 -mm 0 .5 -blendu off -texres 512 is not applied',
    ),
}


@pytest.mark.parametrize("line", PICTURES)
def test_pictures_and_their_options(tmp_path, line):
    mesh = materials(tmp_path, TEXT.replace("newmtl red\n", f"newmtl red\n{line}\n"))
    assert mesh.materials == (Material("red", RED.color, textured=True), GREY)
    assert mesh.notes == PICTURES[line]


def test_pictures_of_materials_that_no_face_has_are_not_spoken_of(tmp_path):
    assert materials(tmp_path, TEXT + "newmtl other\nmap_Kd -s 2 a.png\n").notes == ()


@pytest.mark.parametrize("options", ["", "-s 2 2 1 ", "-clamp on "])
def test_pictures_elsewhere(tmp_path, options):
    (tmp_path / "a.mtl").write_text(f"newmtl m\nmap_Kd {options}../secret.png\n")
    assert refusal(tmp_path, "a.obj", f"mtllib a.mtl\n{OBJ}") == (
        'expected references to files in its own folder, got "../secret.png"; copy the file there'
    )
