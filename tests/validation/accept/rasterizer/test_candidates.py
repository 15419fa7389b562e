"""Candidates in the order of their pixels, and which pieces they are: those of a loop over all pixels and pieces."""

from types import SimpleNamespace

import naive_raster
import numpy as np
import pytest
from plain_kernels import plain

from sss_ref.raster import coverage
from sss_ref.validation.accept.rasterizer import candidates as kernels
from sss_ref.validation.accept.rasterizer import loose_piece
from sss_ref.validation.accept.rasterizer.loose_piece import Geometry

WIDTH, HEIGHT, STEP = 6, 4, 16
CORNERS = np.array(  # in 1/16 pixel
    [
        *((0, 0), (80, 0), (0, 64)),  # three corners on samples
        *((-40, -40), (200, 8), (8, 200)),  # over all of the picture
        *((90, -20), (90, 70), (-8, 24)),  # clockwise
        *((16, 16), (48, 16), (32, 16)),  # a sliver along a row of samples
        *((33, 17), (35, 17), (33, 19)),  # between samples
    ],
    np.int32,
)
PIECES = np.arange(15).reshape(5, 3)
ULP = 2.0**-22  # by which a depth is rounded


@pytest.fixture
def as_python(monkeypatch):
    for module in (kernels, loose_piece, coverage):
        plain(module, monkeypatch)


def drawn(depths, turn=0, half=0.125, pieces=PIECES):
    """What kernels read of pieces whose corners lie in boxes; depths: one for each piece, or one for each corner."""
    count = len(CORNERS)
    depth = np.broadcast_to(np.array(depths, float).reshape(5, -1), (5, 3)).reshape(-1).astype(float)
    primitives = SimpleNamespace(corners=pieces, snapped=CORNERS, inverse_w=np.ones(count))
    there = Geometry(
        CORNERS / STEP, np.full((count, 2), half), depth, np.zeros(count), np.zeros((len(pieces), 2)), STEP, turn, 0.0
    )
    return primitives, there


def each_sample(primitives, geometry):
    """Of every piece at every sample within its boxes: its number, the sample, its cover, and its key."""
    for number, corners in enumerate(primitives.corners):
        piece = loose_piece.loose_piece(primitives, geometry, number)
        least = (geometry.centre - geometry.half)[corners].min(axis=0)
        most = (geometry.centre + geometry.half)[corners].max(axis=0)
        for row, column in np.ndindex(HEIGHT, WIDTH):
            if (least <= (column, row)).all() and (most >= (column, row)).all():
                yield number, column, row, loose_piece.cover(piece, column, row), loose_piece.key(piece, column, row)


def is_inside(corners, column, row):
    """Whether the oracle draws a piece with these corners at a sample: nothing of one without an area."""
    a, b, c = (naive_raster.Corner(*CORNERS[k].tolist(), 0, 0, []) for k in corners)
    covered, _ = naive_raster.covering((a, b, c), column * STEP, row * STEP)
    return covered is not None and naive_raster.side(a, b, c.x, c.y) != 0


def naive(primitives, geometry):
    """The nearest certain ends, (H, W), and the rows of the list of candidates."""
    nearest, found = np.full((HEIGHT, WIDTH), np.inf), []
    beyond = np.inf if geometry.turn else 1.0
    for _, column, row, (_, must, _), (_, high) in each_sample(primitives, geometry):
        if must and high < beyond:
            nearest[row, column] = min(nearest[row, column], high)
    for number, column, row, (may, must, band), (low, high) in each_sample(primitives, geometry):
        if may and low <= nearest[row, column] and low < beyond:
            inside = is_inside(primitives.corners[number], column, row)
            found.append((row * WIDTH + column, number, low, high, inside, must, band))
    return nearest, found


DRAWS = {
    "one behind the other": ([0.5, 0.75, 0.25, 0.125, 0.0625], 0),
    "crossing": ([(0.25, 0.75, 0.5), (0.75, 0.125, 0.25), (0.5, 0.25, 0.875), (0.0, 0.5, 0.25), (0.5, 0.5, 0.25)], 0),
    "on the far plane": ([1 - ULP, 1 + ULP, 1.0, 1 - 2 * ULP, 1 + 2 * ULP], 0),
    "the first of a layout": ([0.5] * 5, 1),
    "the last of a layout": ([2.0] * 5, -1),
}


