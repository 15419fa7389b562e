"""How sharply a mesh is bent: balls, cylinders, planes, and what lies between the vertices."""

import numpy as np
import pytest
from scenes import cube, sphere

from sss_ref.mesh.curvature import over_triangles, triangle_curvatures, unit_rows, vertex_curvatures
from sss_ref.mesh.normals import vertex_normals


@pytest.mark.parametrize("radius", [0.5, 1.0, 8.0])
def test_a_ball_is_bent_by_one_over_its_radius_everywhere(radius):
    normals, triangles, _ = sphere(9)
    found = triangle_curvatures(radius * normals, normals, triangles)
    np.testing.assert_allclose(found, 1 / radius, rtol=1e-12)
    positions = (radius * normals).astype(np.float32)
    found = vertex_curvatures(positions, radius * normals, normals, triangles)
    np.testing.assert_allclose(found[np.unique(triangles)], 1 / radius, rtol=1e-12)


def test_what_is_flat_is_not_bent():
    positions, triangles = cube()
    corners = positions[triangles].reshape(-1, 3)
    split = np.arange(len(corners)).reshape(-1, 3)
    normals = vertex_normals(corners.astype(np.float32) + np.repeat(np.arange(len(split)), 3)[:, None] * 10, split)
    assert not triangle_curvatures(corners, normals.astype(np.float64), split).any()


def test_by_hand():
    # The normals turn by (0, 0, 1) and (1, 0, 0) along the edges: 1 + 1 + 2 over 9 + 16 + 25.
    # The other triangle has no size, whatever its normals are.
    points = np.float64([(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 0)])
    normals = np.float64([(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 5, 0)])
    triangles = np.int32([(0, 1, 2), (0, 3, 3)])
    assert triangle_curvatures(points, normals, triangles).tolist() == [np.sqrt(4 / 50), 0]


def test_squares_are_added_in_their_order():
    """Of the edges that end at the first, the second and the third corner, each x, y, z: the bits are those."""
    points, normals = np.random.default_rng(5).normal(size=(2, 90, 3))

    def squared(corners):
        total = None
        for end, start in ((0, 2), (1, 0), (2, 1)):
            x, y, z = (float(each) for each in corners[end] - corners[start])
            square = (x * x + y * y) + z * z
            total = square if total is None else total + square
        return total

    triangles = np.arange(90, dtype=np.int32).reshape(30, 3)
    expected = [np.sqrt(squared(normals[each]) / squared(points[each])) for each in triangles]
    assert triangle_curvatures(points, normals, triangles).tolist() == expected


def test_a_vertex_has_the_mean_of_its_triangles_by_area_across_seams():
    # Two triangles at one place, of areas 6 and 2, which share it by two vertices; the third has no area.
    points = np.float64([(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 0), (-2, 0, 0), (0, 0, 2), (9, 9, 9)])
    normals = np.float64([(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 0, 0), (0, 0, 1), (0, 0, 0), (0, 0, 0)])
    triangles = np.int32([(0, 1, 2), (3, 4, 5), (6, 6, 6)])
    sharp, blunt = np.sqrt(4 / 50), np.sqrt(2 / 16)
    found = vertex_curvatures(points.astype(np.float32), points, normals, triangles)
    np.testing.assert_allclose(found[[0, 3]], (12 * sharp + 4 * blunt) / 16, rtol=1e-15)
    np.testing.assert_allclose(found[[1, 4, 6]], [sharp, blunt, 0], rtol=1e-15)


def crossed(a, b):
    (x, y, z), (p, q, r) = a, b
    return [y * r - z * q, z * p - x * r, x * q - y * p]


def dotted(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


@pytest.mark.parametrize("size", [1.0, 0.01, 300.0])
def test_planes_have_the_bits_of_the_formula(size):
    """One triangle after the other, with Python's numbers."""
    random = np.random.default_rng(6)
    points, values = random.normal(size=(60, 3)) * size, random.random(60)
    triangles = np.arange(60, dtype=np.int32).reshape(20, 3)
    found = over_triangles(values, points, triangles)
    for plane, (p0, p1, p2), (k0, k1, k2) in zip(
        found, points[triangles].tolist(), values[triangles].tolist(), strict=True
    ):
        e1, e2 = ([y - x for x, y in zip(p0, end, strict=True)] for end in (p1, p2))
        n = crossed(e1, e2)
        raised = [x * (k1 - k0) + y * (k2 - k0) for x, y in zip(crossed(e2, n), crossed(n, e1), strict=True)]
        g = [each / dotted(n, n) for each in raised]
        assert plane.tolist() == [*g, k0 - dotted(g, p0)]


def test_rows_of_length_1():
    rows = np.array([(3.0, 4, 12), (0, 0, 0), (0, -0.5, 0), (1, 1, 1)])
    third = 1 / np.sqrt(3.0)
    assert unit_rows(rows).tolist() == [[3 / 13, 4 / 13, 12 / 13], [0, 0, 0], [0, -1, 0], [third, third, third]]


def test_between_vertices_it_is_a_plane():
    rng = np.random.default_rng(8)
    points, values = rng.normal(size=(12, 3)), rng.random(12)
    triangles = np.arange(12, dtype=np.int32).reshape(4, 3)
    planes = over_triangles(values, points, triangles)
    for plane, corners in zip(planes, triangles, strict=True):
        np.testing.assert_allclose(points[corners] @ plane[:3] + plane[3], values[corners], rtol=1e-9)
    flat = np.repeat(points[:1], 3, axis=0)
    for given in ([1.0, 2, 4], [4.0, 2, 1]):
        found = over_triangles(np.array(given), flat, np.int32([(0, 1, 2)]))
        assert found.tolist() == [[0, 0, 0, given[0]]] and not np.signbit(found).any()
