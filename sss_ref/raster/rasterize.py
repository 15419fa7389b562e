"""Which piece each pixel sees: bins of rows, boxes of columns, a depth test (rules R3 and R4).

The picture is cut into bands of rows. A counting sort lists the pieces of each band in scene order, and a band is
drawn by one thread from its own list, so the result depends neither on the number of threads nor on the band height.
A pixel of a band is one whole number, its key: the depth of the nearest piece and, in the lower half, which one it is.
"""

from collections.abc import Callable, Iterable
from concurrent.futures import Executor
from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled, part_of_kernels
from sss_ref.cache.spare_memory import SPARE
from sss_ref.raster.coverage import acceptance, at, covered_columns, edges, least
from sss_ref.raster.primitives import Primitives
from sss_ref.raster.viewport import Viewport

BAND_ROWS = 32
PACK = 8  # columns that processors may compute side by side
WIDE = 48  # columns: of a piece so wide, what it covers of a row is found before depths are computed there
FIRST, LAST = 0, 2**31 - 1  # XOR a piece: its number in a key, where of several at the same depth this one stays
NOTHING = int(np.float32(1).view(np.int32)) << 32  # the key of the far plane, less than that of any piece there


class Bins(NamedTuple):
    """The pieces of band b, in scene order: members[start[b]:start[b + 1]] (int64 (B + 1,) and int32 (M,)).

    band_rows: rows of a band.
    """

    band_rows: int
    start: np.ndarray
    members: np.ndarray


class Target(NamedTuple):
    """What is drawn into, each (H, W).

    piece: the nearest, int32, -1 for none. depth: its window depth, float32, else 1.
    """

    piece: np.ndarray
    depth: np.ndarray