@pytest.mark.parametrize("name", DRAWS)
def test_what_may_be_seen_is_found_and_listed_in_scene_order(as_python, name):
    primitives, geometry = drawn(*DRAWS[name])
    expected, listed = naive(primitives, geometry)
    nearest = np.full((HEIGHT, WIDTH), np.inf)
    kernels.find_nearest(primitives, geometry, nearest)
    assert np.array_equal(nearest, expected) and np.isfinite(nearest).any() == (name != "on the far plane")
    columns = kernels.list_candidates(primitives, geometry, nearest)
    assert [*zip(*(column.tolist() for column in columns), strict=True)] == listed
    types = (np.int64, np.int32, np.float64, np.float64, np.bool_, np.bool_, np.uint8)
    assert [column.dtype for column in columns] == [*types]
    assert {number for _, number, *_ in listed} >= {0, 2, 3} if name == "one behind the other" else listed


def test_what_lies_at_the_far_plane_is_not_drawn(as_python):
    """A depth that may be 1 and no less; and what ends there covers nothing for certain, but may be seen."""
    primitives, geometry = drawn(DRAWS["on the far plane"][0])
    keys = [(number, key) for number, *_, key in each_sample(primitives, geometry)]
    assert any(number == 1 and low == 1 for number, (low, _) in keys)
    assert any(number == 0 and high == 1 for number, (_, high) in keys)
    nearest = np.full((HEIGHT, WIDTH), np.inf)
    kernels.find_nearest(primitives, geometry, nearest)
    assert not np.isfinite(nearest).any() or nearest.max() < 1
    _, piece, *_ = kernels.list_candidates(primitives, geometry, nearest)
    assert 0 in piece and 1 not in piece and 4 not in piece


def test_of_a_layout_each_piece_has_its_turn(as_python):
    for turn in (1, -1):
        primitives, geometry = drawn([2.0] * 5, turn)
        nearest = np.full((HEIGHT, WIDTH), np.inf)
        kernels.find_nearest(primitives, geometry, nearest)
        _, piece, low, high, *_ = kernels.list_candidates(primitives, geometry, nearest)
        assert low.tolist() == high.tolist() == (turn * piece).tolist() and len(set(piece.tolist())) >= 2


def test_there_is_room_for_all_candidates_however_many(as_python):
    """Of 24 pixels more than 2048, all alike: the room grows twice."""
    primitives, geometry = drawn([0.5] * 5, pieces=np.tile([(3, 4, 5)], (90, 1)))
    columns = kernels.list_candidates(primitives, geometry, np.full((HEIGHT, WIDTH), np.inf))
    pixel, piece = columns[:2]
    assert piece.tolist() == np.repeat(np.arange(90), 24).tolist() and pixel.tolist() == [*range(24)] * 90
    assert all(len(column) == 90 * 24 for column in columns) and columns[5].all()


@pytest.mark.parametrize("first", range(3))
@pytest.mark.parametrize("number", range(5))
def test_a_sample_is_inside_by_the_rule_of_the_oracle(as_python, number, first):
    """Whichever corner is the first."""
    pieces = np.roll(PIECES, first, axis=1)
    primitives, _ = drawn([0.5] * 5, pieces=pieces)
    own_edges = coverage.edges(primitives, number, STEP)
    for row in range(-1, HEIGHT + 2):
        for column in range(-1, WIDTH + 1):
            assert kernels.is_inside(own_edges, column, row) == is_inside(pieces[number], column, row)


def test_candidates_of_a_pixel_lie_side_by_side_each_as_it_came(as_python):
    pixel = np.random.default_rng(5).integers(0, 40, 300)
    assert np.array_equal(kernels.by_pixel(pixel, 40), np.argsort(pixel, kind="stable"))
    assert len(kernels.by_pixel(pixel[:0], 40)) == 0
