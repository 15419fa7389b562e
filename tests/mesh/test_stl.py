"""STL in text and binary. Right values: the specification, Blender, assimp and MeshLab agree."""

import struct

import numpy as np
import pytest
from mesh_texts import FACES, POINTS, TETRAHEDRON, centres, loaded, measured, refusal

NO_TRIANGLE = "expected at least one triangle, got none; export the mesh as triangles or polygons"
AGAIN = "; export the mesh again"


def facet(face, normal="0 0 0"):
    rows = "".join("      vertex {} {} {}\n".format(*POINTS[k]) for k in face)
    return f"  facet normal {normal}\n    outer loop\n{rows}    endloop\n  endfacet\n"


def text(name=" t", end="endsolid t\n"):
    return f"solid{name}\n" + "".join(map(facet, FACES)) + end


def binary(header=b"x", count=4, behind=b"", normal=(0, 0, 0), attribute=0):
    points = np.array(POINTS, "<f4")
    facets = b"".join(
        struct.pack("<3f", *normal) + points[list(face)].tobytes() + struct.pack("<H", attribute) for face in FACES
    )
    return header.ljust(80, b"\0") + struct.pack("<I", count) + facets + behind


ON_ONE_LINE = " ".join(map(facet, FACES)).replace("\n", " ")
SAME = {
    "text": text(),
    "end solid": text(end="end solid t\n"),
    "another name at the end": text(end="endsolid other\n"),
    "no name at the end": text(end="endsolid"),
    "no end": text(end=""),
    "no name": text(name="", end="endsolid\n"),
    "capitals": text().upper(),
    "mixed letters": text().title(),
    "keywords in the name": text(name=" vertex 1 2 3 endloop", end="endsolid vertex 1 2 3 endloop\n"),
    "keywords in the name of end solid": text(end="end solid vertex 1 2 3 endloop\n"),
    "end facet on a line with the next": "solid\n" + ON_ONE_LINE.replace("endfacet", "\nend facet"),
    "# before a loop": "solid\n" + ON_ONE_LINE.replace("outer loop", "# outer loop"),
    "# in the name": text(name=" part #1"),
    "Latin-1 in the name": text(name=" Kopf\u00e4").encode("latin-1"),
    "several solids": "".join(f"solid {k}\n{facet(face)}endsolid {k}\n" for k, face in enumerate(FACES)),
    "solids without ends": "".join(f"solid {k}\n{facet(face)}" for k, face in enumerate(FACES)),
    "no first line": "".join(map(facet, FACES)),
    "carriage returns": text().replace("\n", "\r"),
    "carriage returns and line feeds": text().replace("\n", "\r\n"),
    "tabs": text().replace("  ", "\t"),
    "one long line": "solid\n" + text(name="", end="").removeprefix("solid\n").replace("\n", " ") + "\nendsolid",
    "a byte-order mark": b"\xef\xbb\xbf" + text().encode(),
    "zeros behind the end": text() + "\0" * 90,
    "a zero in the name": text(name=" t\0"),
    "a zero in the last byte of what may be a header": text(name=f" {'t' * 73}\0"),
    "blank lines first": "\n\n  " + text(),
    "as many blanks first as are looked at": " " * 1019 + text(),
    "forms of numbers": text().replace("vertex 1 0 0", "vertex +1.0E+00 0. .0"),
    "normals that are none": text().replace("normal 0 0 0", "normal nan 1 9"),
    "binary": binary(),
    "binary that begins with solid": binary(b"solid facet"),
    "binary that begins with solid and blanks": binary(b"solid".ljust(80)),
    "binary with colours": binary(b"COLOR=\1\2\3\4", attribute=0x7FFF, normal=(np.nan, 1, 2)),
}


@pytest.mark.parametrize("name", SAME)
def test_the_same_tetrahedron(tmp_path, name):
    mesh = loaded(tmp_path, "a.stl", SAME[name])
    assert measured(mesh) == TETRAHEDRON and mesh.notes == ()
    assert len(mesh.positions) == 12 and centres(mesh) == [1, 1, 0, 1]
    assert mesh.normals_source == "computed"


@pytest.mark.parametrize("header", [b"x", b"solid", b"solid facet"])
@pytest.mark.parametrize("behind", [1, 37, 50, 1000])
def test_bytes_behind_the_last_triangle(tmp_path, header, behind):
    mesh = loaded(tmp_path, "a.stl", binary(header, behind=b"\1" * behind))
    assert measured(mesh) == TETRAHEDRON
    assert mesh.notes == (f"it declares 4 triangles, {behind} bytes follow: they are not used",)


REFUSED = {
    "more declared": (binary(count=5), "expected the 5 triangles it declares, of 50 bytes each, got 200 bytes" + AGAIN),
    "a count never filled in": (
        binary(count=2**32 - 1),
        f"expected the {2**32 - 1} triangles it declares, of 50 bytes each, got 200 bytes" + AGAIN,
    ),
    "none declared": (
        binary(count=0),
        "expected at least one triangle, got a file that declares 0 triangles, 200 bytes follow" + AGAIN,
    ),
    "none declared, and a byte behind": (
        binary(count=0)[:84] + b"\1",
        "expected at least one triangle, got a file that declares 0 triangles, 1 bytes follow" + AGAIN,
    ),
    "a header alone": (binary()[:84], "expected the 4 triangles it declares, of 50 bytes each, got 0 bytes" + AGAIN),
    "less than a header": (binary()[:83], NO_TRIANGLE),
    "a first word beyond what is looked at": (
        " " * 1020 + text(),
        f"expected the {int.from_bytes(b'    ', 'little')} triangles it declares, of 50 bytes each, "
        f"got {1020 + len(text()) - 84} bytes" + AGAIN,
    ),
    "cut short": (binary()[:-1], "expected the 4 triangles it declares, of 50 bytes each, got 199 bytes" + AGAIN),
    "nothing in it": (binary(count=0)[:84], NO_TRIANGLE),
    "no bytes": (b"", NO_TRIANGLE),
    "no facets": ("solid a long name\nendsolid a long name\n" * 9, NO_TRIANGLE),
    "two vertices": (
        text().replace("      vertex 1 0 0\n", "", 1),
        "expected three vertices and endloop in every facet, got 2 vertices in facet 0" + AGAIN,
    ),
    "text cut between vertices": (
        text()[: text().rindex("      vertex")],
        "expected three vertices and endloop in every facet, got 2 vertices in facet 3" + AGAIN,
    ),
    "text cut within a vertex": (
        text()[: text().rindex(" 1\n    endloop")],
        "expected three numbers for each vertex, got a file that ends before" + AGAIN,
    ),
    "two bytes a letter": (text().encode("utf-16"), "expected text in UTF-8, got text in UTF-16; save it as UTF-8"),
    "no number": (
        text().replace("vertex 1 0 0", "vertex 1 x 0", 1),
        "expected positions that are finite in float32, got [1.0, nan, 0.0] at vertex 2 (1 in all); correct them",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(tmp_path, name):
    content, expected = REFUSED[name]
    assert refusal(tmp_path, "a.stl", content) == expected


def test_facets_of_more_corners_are_cut(tmp_path):
    rows = "".join(f"vertex {x} {y} 0\n" for x, y in [(2, 1), (1, 1), (1, 2), (0, 2), (0, 0), (2, 0)])
    mesh = loaded(tmp_path, "a.stl", f"solid\nfacet normal 0 0 1\nouter loop\n{rows}endloop\nendfacet\n")
    assert measured(mesh) == {"triangles": 4, "area": 3, "volume": 0}
