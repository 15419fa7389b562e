"""OFF. Right values: the Geomview manual; MeshLab agrees where it reads the form."""

import numpy as np
import pytest
from mesh_texts import FACES, POINTS, TETRAHEDRON, centres, loaded, measured, refusal, rows

V, F = rows(POINTS), rows((3, *face) for face in FACES)
BODY = f"4 4 6\n{V}{F}"
AGAIN = "; export the mesh again"
NORMAL, COLOR, UV = (0, 0, 1), (255, 0, 0, 255), (0.25, 0.75)


def vertices(*behind):
    return rows((*point, *(number for group in behind for number in group)) for point in POINTS)


SAME = {
    "plain": f"OFF\n{BODY}",
    "counts behind the keyword": f"OFF {BODY}",
    "counts that touch the keyword": f"OFF{BODY}",
    "a line for each count": f"OFF\n4\n4\n6\n{V}{F}",
    "no number of edges": f"OFF\n4 4\n{V}{F}",
    "no number of edges, behind the keyword": f"OFF 4 4\n{V}{F}",
    "no keyword": BODY,
    "counts of eighteen digits": f"OFF\n{4:018} {4:018} 6\n{V}{F}",
    "small letters": f"off\n{BODY}",
    "comments": f"# a\nOFF # b\n# c\n\n{BODY}".replace("\n", " #d 9\n"),
    "tabs and blanks": f"\n OFF\n{BODY}".replace(" ", " \t ").replace("\n", "  \n\n"),
    "carriage returns": f"OFF\n{BODY}".replace("\n", "\r"),
    "carriage returns and line feeds": f"OFF\n{BODY}".replace("\n", "\r\n"),
    "a byte-order mark": b"\xef\xbb\xbf" + f"OFF\n{BODY}".encode(),
    "all on one line": f"OFF {BODY}".replace("\n", " "),
    "a line for each number": f"OFF\n{BODY}".replace(" ", "\n"),
    "vertices on one line": f"OFF\n4 4 6\n{V}".replace("\n", " ") + "\n" + F,
    "lines that break in a face": f"OFF\n{BODY}".replace("3 0 2 1", "3 0\n2 1"),
    "a colour behind a face that breaks": f"OFF\n{BODY}".replace("3 0 2 1", "3 0\n2 1 0 0 0"),
    "two faces on a line": f"OFF\n{BODY}".replace("1\n3 0 1", "1 3 0 1"),
    "colours of faces": f"OFF\n{BODY}".replace("3 0 2 1", "3 0 2 1 255 0 0").replace("3 0 1 3", "3 0 1 3 .1 .2 .3 1"),
    "a colour of each face by its number": f"OFF\n4 4 6\n{V}" + rows((3, *face, 5) for face in FACES),
    "colours of faces, vertices on one line": f"OFF\n4 4 6\n{V}".replace("\n", " ")
    + "\n"
    + rows((3, *face, 255, 0, 0) for face in FACES),
    "COFF": f"COFF\n4 4 6\n{vertices(COLOR)}{F}",
    "COFF of three": f"COFF\n4 4 6\n{vertices(COLOR[:3])}{F}",
    "COFF all on one line": f"COFF\n4 4 6\n{vertices(COLOR)}{F}".replace("\n", " "),
    "colours of vertices without the prefix": f"OFF\n4 4 6\n{vertices(COLOR)}{F}",
    "forms of numbers": f"OFF\n{BODY}".replace("1 0 0", "+1.e0 .0 0E3"),
    "Latin-1 in a comment": f"OFF # K\u00f6pfe\n{BODY}".encode("latin-1"),
}


@pytest.mark.parametrize("name", SAME)
def test_the_same_tetrahedron(tmp_path, name):
    mesh = loaded(tmp_path, "a.off", SAME[name])
    owner = "vertices" if "COFF" in name or "of vertices" in name else "faces"
    assert mesh.notes == ((f"colours of {owner} are not used",) if "COFF" in name or "colour" in name else ())
    assert measured(mesh) == TETRAHEDRON
    assert centres(mesh) == [1, 1, 0, 1] and mesh.normals_source == "computed" and mesh.uvs is None


ATTRIBUTES = {
    "NOFF": (NORMAL,),
    "CNOFF": (NORMAL, COLOR),
    "STOFF": (UV,),
    "STNOFF": (NORMAL, UV),
    "STCOFF": (COLOR, UV),
    "STCNOFF": (NORMAL, COLOR, UV),
    "NCOFF": (COLOR, NORMAL),
    "NSTOFF": (NORMAL, UV),
    "CSTOFF": (COLOR, UV),
    "NCSTOFF": (COLOR, NORMAL, UV),
}


@pytest.mark.parametrize("lines", ["a line each", "one line"])
@pytest.mark.parametrize("keyword", ATTRIBUTES)
def test_normals_and_uvs(tmp_path, keyword, lines):
    """Behind the position: normal, colour, UV; in the order of prefixes that MeshLab has, the colour first."""
    content = f"{keyword}\n4 4 6\n{vertices(*ATTRIBUTES[keyword])}"
    mesh = loaded(tmp_path, "a.off", (content if lines == "a line each" else content.replace("\n", " ")) + "\n" + F)
    assert measured(mesh) == TETRAHEDRON
    assert mesh.notes == (("colours of vertices are not used",) if "C" in keyword else ())
    assert mesh.normals_source == ("file" if "N" in keyword else "computed")
    assert mesh.normals.tolist() == [list(NORMAL)] * 4 or "N" not in keyword
    assert (mesh.uvs is not None) == ("ST" in keyword)
    assert mesh.uvs is None or mesh.uvs.tolist() == [list(UV)] * 4


