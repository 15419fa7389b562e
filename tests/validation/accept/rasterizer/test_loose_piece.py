"""A piece whose corners lie in boxes, worked out by hand and by trying every corner of the boxes."""

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest
from plain_kernels import plain

from sss_ref.validation.accept.rasterizer import loose_piece as kernels
from sss_ref.validation.accept.rasterizer.loose_piece import Depths, Geometry, LoosePiece, Side

ROUNDING = 1e-12  # relative: the same sums in another order
CENTRE = np.array([(0.0, 0.0), (4.0, 1.0), (1.0, 3.0), (-2.0, 7.0)])
HALF = np.array([(0.25, 0.5), (0.125, 0.0), (0.375, 0.25), (0.5, 0.0625)])
DEPTH, ERROR = np.array([0.25, 0.5, 0.125, 0.75]), np.array([0.01, 0.03, 0.02, 0.5])
PLANES = np.array([(0.1, 0.2), (0.3, 0.7)])
PRIMITIVES = SimpleNamespace(
    corners=np.array([(0, 1, 2), (1, 3, 2)]), inverse_w=np.array([1.0, 0.5, 2.0, 1.0]), triangle=np.array([5, 6])
)


@pytest.fixture(autouse=True)
def as_python(monkeypatch):
    plain(kernels, monkeypatch)


def geometry(half=HALF, turn=0, depth_step=0.0):
    return Geometry(CENTRE, half, DEPTH, ERROR, PLANES, 256, turn, depth_step)


def side_at(a, b, half_a=(0.0, 0.0), half_b=(0.0, 0.0)):
    return kernels.side(Geometry(np.array([a, b]), np.array([half_a, half_b]), *[None] * 6), 0, 1)


def test_a_side_has_its_boxes_and_the_hull_of_both():
    assert kernels.side(geometry(), 1, 3) == Side(4, 1, -2, 7, 0.125, 0, 0.5, 0.0625, -2.5, 4.125, 1, 7.0625)
    assert kernels.side(geometry(), 3, 1) == Side(-2, 7, 4, 1, 0.5, 0.0625, 0.125, 0, -2.5, 4.125, 1, 7.0625)
    wide = side_at((0, 0), (1, 1), (5, 6), (0.5, 0.25))
    assert wide[8:] == (-5, 5, -6, 6)


@pytest.mark.parametrize("signs", list(product((-1, 1), repeat=4)))
def test_an_edge_may_be_what_it_is_for_some_corners_of_the_boxes(signs):
    a, b = np.array([1.5, 3.25]) * signs[:2], np.array([2.5, 0.75]) * signs[2:]
    half_a, half_b = np.array([0.5, 0.0625]), np.array([0.25, 0.125])
    column, row = 1, -2
    low, high = kernels.edge(side_at(a, b, half_a, half_b), column, row)

    def value(ways):
        ax, ay = a + half_a * ways[:2] - (column, row)
        bx, by = b + half_b * ways[2:] - (column, row)
        return ax * by - ay * bx

    middle = value(np.zeros(4))
    farthest = {  # of the two products, which may be off each by itself
        (x, y): max(abs(each) for each in (apart(x, y, way) for way in product((-1, 1), repeat=2)))
        for x, y in (
            ((a[0] - column, half_a[0]), (b[1] - row, half_b[1])),
            ((a[1] - row, half_a[1]), (b[0] - column, half_b[0])),
        )
    }
    assert np.allclose((low, high), (middle - sum(farthest.values()), middle + sum(farthest.values())), ROUNDING, 1e-13)
    assert all(low <= value(np.array(ways)) <= high for ways in product((-1, 0, 1), repeat=4))


def apart(x, y, way):
    """How far a product of two numbers (middle, half) moves as they do."""
    return (x[0] + x[1] * way[0]) * (y[0] + y[1] * way[1]) - x[0] * y[0]


def test_an_edge_of_exact_corners_is_rounded():
    assert kernels.edge(side_at((3, 5), (2, 7)), 0, 0) == (11 - 31 * 2.0**-50, 11 + 31 * 2.0**-50)
    assert kernels.edge(side_at((4, 7), (3, 9)), 1, 2) == (11 - 31 * 2.0**-50, 11 + 31 * 2.0**-50)


