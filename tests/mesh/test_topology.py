import random
from fractions import Fraction

import numpy as np

from sss_ref.mesh.topology import is_inside, is_watertight, merged

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
OUTWARD = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.int32)


def cube(low, high):
    """Corners of a cube's twelve triangles, outward."""
    points = np.array([[x, y, z] for x in (low, high) for y in (low, high) for z in (low, high)], np.float64)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points[np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])]


def test_equal_positions_merge_and_minus_zero_is_zero():
    number = merged(np.array([[0, 1, 2], [5, 1, 2], [-0.0, 1, 2]], np.float32))
    assert number[0] == number[2] != number[1]


def test_positions_that_differ_by_a_bit_are_two():
    tiny = np.float32([0, 1e-45, 1e-9, np.nextafter(np.float32(1e-9), np.float32(1))])
    assert len({*merged(np.stack([tiny, tiny * 0, tiny * 0], axis=1)).tolist()}) == 4


def test_watertight_despite_split_vertices():
    corners = TETRAHEDRON[OUTWARD].reshape(-1, 3)
    assert is_watertight(TETRAHEDRON, OUTWARD)
    assert is_watertight(corners, np.arange(12, dtype=np.int32).reshape(4, 3))


def test_not_watertight():
    turned = OUTWARD.copy()
    turned[0] = turned[0, ::-1]
    twice = np.concatenate([OUTWARD, OUTWARD])
    assert not is_watertight(TETRAHEDRON, OUTWARD[:3])
    assert not is_watertight(TETRAHEDRON, turned)
    assert not is_watertight(TETRAHEDRON, twice)


def test_triangles_without_area_do_not_count():
    assert is_watertight(TETRAHEDRON, np.concatenate([OUTWARD, [[1, 1, 2]]]).astype(np.int32))


def test_inside_on_every_alignment_with_edges_and_corners():
    """A ray from a grid point runs through edges, diagonals and corners of the cube."""
    corners = cube(-2, 2)
    for point in np.ndindex(7, 7, 7):
        position = np.array(point, np.float64) - 3
        if np.abs(position).max() != 2:  # on the surface there is no answer
            assert is_inside(position, corners) == (np.abs(position).max() < 2)


def test_a_hollow_is_outside():
    corners = np.concatenate([cube(-2, 2), cube(-1, 1)[:, ::-1]])
    assert not is_inside(np.zeros(3), corners)
    assert is_inside(np.array([1.5, 0, 0]), corners)


def test_inside_agrees_with_exact_arithmetic():
    generator = random.Random(1)
    corners = TETRAHEDRON.astype(np.float64)[OUTWARD]
    answers = []
    for _ in range(500):
        point = [generator.uniform(-0.2, 0.8) for _ in range(3)]
        exact = [Fraction(x) for x in point]
        answers.append(min(exact) > 0 and sum(exact) < 1)
        assert is_inside(np.array(point), corners) == answers[-1]
    assert 50 < sum(answers) < 450
