"""Parts of a file."""

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import Part, finite32, placed, vertex_indices, whole, without_unused


def part(triangles):
    numbers = np.arange(5, dtype=np.float32)
    vectors = np.stack([numbers, numbers + 10, numbers + 20], axis=1)
    return Part(vectors, vectors + 100, vectors[:, :2] + 200, np.array(triangles), Material("m"))


def test_vertices_that_no_triangle_uses_are_left_out():
    found = without_unused(part([[4, 1, 3], [3, 1, 4]]))
    assert found.positions[:, 0].tolist() == [1, 3, 4] and found.normals[:, 0].tolist() == [101, 103, 104]
    assert found.uvs[:, 0].tolist() == [201, 203, 204] and found.triangles.tolist() == [[2, 0, 1], [1, 0, 2]]
    assert found.material == Material("m")


def test_a_part_that_uses_all_stays_as_it_is():
    whole = part([[4, 1, 3], [2, 0, 4]])
    assert without_unused(whole) is whole


@pytest.mark.parametrize(
    ("value", "is_one"),
    [
        (2.0**53 - 1, True),
        (-(2.0**53 - 1), True),
        (2.0**53, False),
        (-(2.0**53), False),
        (0.5, False),
        (np.nan, False),
        (np.inf, False),
    ],
)
def test_whole_numbers_lie_below_two_to_the_53(value, is_one):
    values = np.array([1.0, value, -3.0])
    if is_one:
        assert whole("a", values, "as indices").tolist() == [1, int(value), -3]
    else:
        with pytest.raises(MeshError, match=r"^a: expected whole numbers below 2\^53 as indices, got others; export"):
            whole("a", values, "as indices")


def test_the_first_triangle_with_a_corner_that_is_no_vertex_is_told():
    assert vertex_indices("a", np.uint8([0, 1, 2, 3, 4, 0]), 5).tolist() == [[0, 1, 2], [3, 4, 0]]
    for wrong in (5, -1):
        with pytest.raises(MeshError) as error:
            vertex_indices("a", np.array([0, 1, 2, 3, wrong, 0, wrong, wrong, wrong]), 5)
        came = f"[3, {wrong}, 0] in triangle 1 (2 in all)"
        assert str(error.value) == f"a: expected vertex indices from 0 to 4, got {came}; export the mesh again"


def test_the_first_point_beyond_float32_is_told():
    largest = float(np.finfo(np.float32).max)
    assert finite32("a", np.array([[largest, -largest]]), "UVs").tolist() == [[largest, -largest]]
    with pytest.raises(MeshError) as error:
        finite32("a", np.array([[0.0, 1], [2, 1e39], [np.nan, 0]]), "UVs")
    assert (
        str(error.value)
        == "a: expected UVs that are finite in float32, got [2.0, 1e+39] at vertex 1 (2 in all); correct them"
    )


def test_a_part_in_a_mirror_is_turned_right_side_out():
    """Positions by the transform, normals by its inverse transpose."""
    transform = np.array([[-2.0, 0, 0, 10], [0, 1, 0, 20], [0, 0, 4, 30], [0, 0, 0, 1]])
    triangles = np.array([[0, 1, 2]])
    points, normals = np.array([[1.0, 2, 3]]), np.array([[1.0, 1, 1]])
    position, normal, turned = placed("a", transform, points, normals, triangles)
    assert (position.tolist(), normal.tolist(), turned.tolist()) == ([[8, 22, 42]], [[-0.5, 1, 0.25]], [[2, 1, 0]])
    position, normal, same = placed("a", np.eye(4), points, None, triangles)
    assert (position.tolist(), normal, same.tolist()) == ([[1, 2, 3]], None, [[0, 1, 2]])
    with pytest.raises(MeshError, match=r"^a: expected transforms that can be inverted, got one that cannot; apply"):
        placed("a", np.diag([1.0, 0, 1, 1]), points, normals, triangles)