def piece_at(corners, half=0.0, **others):
    there = Geometry(
        np.array(corners, float), np.full((3, 2), half), np.zeros(3), np.zeros(3), np.zeros((1, 2)), 1, 0, 0.0
    )
    primitives = SimpleNamespace(corners=np.array([(0, 1, 2)]))
    return kernels.loose_piece(primitives, there, 0)._replace(**others)


LEFT, RIGHT, TOP = (0, 0), (8, 0), (0, 8)
BAND = {  # sample: whether it may be covered, whether it must, the edges beside it (number k is opposite to corner k)
    (2, 2): (True, True, 0),
    (1, 0): (True, False, 0b100),
    (0, 1): (True, False, 0b010),
    (4, 4): (True, False, 0b001),
    (0, 0): (True, False, 0b110),
    (8, 0): (True, False, 0b101),
    (0, 8): (True, False, 0b011),
    (9, 0): (False, False, 0),
    (-1, 0): (False, False, 0),
    (0, 9): (False, False, 0),
    (9, -1): (False, False, 0),
    (5, 5): (False, False, 0),
    (2, -1): (False, False, 0),
}


@pytest.mark.parametrize("sample", BAND)
def test_what_exact_corners_cover_whichever_way_they_turn(sample):
    assert kernels.cover(piece_at([LEFT, RIGHT, TOP]), *sample) == BAND[sample]
    may, must, bits = BAND[sample]
    swapped = (bits & 0b001) | (bits & 0b010) << 1 | (bits & 0b100) >> 1  # corners 1 and 2 have changed places
    assert kernels.cover(piece_at([LEFT, TOP, RIGHT]), *sample) == (may, must, swapped)


@pytest.mark.parametrize(
    ("row", "expected"), [(-2, (False, False, 0)), (-1, (True, False, 0b100)), (1, (True, False, 0b100))]
)
def test_a_box_reaches_on_both_sides_of_an_edge(row, expected):
    assert kernels.cover(piece_at([(0, 0), (64, 0), (0, 64)], half=1.0), 8, row) == expected


def test_well_inside_its_boxes_a_piece_must_be_seen():
    assert kernels.cover(piece_at([(0, 0), (64, 0), (0, 64)], half=1.0), 8, 4) == (True, True, 0)


@pytest.mark.parametrize(
    ("sample", "expected"),
    [((-1, 0), True), ((4, 2), True), ((-1.25, 0), False), ((4.25, 0), False), ((0, -2.5), False), ((0, 2.5), False)],
)
def test_beside_a_side_is_between_its_boxes(sample, expected):
    side = side_at((0, 0), (3, 0), (1, 2), (1, 2))
    assert kernels.beside(side, *sample) == expected
    assert kernels.beside(side, -1, -2) and kernels.beside(side, 4, 2)


def test_which_columns_and_rows_are_reached():
    def both(half, size=10):
        boxes = geometry(np.array(half))
        return [kernels.reached(PRIMITIVES, boxes, 0, axis, size) for axis in (0, 1)]

    assert both(np.full((4, 2), 0.25)) == [(0, 4), (0, 3)]
    assert both(np.full((4, 2), 1.0)) == [(0, 5), (0, 4)]
    assert both(np.full((4, 2), 1.0), size=4) == [(0, 3), (0, 3)]
    assert [kernels.reached(PRIMITIVES, geometry(), 1, axis, 9) for axis in (0, 1)] == [(0, 4), (1, 7)]
    right = geometry()._replace(centre=CENTRE + 2.5)
    assert [kernels.reached(PRIMITIVES, right, 0, axis, 9) for axis in (0, 1)] == [(3, 6), (2, 5)]
    beside = geometry()._replace(centre=CENTRE - 50)
    first, last = kernels.reached(PRIMITIVES, beside, 0, 0, 9)
    assert first > last


@pytest.mark.parametrize(("vertex", "inverse_w"), [(0, 0.0), (1, -1.0), (2, np.nan)])
def test_a_piece_with_a_corner_behind_the_eye_reaches_nothing(vertex, inverse_w):
    behind = PRIMITIVES.inverse_w.copy()
    behind[vertex] = inverse_w
    piece = SimpleNamespace(corners=PRIMITIVES.corners, inverse_w=behind)
    assert kernels.reached(piece, geometry(), 0, 0, 10) == (0, -1)


