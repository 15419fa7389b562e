"""From polygons to parts: which vertices there are, in which order."""

from pathlib import Path

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh.materials import Material
from sss_ref.mesh.polygons import Attribute, Polygons, counted, in_triangles

PATH = Path("a.obj")
SQUARE = np.array([(0, 0, 0), (1, 0, 0), (9, 9, 9), (1, 1, 0), (0, 1, 0)], float)
TWO = {"positions": SQUARE, "sizes": np.array([3, 3]), "corner": np.array([4, 0, 1, 4, 1, 3])}


def part(**changes):
    content = in_triangles(PATH, Polygons(**{**TWO, **changes}))
    return content.parts[0], content


def test_unused_vertices_are_left_out_and_the_others_stay_in_order():
    found, content = part()
    assert np.array_equal(found.positions, SQUARE[[0, 1, 3, 4]])
    assert found.triangles.tolist() == [[3, 0, 1], [3, 1, 2]]
    assert content.notes == () and content.materials is None


def test_a_number_out_of_reach_where_no_triangle_is():
    positions = SQUARE.copy()
    positions[2] = np.nan
    assert len(part(positions=positions)[0].positions) == 4
    with pytest.raises(MeshError) as error:
        part(positions=positions, corner=np.array([4, 0, 1, 4, 1, 2]))
    assert "got [nan, nan, nan] at vertex 2 (1 in all)" in str(error.value)


def test_corners_that_differ_in_a_uv_are_two_vertices():
    uvs = Attribute(np.array([(0, 0), (1, 1)], float), np.array([0, 0, 0, 1, 0, 0]))
    found, _ = part(uvs=uvs)
    assert found.positions[:, :2].tolist() == [[0, 0], [1, 0], [1, 1], [0, 1], [0, 1]]
    assert found.uvs[:, 0].tolist() == [0, 0, 0, 0, 1]
    assert found.triangles.tolist() == [[3, 0, 1], [4, 1, 2]]


def test_another_position_with_another_uv_is_another_vertex():
    """Of five positions and two UVs: the first with the second UV, the third with the first, and so on."""
    chosen = [1, 0, 1, 1, 0, 0]
    uvs = Attribute(np.array([(0, 0), (1, 1)], float), np.array(chosen))
    found, _ = part(corner=np.array([0, 2, 1, 3, 4, 1]), uvs=uvs)
    assert found.positions[found.triangles].tolist() == SQUARE[[0, 2, 1, 3, 4, 1]].reshape(2, 3, 3).tolist()
    assert found.uvs[found.triangles][:, :, 0].reshape(-1).tolist() == chosen
    assert len(found.positions) == 6


def test_corners_that_differ_in_a_normal_alone():
    found, _ = part(
        uvs=Attribute(np.zeros((1, 2)), np.zeros(6, int)),
        normals=Attribute(np.eye(3), np.array([0, 0, 1, 0, 2, 0])),
    )
    assert len(found.positions) == 5 and found.normals[found.triangles[:, 1:]].argmax(axis=2).tolist() == [
        [0, 1],
        [2, 0],
    ]


@pytest.mark.parametrize("missing", [-1, 2])
def test_uvs_and_normals_that_some_corner_lacks(missing):
    some = Attribute(np.zeros((2, 2)), np.array([0, 0, 0, 1, 0, missing]))
    found, content = part(uvs=some, normals=Attribute(np.ones((2, 3)), some.corner))
    assert found.uvs is None and found.normals is None
    assert content.notes == (
        "UVs not used: the file does not give them for every corner",
        "normals computed: the file does not give them for every corner",
    )


def test_materials_follow_the_triangles_of_their_polygons():
    quad = {"sizes": np.array([4, 2, 3]), "corner": np.array([0, 1, 3, 4, 0, 1, 4, 0, 1])}
    materials = Material("a"), Material("b"), Material("c")
    _, content = part(**quad, material=np.array([2, 1, 0], np.int32), materials=materials)
    assert content.materials[0].tolist() == [2, 2, 0] and content.materials[1] == materials
    assert content.notes == ("1 faces of fewer than three corners were passed over",)


def test_a_corner_that_is_no_vertex():
    with pytest.raises(MeshError) as error:
        part(corner=np.array([4, 0, 1, 4, 5, -1]))
    assert str(error.value) == (
        "a.obj: expected vertex indices from 0 to 4, got [4, 5, -1] in face 1 (2 corners in all); export the mesh again"
    )


def test_what_crosses_itself_is_noted():
    _, content = part(sizes=np.array([4]), corner=np.array([0, 3, 1, 4]))
    assert content.notes == (
        "1 polygons fold or cross themselves or have more than 4096 corners: they were cut into fans",
    )


def test_counted():
    assert counted(np.array([2, 0, 3])).tolist() == [0, 1, 0, 1, 2]
