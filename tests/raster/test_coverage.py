import numpy as np
import pytest

from sss_ref.raster.coverage import acceptance, at, covered_columns, edges, least, owns_its_samples
from sss_ref.raster.primitives import Primitives
from sss_ref.raster.rasterize import visibility
from sss_ref.raster.viewport import Viewport

STEP = 256


def flat(corners, samples):
    """Primitives at depth 1/2 whose vertices are given in pixels, counted from the centre of pixel (0, 0)."""
    snapped = np.rint(np.array(samples) * STEP).astype(np.int32)
    corners = np.array(corners, np.int32)
    ones = np.ones(len(snapped), np.float32)
    attributes = np.zeros((len(snapped), 0), np.float32)
    return Primitives(corners, np.arange(len(corners), dtype=np.int32), snapped, ones / 2, ones, attributes)


def covered(primitives, viewport):
    """How many pieces cover each sample, each piece drawn by itself, (H, W)."""
    count = np.zeros((viewport.height, viewport.width), int)
    for piece in range(len(primitives.corners)):
        alone = primitives._replace(corners=primitives.corners[piece : piece + 1])
        count += visibility(alone, viewport, None)[0] == 0
    return count


@pytest.mark.parametrize("corners", [(0, 1, 2), (1, 2, 0), (2, 1, 0), (0, 2, 1)])
def test_edge_functions_are_positive_inside_whichever_way_the_piece_turns(corners):
    primitives = flat([corners], [(0, 0), (4, 0), (0, 4)])
    e = [at(edge, 1, 2) for edge in edges(primitives, 0, STEP)]
    # the sample (1, 2) divides the area 16*step^2 as 4 : 4 : 8 of 16 over the corners 0, 1, 2
    assert e == [(4, 4, 8)[corner] * STEP * STEP for corner in corners]


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0)])
def test_left_and_minimum_row_edges_own_their_samples(corners):
    primitives = flat([corners], [(0, 0), (3, 0), (0, 3)])
    assert covered(primitives, Viewport(4, 4)).tolist() == [[1, 1, 1, 0], [1, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 0]]
    primitives = flat([corners], [(3, 3), (0, 3), (3, 0)])
    assert covered(primitives, Viewport(4, 4)).tolist() == [[0, 0, 0, 0], [0, 0, 1, 0], [0, 1, 1, 0], [0, 0, 0, 0]]


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0)])
@pytest.mark.parametrize("width", [47, 48, 49, 70])
def test_a_wide_piece_owns_its_left_and_its_lowest_samples(corners, width):
    """Between what is tried at every column of its box and what is first asked where in a row it lies."""
    viewport = Viewport(width + 2, 3)
    upright = covered(flat([corners], [(1, 0), (width, 0), (1, 2)]), viewport)
    assert upright.sum(axis=1).tolist() == [width - 1, width // 2, 0]
    assert upright[:2, 1].tolist() == [1, 1] and not upright[:, 0].any()
    turned = covered(flat([corners], [(width, 2), (1, 2), (width, 0)]), viewport)
    assert turned.sum(axis=1).tolist() == [0, (width - 1) // 2, 0]


@pytest.mark.parametrize("corners", [(0, 1, 2), (2, 1, 0)])
def test_the_smallest_piece_covers_a_sample_at_its_lowest_left_corner(corners):
    """Half a unit of the grid in area."""
    at_a_sample = [(1, 1), (1 + 1 / STEP, 1), (1, 1 + 1 / STEP)]
    assert covered(flat([corners], at_a_sample), Viewport(3, 2)).tolist() == [[0, 0, 0], [0, 1, 0]]


WIDE_ONES = [
    [(0, 0), (90, 0), (30, 60)],
    [(5, 50), (80, 50), (40, 3)],
    [(10, 2), (10, 70), (90, 30)],
    [(90, 2), (90, 70), (10, 30)],
    [(0.5, 0.5), (63.25, 7.125), (20.75, 55.5)],
    [(3, 3), (70, 4), (36, 5)],
    [(3, 40), (70, 40 + 1 / 256), (99, 40 + 2 / 256)],
    [(0, 9), (60, 10), (9, 50)],
    [(20, 40), (80, 41), (70, 2)],
]


@pytest.mark.parametrize("turn", [(0, 1, 2), (2, 1, 0), (1, 2, 0)])
@pytest.mark.parametrize("samples", WIDE_ONES)
@pytest.mark.parametrize("step", [STEP, 1])
def test_the_covered_columns_of_a_row_are_those_where_all_three_edges_accept(samples, turn, step):
    """By trying each: at corners and edges on samples, and in rows of which none is covered."""
    piece = flat([turn], samples)
    three = edges(piece._replace(snapped=piece.snapped // (STEP // step)), 0, step)
    for row in range(-1, 73):
        for first, last in ((0, 99), (12, 64), (40, 40)):
            tried = [k for k in range(first, last + 1) if all(at(each, k, row) >= least(each) for each in three)]
            low, high = covered_columns(tuple(map(acceptance, three)), row, first, last)
            assert list(range(low, high + 1)) == tried


def test_the_fill_rule_edge_by_edge():
    left, hypotenuse, bottom = edges(flat([(1, 0, 2)], [(0, 0), (3, 0), (0, 3)]), 0, STEP)
    assert [bool(owns_its_samples(edge)) for edge in (left, hypotenuse, bottom)] == [True, False, True]


def test_pieces_beyond_the_picture_do_not_wrap_round():
    viewport = Viewport(4, 3)
    around = [(-9, -9), (30, -9), (-9, 30)]
    left, right = [(-4, 0), (-1, 0), (-4, 9)], [(4, 0), (9, 0), (4, 9)]
    below, above = [(0, -4), (9, -1), (0, -1)], [(0, 3), (9, 3), (0, 9)]
    count = covered(flat(np.arange(15).reshape(5, 3), [*left, *right, *around, *below, *above]), viewport)
    assert (count == 1).all()


@pytest.mark.parametrize("bits", [4, 8])
@pytest.mark.parametrize("seed", range(8))
def test_a_triangulated_picture_covers_every_sample_once(seed, bits):
    size, cells = 48, 12
    rng = np.random.default_rng(seed)
    samples = np.stack(np.meshgrid(*[np.linspace(0, size, cells + 1)] * 2), axis=-1) - 0.5
    inner = samples[1:-1, 1:-1]
    inner += rng.uniform(-1, 1, inner.shape)
    on_a_sample = rng.random(inner.shape[:2]) < 0.4
    inner[on_a_sample] = np.rint(inner[on_a_sample])
    viewport = Viewport(size, size, subpixel_bits=bits)
    primitives = flat(triangulate(rng, cells), samples.reshape(-1, 2))
    primitives = primitives._replace(snapped=primitives.snapped // (STEP // viewport.step))
    assert (covered(primitives, viewport) == 1).all()


def triangulate(rng, cells):
    """A grid of (cells + 1)^2 vertices as triangles, diagonals, windings and first corners at random."""
    corner = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = corner[:-1, :-1].ravel(), corner[:-1, 1:].ravel(), corner[1:, 1:].ravel(), corner[1:, :-1].ravel()
    diagonal = rng.random(len(a)) < 0.5
    one = np.where(diagonal[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    other = np.where(diagonal[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return rng.permuted(np.concatenate([one, other]), axis=1)
