"""A mesh in the world: where its vertices are, what is inside, which of its triangles have an area."""

import numpy as np
import pytest
from bodies import body
from scenes import cube

from sss_ref.scene.placed_mesh import PlacedMesh

STEP = 2.0**-23
STAYING = np.eye(4)
TURNED = np.array([[0, -2, 0, 5], [2, 0, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1.0]])


def sliver(width, length=1.0, at=(0, 0, 0), order=(0, 1, 2)):
    """A triangle of this length and width, its corners in any order."""
    corners = np.array([(0, 0, 0), (length, 0, 0), (length / 2, width, 0)])
    return (corners + at)[list(order)]


def has_area(triangles, world_from_model=STAYING):
    points = np.concatenate(triangles)
    return PlacedMesh(body(points, np.arange(len(points)).reshape(-1, 3)), world_from_model).has_area


@pytest.mark.parametrize("order", [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1)])
@pytest.mark.parametrize("length", [0.25, 1.0, 8.0])
def test_a_triangle_has_an_area_that_is_wider_than_float32_tells_at_its_length(length, order):
    """Twice the area is length times width, and that is held against 2^-23 of the length squared."""
    assert not has_area([sliver(length * STEP, length, order=order)])
    assert has_area([sliver(1.5 * length * STEP, length, order=order)])
    upright = sliver(1.5 * length * STEP, length, order=order)[:, [2, 0, 1]]
    assert has_area([upright]) and not has_area([upright * (0, 2, 1)])


def test_the_area_is_that_in_the_world():
    """A factor of zero on one coordinate takes it away; a move does not."""
    triangle = [(1, 2, 3), (2, 2, 3), (1, 3, 3)]
    flat = np.diag([1.0, 0, 1, 1])
    assert has_area([triangle], TURNED) and not has_area([triangle], flat)
    moved = sliver(2.0**-12, at=(1024, 512, -256))
    assert has_area([moved])
    assert not has_area([sliver(2.0**-24, at=(0, 0, 1024))])


@pytest.mark.parametrize("wide", [0, 1, 4095, 4096, 4999])
def test_one_of_many_is_enough(wide):
    triangles = np.zeros((5000, 3, 3))
    assert not has_area(triangles)
    triangles[wide, 1, 0] = triangles[wide, 2, 1] = 1
    assert has_area(triangles)


def test_points_are_in_the_world():
    """(1, 2, 3) turned by 90 degrees about z, doubled, moved."""
    assert PlacedMesh(body([(1, 2, 3)] * 3), TURNED).points.tolist() == [[1, 8, 13]] * 3


@pytest.mark.parametrize(
    ("point", "inside"),
    [((5, 6, 7), True), ((6.9, 7.9, 8.9), True), ((7.1, 6, 7), False), ((5, 6, 4.9), False), ((0, 0, 0), False)],
)
def test_the_inside_is_that_of_a_closed_mesh(point, inside):
    """The cube from -1 to 1, doubled and moved to (5, 6, 7); without one of its triangles it has no inside."""
    positions, triangles = cube()
    assert PlacedMesh(body(positions, triangles), TURNED).encloses(np.array(point, float)) == inside
    opened = PlacedMesh(body(positions, triangles[1:]), TURNED)
    assert not opened.is_watertight and not opened.encloses(np.array(point, float))


def test_beside_a_corner_is_in_the_box_and_not_inside():
    tetrahedron = body([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    placed = PlacedMesh(tetrahedron, np.eye(4))
    assert placed.is_watertight and placed.encloses(np.array([0.1, 0.1, 0.1]))
    assert placed.bounds.holds(np.array([0.9, 0.9, 0.9])) and not placed.encloses(np.array([0.9, 0.9, 0.9]))
