"""Which piece each pixel sees: bins of rows, spans of columns, a depth test (rules R3 and R4).

The picture is cut into bands of rows. A counting sort lists the pieces of each band in scene order, and a band is
drawn by one thread from its own list, so the result depends neither on the number of threads nor on the band height.
"""

from collections.abc import Callable, Iterable
from concurrent.futures import Executor
from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.cache.spare_memory import SPARE
from sss_ref.raster.coverage import acceptance, at, covered_columns, edges
from sss_ref.raster.primitives import Primitives
from sss_ref.raster.viewport import Viewport

BAND_ROWS = 32
FAR = np.float32(1)


class Bins(NamedTuple):
    """The pieces of band b, in scene order: members[start[b]:start[b + 1]] (int64 (B + 1,) and int32 (M,))."""

    start: np.ndarray
    members: np.ndarray


class Target(NamedTuple):
    """What is drawn into, each (H, W).

    piece: the nearest, int32, -1 for none; of several at the same depth the first. last: of these the last; has no rows
    where nobody asks for it. depth: their window depth, float32.
    """

    piece: np.ndarray
    last: np.ndarray
    depth: np.ndarray


def visibility(
    primitives: Primitives, viewport: Viewport, pool: Executor | None, band_rows: int = BAND_ROWS
) -> tuple[np.ndarray, np.ndarray]:
    """The visible piece of each pixel, int32 (H, W), -1 where there is none, and its depth, float32 (H, W), else 1.

    pool: what the bands are spread over; None draws them in this thread. band_rows: rows of a band; no bit depends on
    either. The nearest piece wins (LESS), of two at the same depth the earlier.
    """
    target = drawn(primitives, viewport, pool, band_rows, last_rows=0)
    return target.piece, target.depth


def first_and_last(
    primitives: Primitives, viewport: Viewport, pool: Executor | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What `visibility` gives, and between the two the visible piece where of two at the same depth the later wins."""
    target = drawn(primitives, viewport, pool, BAND_ROWS, last_rows=viewport.height)
    return target.piece, target.last, target.depth


def drawn(primitives: Primitives, viewport: Viewport, pool: Executor | None, band_rows: int, last_rows: int) -> Target:
    """The target with all pieces drawn into it; last_rows: those of its `last`, all or none."""
    shape = (viewport.height, viewport.width)
    last = SPARE.empty((last_rows, viewport.width), np.int32)
    target = Target(SPARE.empty(shape, np.int32), last, SPARE.empty(shape, np.float32))
    bins = bin_pieces(primitives, viewport.height, viewport.step, band_rows)

    def draw(band: int) -> None:
        draw_band(primitives, bins, (band, band_rows), viewport.step, target)

    run: Callable[..., Iterable[None]] = map if pool is None else pool.map
    for _ in run(draw, range(len(bins.start) - 1)):
        pass
    return target


def bin_pieces(primitives: Primitives, height: int, step: int, band_rows: int) -> Bins:
    """Sort the pieces into the bands they touch (counting sort, which keeps their order)."""
    counts = np.zeros((height - 1) // band_rows + 2, np.int64)
    count_members(primitives, (height, step, band_rows), counts[1:])
    start = np.cumsum(counts)
    members = np.empty(start[-1], np.int32)
    list_members(primitives, (height, step, band_rows), start.copy(), members)
    return Bins(start, members)


@compiled
def count_members(primitives, rows, counts):
    """Add to `counts` (int64 (B,)) how many pieces touch each band; rows: (height, step, rows of a band)."""
    height, step, band_rows = rows
    for piece in range(len(primitives.corners)):
        first, last = sampled(primitives, piece, 1, height, step)
        for band in range(first // band_rows, last // band_rows + 1):
            counts[band] += 1


@compiled
def list_members(primitives, rows, following, members):
    """Write each piece into `members` where its bands go on: following (int64) starts as the bands' first places."""
    height, step, band_rows = rows
    for piece in range(len(primitives.corners)):
        first, last = sampled(primitives, piece, 1, height, step)
        for band in range(first // band_rows, last // band_rows + 1):
            members[following[band]] = piece
            following[band] += 1


@compiled
def sampled(primitives, piece, axis, size, step):
    """The columns (axis 0) or rows (axis 1) of the picture whose samples the piece can reach: (first, last)."""
    corners, snapped = primitives.corners, primitives.snapped
    a = np.int64(snapped[corners[piece, 0], axis])
    b = np.int64(snapped[corners[piece, 1], axis])
    c = np.int64(snapped[corners[piece, 2], axis])
    first = -(-min(a, b, c) // step)
    return max(first, 0), min(max(a, b, c) // step, size - 1)


@compiled
def draw_band(primitives, bins, place, step, target):
    """Clear the rows of one band, then draw its pieces in scene order; place: (band, rows of a band)."""
    band, band_rows = place
    first_row = band * band_rows
    last_row = min(first_row + band_rows, len(target.depth)) - 1
    target.piece[first_row : last_row + 1] = -1
    target.last[first_row : last_row + 1] = -1
    target.depth[first_row : last_row + 1] = FAR
    for k in range(bins.start[band], bins.start[band + 1]):
        draw_piece(primitives, bins.members[k], (first_row, last_row), step, target)


@compiled
def draw_piece(primitives, piece, rows, step, target):
    """Draw one piece into the rows rows[0]..rows[1]."""
    height, width = target.depth.shape
    first_column, last_column = sampled(primitives, piece, 0, width, step)
    bottom, top = sampled(primitives, piece, 1, height, step)
    weights = edges(primitives, piece, step)
    acceptances = acceptance(weights[0]), acceptance(weights[1]), acceptance(weights[2])
    corner_depths, keeps_last = depths(primitives, piece), len(target.last) > 0
    for row in range(max(bottom, rows[0]), min(top, rows[1]) + 1):
        first, last = covered_columns(acceptances, row, first_column, last_column)
        for column in range(first, last + 1):
            depth = window_depth(weights, corner_depths, column, row)
            there = target.depth[row, column]
            if depth < there:
                target.depth[row, column] = depth
                target.piece[row, column] = piece
            if keeps_last and depth <= there and target.piece[row, column] >= 0:
                target.last[row, column] = piece


@compiled
def depths(primitives, piece):
    """The window depths of a piece's corners, as float64."""
    corners, depth = primitives.corners, primitives.depth
    return (
        np.float64(depth[corners[piece, 0]]),
        np.float64(depth[corners[piece, 1]]),
        np.float64(depth[corners[piece, 2]]),
    )


@compiled
def window_depth(edges, depths, column, row):
    """((z0*e0 + z1*e1) + z2*e2) / (e0 + e1 + e2) in float64, clamped to [0, 1], then rounded once (rule R4)."""
    e0, e1, e2 = at(edges[0], column, row), at(edges[1], column, row), at(edges[2], column, row)
    total = edges[0].constant + edges[1].constant + edges[2].constant  # of e0, e1 and e2, at every sample the same
    depth = ((depths[0] * e0 + depths[1] * e1) + depths[2] * e2) / total
    clamped = 0.0 if depth < 0.0 else (1.0 if depth > 1.0 else depth)
    return np.float32(clamped)
