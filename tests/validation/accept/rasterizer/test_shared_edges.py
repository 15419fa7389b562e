"""Covers that are certain though no piece of them is, on candidates put together by hand."""

import numpy as np
import pytest
from plain_kernels import plain

from sss_ref.validation.accept.rasterizer import shared_edges as kernels
from sss_ref.validation.accept.rasterizer.candidates import Candidates

CORNERS = np.array([(0, 1, 2), (2, 1, 3), (2, 3, 4), (5, 6, 7), (0, 2, 8)])  # a strip of three, one alone, and one more
PLACES = np.arange(9)
ACROSS = {  # of each piece its edge (as a bit) towards others: opposite to the corner that those have not
    (0, 1): 0b001,
    (1, 0): 0b100,
    (1, 2): 0b010,
    (2, 1): 0b100,
    (0, 4): 0b010,
    (4, 0): 0b100,
}


@pytest.fixture(autouse=True)
def as_python(monkeypatch):
    plain(kernels, monkeypatch)


def candidates(*each):
    """Of (pixel, piece, high, inside, certain, band)."""
    pixel, piece, high, inside, certain, band = (np.array(column) for column in zip(*each, strict=True))
    return Candidates(pixel, piece, high - 0.01, high, inside, certain, band.astype(np.uint8))


def ends(*each, limit=1.0, pixels=4, places=PLACES):
    found = np.full(pixels, np.inf)
    kernels.find_certain(candidates(*each), CORNERS, places, limit, found)
    return found.tolist()


NOWHERE = np.inf


def test_a_certain_piece_covers_by_itself():
    assert ends((2, 0, 0.5, True, True, 0)) == [NOWHERE, NOWHERE, 0.5, NOWHERE]
    assert ends((0, 0, 0.5, True, True, 0), (0, 3, 0.25, True, True, 0))[0] == 0.25
    assert ends((0, 3, 0.25, True, True, 0), (0, 0, 0.5, True, True, 0))[0] == 0.25
    assert ends((0, 3, 0.25, True, False, 0b111), (0, 0, 0.5, True, True, 0))[0] == 0.5


@pytest.mark.parametrize(("high", "limit", "end"), [(0.5, 0.5, NOWHERE), (0.5, 0.75, 0.5), (2.0, NOWHERE, 2.0)])
def test_what_is_not_in_front_of_the_limit_covers_nothing(high, limit, end):
    assert ends((0, 0, high, True, True, 0), limit=limit)[0] == end


def pair(pixel, inside, highs=(0.25, 0.75), bands=(ACROSS[0, 1], ACROSS[1, 0])):
    return [
        (pixel, piece, high, piece in inside, False, band)
        for piece, (high, band) in enumerate(zip(highs, bands, strict=True))
    ]


def test_one_of_two_with_an_edge_in_common_covers():
    """The farther one may be the one that does."""
    for inside in ((0,), (1,)):
        assert ends(*pair(1, inside))[1] == 0.75
        assert ends(*pair(1, inside, highs=(0.75, 0.25)))[1] == 0.75


@pytest.mark.parametrize("inside", [(), (0, 1)])
def test_none_or_both_of_two_may_lose_the_sample(inside):
    assert ends(*pair(1, inside))[1] == NOWHERE


@pytest.mark.parametrize(
    "bands",
    [(0b001, 0b010), (0b010, 0b100), (0b011, 0b100), (0b001, 0b110), (0, 0b100), (0b001, 0), (0b101, 0b101)],
)
def test_an_edge_of_one_alone_is_a_rim(bands):
    found = ends(*pair(1, (0,), bands=bands))[1]
    assert found == (0.25 if bands == (0, 0b100) else NOWHERE)


def test_a_piece_without_an_edge_beside_the_sample_is_a_group_of_its_own():
    assert ends((0, 3, 0.5, True, False, 0))[0] == 0.5
    assert ends((0, 3, 0.5, False, False, 0))[0] == NOWHERE


def test_of_three_in_a_row_an_odd_number_covers():
    strip = [(0, ACROSS[0, 1]), (1, ACROSS[1, 0] | ACROSS[1, 2]), (2, ACROSS[2, 1])]
    for inside in ((0,), (1,), (2,), (0, 1, 2)):
        each = [(3, piece, 0.1 + piece / 4, piece in inside, False, band) for piece, band in strip]
        assert ends(*each)[3] == 0.6
        assert ends(*each[::-1])[3] == 0.6
        assert ends(each[0], each[2], each[1])[3] == 0.6
    for inside in ((), (0, 1), (1, 2), (0, 2)):
        assert ends(*((3, piece, 0.5, piece in inside, False, band) for piece, band in strip))[3] == NOWHERE


def test_the_nearest_of_two_groups_counts():
    near = [(0, 3, 0.125, True, False, 0)]
    assert ends(*pair(0, (0,)), *near)[0] == 0.125
    assert ends(*near, *pair(0, (0,), highs=(0.05, 0.0625)))[0] == 0.0625
    assert ends((0, 3, 0.125, False, False, 0), *pair(0, (0,)))[0] == 0.75


def test_a_certain_piece_is_no_part_of_a_group_but_its_edges_are_no_rim():
    """Piece 0 covers for certain, far away; piece 1 shares an edge with it and may cover in front of it."""
    far = (0, 0, 0.9, True, True, ACROSS[0, 1])
    assert ends(far, (0, 1, 0.5, True, False, ACROSS[1, 0]))[0] == 0.5
    assert ends(far, (0, 1, 0.5, False, False, ACROSS[1, 0]))[0] == 0.9


def test_each_pixel_has_its_own_groups():
    """What two pixels have does not make one group."""
    first, second = pair(1, (0,))
    assert ends(first, (2, *second[1:])) == [NOWHERE] * 4
    assert ends(*pair(0, (0,)), *pair(1, (0, 1)), *pair(3, (1,), highs=(0.5, 0.25))) == [0.75, NOWHERE, NOWHERE, 0.5]


def test_vertices_at_one_place_are_one():
    """A seam: piece 3 has vertices of its own where piece 0 has 1 and 2."""
    seam = [(0, 0, 0.25, True, False, 0b001), (0, 3, 0.5, False, False, 0b001)]
    assert ends(*seam)[0] == NOWHERE
    assert ends(*seam, places=np.array([0, 1, 2, 3, 4, 5, 1, 2, 8]))[0] == 0.5


def test_the_number_of_an_edge_has_no_way_and_is_that_of_one_side():
    found = candidates(*pair(0, (0,)))
    places = PLACES + 10
    assert kernels.edge_number(found, CORNERS, places, 0, 0) == (11 << 32) | 12
    assert kernels.edge_number(found, CORNERS, places, 1, 2) == (11 << 32) | 12
    assert [kernels.edge_number(found, CORNERS, places, 0, k) for k in (1, 2)] == [-1, -1]
    whole = candidates((0, 1, 0.5, True, False, 0b111))
    numbers = [kernels.edge_number(whole, CORNERS, places, 0, k) for k in range(3)]
    assert numbers == [(11 << 32) | 13, (12 << 32) | 13, (11 << 32) | 12]


@pytest.mark.parametrize(("count", "end"), [(kernels.MOST, 0.5), (kernels.MOST + 1, NOWHERE)])
def test_more_than_so_many_candidates_of_a_pixel_are_not_looked_at(count, end):
    """Pieces that nothing is inside of, and at last one that covers without an edge beside the sample."""
    others = [(0, 3, 0.25, False, False, 0)] * (count - 1)
    assert kernels.MOST == 64 and ends(*others, (0, 0, 0.5, True, False, 0))[0] == end