def visibility(
    primitives: Primitives, viewport: Viewport, pool: Executor | None, bins: Bins | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """The visible piece of each pixel, int32 (H, W), -1 where there is none, and its depth, float32 (H, W), else 1.

    pool: what the bands are spread over; None draws them in this thread. bins: what `bin_pieces` gives, if that is done
    already; no bit depends on either. The nearest piece wins (LESS), of two at the same depth the earlier.
    """
    shape = (viewport.height, viewport.width)
    target = Target(SPARE.empty(shape, np.int32), SPARE.empty(shape, np.float32))
    draw(primitives, bins or bin_pieces(primitives, viewport), (viewport.subpixel_bits, FIRST), pool, target)
    return target


def first_and_last(
    primitives: Primitives, viewport: Viewport, pool: Executor | None, bins: Bins | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What `visibility` gives, and between the two the visible piece where of two at the same depth the later wins."""
    bins = bins or bin_pieces(primitives, viewport)
    first, depth = visibility(primitives, viewport, pool, bins)
    last = Target(SPARE.empty(first.shape, np.int32), depth)  # which is the same again
    draw(primitives, bins, (viewport.subpixel_bits, LAST), pool, last)
    return first, last.piece, depth


def draw(primitives: Primitives, bins: Bins, rules: tuple[int, int], pool: Executor | None, target: Target) -> None:
    """Draw all pieces into a target; rules: (subpixel bits, FIRST or LAST: which of several at one depth stays)."""

    def one(band: int) -> None:
        height, width = target.depth.shape
        rows = min(bins.band_rows, height - band * bins.band_rows)
        keys = np.full((rows, width + PACK), NOTHING, np.int64)
        draw_band(primitives, bins, band, rules, keys, target)

    run: Callable[..., Iterable[None]] = map if pool is None else pool.map
    for _ in run(one, range(len(bins.start) - 1)):
        pass


def bin_pieces(primitives: Primitives, viewport: Viewport, band_rows: int = BAND_ROWS) -> Bins:
    """Sort the pieces into the bands they touch (counting sort, which keeps their order)."""
    band_of_row = np.arange(viewport.height) // band_rows
    counts, bands = np.zeros(band_of_row[-1] + 2, np.int64), np.empty((len(primitives.corners), 2), np.int32)
    count_members(primitives, band_of_row, viewport.subpixel_bits, bands, counts[1:])
    start = np.cumsum(counts)
    members = np.empty(start[-1], np.int32)
    list_members(bands, start.copy(), members)
    return Bins(band_rows, start, members)


@compiled
def count_members(primitives, band_of_row, bits, bands, counts):
    """Fill in the bands of each piece, (P, 2), from the first to one past the last; add to their `counts`, (B,)."""
    for piece in range(len(primitives.corners)):
        first, last = sampled(primitives, piece, 1, len(band_of_row), bits)
        begin, end = (band_of_row[first], band_of_row[last] + 1) if first <= last else (0, 0)
        bands[piece, 0], bands[piece, 1] = begin, end
        for band in range(begin, end):
            counts[band] += 1


@compiled
def list_members(bands, following, members):
    """Write each piece into `members` where its bands go on: following (int64) starts as the bands' first places."""
    for piece in range(len(bands)):
        for band in range(bands[piece, 0], bands[piece, 1]):
            members[following[band]] = piece
            following[band] += 1


@part_of_kernels
def sampled(primitives, piece, axis, size, bits):
    """The columns (axis 0) or rows (axis 1) of the picture whose samples the piece can reach: (first, last)."""
    corners, snapped = primitives.corners, primitives.snapped
    a = np.int64(snapped[corners[piece, 0], axis])
    b = np.int64(snapped[corners[piece, 1], axis])
    c = np.int64(snapped[corners[piece, 2], axis])
    first = -(-min(a, b, c) >> bits)
    return max(first, 0), min(max(a, b, c) >> bits, size - 1)


@compiled
def draw_band(primitives, bins, band, rules, keys, target):
    """Draw the pieces of one band; rules: as in `draw`.

    keys: NOTHING at each pixel of the band, int64, and in PACK columns behind them.
    """
    width = target.depth.shape[1]
    bits, order = rules
    first_row = band * bins.band_rows
    for k in range(bins.start[band], bins.start[band + 1]):
        piece = bins.members[k]
        draw_piece(primitives, piece, bits, (first_row, width), keys, order ^ piece)
    for row in range(len(keys)):
        take_pieces(keys[row], order, target.piece[first_row + row])
        take_depths(keys[row], target.depth[first_row + row])


@part_of_kernels
def draw_piece(primitives, piece, bits, place, keys, number):
    """Draw one piece into the keys of a band; place: (first row, width); number: what a key says of the piece."""
    first_row, width = place
    first_column, last_column = sampled(primitives, piece, 0, width, bits)
    bottom, top = sampled(primitives, piece, 1, first_row + len(keys), bits)
    weights, corner_depths = edges(primitives, piece, 1 << bits), depths(primitives, piece)
    acceptances = acceptance(weights[0]), acceptance(weights[1]), acceptance(weights[2])
    for row in range(max(bottom, first_row), top + 1):
        columns = first_column, last_column
        if last_column - first_column >= WIDE:
            columns = covered_columns(acceptances, row, first_column, last_column)
        draw_columns(keys[row - first_row], row, columns, weights, corner_depths, number)


@part_of_kernels
def draw_columns(keys, row, columns, edges, depths, number):
    """Draw a piece into the columns columns[0]..columns[1] of a row, and try those behind them up to a whole PACK.

    So a piece is tried at all columns of its box: that takes less than to find out where in a short row it begins.
    """
    first, last = columns
    start_0, start_1, start_2 = at(edges[0], 0, row), at(edges[1], 0, row), at(edges[2], 0, row)
    total = edges[0].constant + edges[1].constant + edges[2].constant  # of e0, e1 and e2, at every sample the same
    for k in range((last - first + PACK) // PACK * PACK):
        column = np.float64(np.int32(first + k))
        e0 = start_0 + column * edges[0].per_column
        e1 = start_1 + column * edges[1].per_column
        e2 = start_2 + column * edges[2].per_column
        covered = (e0 >= least(edges[0])) & (e1 >= least(edges[1])) & (e2 >= least(edges[2]))
        key = key_of(window_depth((e0, e1, e2), depths, total), number)
        place = np.uint64(first + k)  # as it is never below 0, no element is counted from the end
        there = keys[place]
        keys[place] = key if covered & (key < there) else there


@part_of_kernels
def key_of(depth, number):
    """Depth, rounded to float32, and number of a piece as one int64: less is nearer, or as near and less in number.

    The bits of a float32 that is not negative, as a whole number, are in its own order.
    """
    return np.int64(np.float32(depth).view(np.int32)) << 32 | number


@part_of_kernels
def take_pieces(keys, order, pieces):
    """The pieces of some keys, int32, -1 for none; order: FIRST or LAST."""
    for column in range(len(pieces)):
        key = keys[column]
        pieces[column] = np.int32(-1) if key == NOTHING else np.int32((key & LAST) ^ order)


@part_of_kernels
def take_depths(keys, depths):
    """The depths of some keys, float32."""
    for column in range(len(depths)):
        depths[column] = np.int32(keys[column] >> 32).view(np.float32)


@part_of_kernels
def depths(primitives, piece):
    """The window depths of a piece's corners, as float64."""
    corners, depth = primitives.corners, primitives.depth
    return (
        np.float64(depth[corners[piece, 0]]),
        np.float64(depth[corners[piece, 1]]),
        np.float64(depth[corners[piece, 2]]),
    )


@part_of_kernels
def window_depth(weights, depths, total):
    """((z0*e0 + z1*e1) + z2*e2) / (e0 + e1 + e2) in float64, clamped to [0, 1] (rule R4)."""
    depth = ((depths[0] * weights[0] + depths[1] * weights[1]) + depths[2] * weights[2]) / total
    return 0.0 if depth < 0.0 else (1.0 if depth > 1.0 else depth)