def test_the_rounding_of_a_plane():
    """Along x its error is that of y times how wide the piece is."""
    assert np.isclose(kernels.plane_rounding(PRIMITIVES, geometry(), 0), 0.2 * 4 + 0.1 * 3, ROUNDING, 0)
    assert np.isclose(kernels.plane_rounding(PRIMITIVES, geometry(), 1), 0.7 * 6 + 0.3 * 6, ROUNDING, 0)


def test_the_depths_of_a_piece():
    found = kernels.depths_of(geometry(depth_step=0.125), 0, 1, 2, 4.0)
    assert found == Depths(0.25, 0.5, 0.125, 0.125, 0.5, 0.03 + (2.0**-22 + 0.125), 0.375 * 4)
    assert kernels.depths_of(geometry(), 2, 3, 0, 0.0).error == 0.5 + 2.0**-22
    nothing = geometry()._replace(depth_error=np.full(4, -1.0))
    assert kernels.depths_of(nothing, 0, 1, 2, 0.0).error == 2.0**-22


@pytest.mark.parametrize(("turn", "number", "seen_by"), [(0, 1, 0.0), (1, 1, 1.0), (-1, 1, -1.0), (-1, 0, 0.0)])
def test_a_loose_piece_has_the_sides_opposite_to_its_corners(turn, number, seen_by):
    there = geometry(turn=turn)
    a, b, c = PRIMITIVES.corners[number]
    found = kernels.loose_piece(PRIMITIVES, there, number)
    assert found.sides == (kernels.side(there, b, c), kernels.side(there, c, a), kernels.side(there, a, b))
    assert found.depths == kernels.depths_of(there, a, b, c, kernels.plane_rounding(PRIMITIVES, there, number))
    assert (found.turn, found.is_laid_out) == (seen_by, turn != 0)


def test_in_a_layout_the_turn_decides():
    assert kernels.key(LoosePiece((), Depths(*[0.0] * 7), -3.0, True), 1, 1) == (-3, -3)


def test_the_depth_at_a_sample_of_exact_corners():
    """At (1, 2) the corner areas are 5/8, 1/8 and 2/8 of the whole."""
    depths = Depths(0.5, 0.25, 0.75, 0.25, 0.75, 0.0, 0.0)
    low, high = kernels.key(piece_at([LEFT, RIGHT, TOP], depths=depths), 1, 2)
    assert np.allclose((low, high), 0.5 * 5 / 8 + 0.25 / 8 + 0.75 * 2 / 8, rtol=0, atol=1e-12) and low <= high
    rounded = depths._replace(error=0.125, plane_rounding=2.0)  # twice the area is 64
    low, high = kernels.key(piece_at([LEFT, RIGHT, TOP], depths=rounded), 1, 2)
    assert np.allclose((low, high), (0.53125 - 0.125 - 2 / 64, 0.53125 + 0.125 + 2 / 64), rtol=0, atol=1e-12)
    turned = Depths(0.5, 0.75, 0.25, 0.25, 0.75, 0.125, 2.0)
    assert np.allclose(kernels.key(piece_at([LEFT, TOP, RIGHT], depths=turned), 1, 2), (low, high), rtol=0, atol=1e-12)


def test_the_depth_at_a_sample_of_loose_corners():
    """A weight E_i that is off by r_i moves sum(E_i*a_i) / sum(E_i) by r_i*|a_i - a| / (sum(E_i) - sum(r_i))."""
    depths = Depths(0.5, 0.25, 0.75, 0.25, 0.75, 0.0, 0.0)
    loose = piece_at([LEFT, RIGHT, TOP], half=0.25, depths=depths)
    weights, off = np.array([kernels.middle(kernels.edge(side, 1, 2)) for side in loose.sides]).T
    at = np.array([0.5, 0.25, 0.75])
    depth = (weights * at).sum() / weights.sum()
    spread = (off * np.abs(at - depth)).sum() / (weights.sum() - off.sum())
    assert np.allclose(kernels.key(loose, 1, 2), (depth - spread, depth + spread), rtol=ROUNDING, atol=0)
    assert spread > 0.01


def test_of_a_sliver_the_depth_is_that_of_its_corners_and_as_much_beyond():
    depths = Depths(0.5, 0.25, 0.5, 0.25, 0.5, 0.0625, 9.0)
    assert kernels.key(piece_at([(0, 0), (4, 0), (8, 0)], depths=depths), 3, 0) == (-0.0625, 0.8125)


def test_the_middle_of_an_interval():
    assert kernels.middle((1.0, 4.0)) == (2.5, 1.5)