def test_polygons_in_the_files_order(tmp_path):
    """A quad, an L that is not convex and a triangle."""
    points = [
        (0, 0, 0),
        (1, 0, 0),
        (1, 1, 0),
        (0, 1, 0),
        *((x + 10, y, 0) for x, y in [(2, 1), (1, 1), (1, 2), (0, 2), (0, 0), (2, 0)]),
    ]
    faces = [(4, 0, 1, 2, 3), (6, 4, 5, 6, 7, 8, 9), (3, 0, 1, 2)]
    mesh = loaded(tmp_path, "a.off", f"OFF\n10 3 0\n{rows(points)}{rows(faces)}")
    assert measured(mesh) == {"triangles": 7, "area": 4.5, "volume": 0}
    assert (np.array(centres(mesh)) > 3).tolist() == [False, False, True, True, True, True, False]


@pytest.mark.parametrize("end", ["\n", " "], ids=["a line each", "one line"])
def test_faces_of_no_one_or_two_corners_are_noted(tmp_path, end):
    mesh = loaded(tmp_path, "a.off", f"OFF\n4 7 0\n{V}2 0 1\n0\n{F}1 3\n".replace("\n", end))
    assert measured(mesh) == TETRAHEDRON and mesh.notes == ("3 faces of fewer than three corners were passed over",)


def test_colours_of_both_and_numbers_behind_are_noted(tmp_path):
    mesh = loaded(tmp_path, "a.off", f"COFF\n4 4 6\n{vertices(COLOR)}{F}".replace("3 0 2 1", "3 0 2 1 9") + "3 0 1 2\n")
    assert measured(mesh) == TETRAHEDRON
    assert mesh.notes == (
        "colours of vertices and faces are not used",
        "4 numbers behind the last face it declares are not used",
    )


REFUSED = {
    "4OFF": (f"4OFF\n4 4 6\n{vertices((1,))}{F}", "expected positions of 3 numbers, got the keyword 4OFF" + AGAIN),
    "nOFF": (f"nOFF\n3\n{BODY}", "expected positions of 3 numbers, got the keyword nOFF" + AGAIN),
    "binary": (
        b"OFF BINARY\n\0\0\0\4\0\0\0\4",
        "expected an off file in text, got a binary one; convert it to text or to a binary ply file",
    ),
    "binary on a line of its own": (
        b"COFF\nBINARY\n\0\0\0\4",
        "expected an off file in text, got a binary one; convert it to text or to a binary ply file",
    ),
    "another format": (
        "solid t\n",
        'expected a valid off file: OFF, then the numbers of vertices, faces and edges, got "solid"' + AGAIN,
    ),
    "nothing": (
        "",
        "expected a valid off file: OFF, then the numbers of vertices, faces and edges, got nothing" + AGAIN,
    ),
    "a face too few": (f"OFF\n4 5 6\n{V}{F}", "expected the 9 elements it declares, got 8 lines" + AGAIN),
    "no face": (
        f"OFF\n4 0 0\n{V}",
        "expected at least one triangle, got none; export the mesh as triangles or polygons",
    ),
    "vertices that are not there": (f"OFF\n404 0 0\n{V}", "expected the 404 elements it declares, got 4 lines" + AGAIN),
    "cut within a face": (f"OFF\n{BODY}"[:-4], "expected the 8 elements it declares, got 8 lines" + AGAIN),
    "beyond the last vertex": (
        f"OFF\n{BODY}".replace("3 1 2 3", "3 1 2 4"),
        "expected vertex indices from 0 to 3, got [1, 2, 4] in face 3 (1 corners in all)" + AGAIN,
    ),
    "beyond the last vertex, in a long face": (
        f"OFF\n4 5 6\n{V}9 0 1 2 3 0 1 2 3 4\n{F}",
        "expected vertex indices from 0 to 3, got [0, 1, 2, 3, 0, 1, 2, 3] in face 0 (1 corners in all)" + AGAIN,
    ),
    "an index that is none": (
        f"OFF\n{BODY}".replace("3 1 2 3", "3 1 2 .5"),
        "expected whole numbers below 2^53 as vertex indices, got others" + AGAIN,
    ),
    "an infinite index": (
        f"OFF\n{BODY}".replace("3 1 2 3", "3 1 2 inf"),
        "expected whole numbers below 2^53 as vertex indices, got others" + AGAIN,
    ),
    "a face of three corners and a half": (
        f"OFF\n{BODY}".replace("3 1 2 3", "3.5 1 2 3 0"),
        "expected whole numbers below 2^53 as counts of corners, got others" + AGAIN,
    ),
    "a number that is none": (
        f"OFF\n{BODY}".replace("0 0 1\n", "0 x 1\n"),
        "expected positions that are finite in float32, got [0.0, nan, 1.0] at vertex 3 (1 in all); correct them",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(tmp_path, name):
    content, expected = REFUSED[name]
    assert refusal(tmp_path, "a.off", content) == expected
