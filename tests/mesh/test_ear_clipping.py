"""Polygons in triangles: the area is the polygon's, no triangle turns the other way, and the corners are the same."""

import numpy as np
import pytest

from sss_ref.mesh import ear_clipping
from sss_ref.mesh.ear_clipping import cut, fan

L = [(2, 1), (1, 1), (1, 2), (0, 2), (0, 0), (2, 0)]  # area 3
DART = [(0, 0), (2, 1), (0, 2), (1, 1)]  # area 1, reflex at the last corner
COMB = [(0, 0), (7, 0), (7, 3), (6, 1), (5, 3), (4, 1), (3, 3), (2, 1), (1, 3)]  # area 13.5
FRAME = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]  # a hole and its bridge: 12
T_JUNCTION = [(0, 0), (1, 0), (2, 0), (2, 2), (1, 1), (0, 2)]  # a corner on an edge, and a reflex one: 3
SPIKE = [(4, 0), (5, 5), (3, 5), (3, 1), (3, 4), (3, 3), (0, 2)]  # along itself and back; some corners touch: 11
NEEDLE = [(2, 0), (3, 2), (1, 2), (1, 0), (1, 3), (0, 0)]  # down to an edge and back up: 4.5
SHUT = [(2, 1), (2, 0), (3, 3), (2, 2), (1, 3), (1, 0), (1, 2)]  # its reflex corners lie on the others' edges: 2
SHAPES = {
    "spike": (SPIKE, 11),
    "needle": (NEEDLE, 4.5),
    "shut": (SHUT, 2),
    "L": (L, 3),
    "dart": (DART, 1),
    "comb": (COMB, 13.5),
    "frame": (FRAME, 12),
    "corner on an edge": (T_JUNCTION, 3),
}
PLANES = {"xy": (0, 1, 2), "yz": (2, 0, 1), "zx": (1, 2, 0), "xz": (0, 2, 1)}


def in_space(polygon, plane="xy"):
    return np.column_stack([np.array(polygon, float), np.full(len(polygon), 5.0)])[:, PLANES[plane]]


def cross(points, triangles):
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return np.cross(b - a, c - a)


def area(points, triangles):
    return np.linalg.norm(cross(points, triangles), axis=1).sum() / 2


@pytest.mark.parametrize("plane", PLANES)
@pytest.mark.parametrize("shape", SHAPES)
def test_area_from_every_first_corner_and_both_ways_round(shape, plane):
    polygon, expected = SHAPES[shape]
    for turn in range(len(polygon)):
        for points in (
            np.roll(in_space(polygon, plane), turn, axis=0),
            np.roll(in_space(polygon, plane), turn, axis=0)[::-1],
        ):
            found = cut(points, np.array([len(polygon)]))
            assert area(points, found.corners) == expected and found.crossed == 0
            assert found.corners.shape == (len(polygon) - 2, 3)
            normals = cross(points, found.corners)
            assert (normals @ normals.sum(axis=0) >= 0).all()


def test_convex_polygons_are_fans_around_their_first_corner():
    hexagon = np.array([(4, 0, 0), (2, 3, 0), (-2, 3, 0), (-4, 0, 0), (-2, -3, 0), (2, -3, 0)], float)
    assert (
        cut(hexagon, np.array([6])).corners.tolist() == [[0, 1, 2], [2, 3, 0], [3, 4, 0], [4, 5, 0]] == fan(6).tolist()
    )


def test_quads_take_the_other_diagonal_where_the_first_lies_outside():
    for turn in range(4):
        points = np.roll(in_space(DART), turn, axis=0)
        reflex = (3 + turn) % 4
        assert all(reflex in triangle for triangle in cut(points, np.array([4])).corners.tolist())


def test_a_quad_that_is_not_flat_is_cut_from_its_first_corner():
    for lift in (1, -1):
        points = np.array([(0, 0, 0), (1, 0, 0), (1, 1, lift), (0, 1, 0)], float)
        assert cut(points, np.array([4])).corners.tolist() == [[0, 1, 2], [2, 3, 0]]


def test_polygons_of_several_sizes_stay_in_order():
    sizes = [3, 6, 4, 3, 4]
    points = np.concatenate([in_space(polygon) for polygon in (L[:3], L, DART, L[:3], DART)])
    found = cut(points, np.array(sizes))
    ends = np.cumsum(sizes)
    assert np.searchsorted(ends, found.corners, side="right").tolist() == [
        [k] * 3 for k in (0, 1, 1, 1, 1, 2, 2, 3, 4, 4)
    ]
    assert area(points, found.corners[1:5]) == 3 and area(points, found.corners[5:7]) == 1


BOW_TIES = {"even": [(0, 0), (1, 0), (0, 1), (1, 1)], "uneven": [(0, 0), (4, 4), (4, 0), (0, 1)]}


@pytest.mark.parametrize("name", BOW_TIES)
def test_polygons_that_cross_themselves_are_fans_and_counted(name):
    found = cut(in_space(BOW_TIES[name]), np.array([4]))
    assert found.corners.tolist() == fan(4).tolist() and found.crossed == 1


def test_polygons_without_area_are_fans():
    points = np.array([(0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 3, 3), (1, 1, 1)], float)
    found = cut(points, np.array([5]))
    assert found.corners.tolist() == fan(5).tolist() and found.crossed == 0


def test_large_polygons_that_are_not_convex_are_fans_and_counted(monkeypatch):
    monkeypatch.setattr(ear_clipping, "CLIPPED_LIMIT", 5)
    found = cut(in_space(L), np.array([6]))
    assert found.corners.tolist() == fan(6).tolist() and found.crossed == 1


def test_random_polygons_keep_their_area():
    """Stars around the origin with whole corners, so that areas are exact."""
    random = np.random.default_rng(4)
    for size in (5, 8, 30):
        angles = (np.arange(size) + random.uniform(0, 0.9, (50, size))) * (2 * np.pi / size)
        radii = random.uniform(100, 1000, (50, size))
        x, y = np.round(radii * np.cos(angles)), np.round(radii * np.sin(angles))
        doubled = np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1))
        points = np.stack([x, y, np.zeros_like(x)], axis=2).reshape(-1, 3)
        found = cut(points, np.full(50, size))
        assert found.crossed == 0
        assert np.array_equal(np.abs(cross(points, found.corners)).sum(axis=1).reshape(50, -1).sum(axis=1), doubled)


def test_the_first_corner_that_can_be_is_cut_off():
    """Rule R10 by hand: at the bridge, corners at the place of the triangle's own do not keep it from being cut off."""
    assert cut(in_space(FRAME), np.array([10])).corners.tolist() == [
        *([9, 0, 1], [3, 4, 5], [3, 5, 6], [2, 3, 6]),
        *([2, 6, 7], [1, 2, 7], [1, 7, 8], [9, 1, 8]),
    ]
