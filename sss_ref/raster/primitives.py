"""From clip space to triangles that are ready to rasterize: clip, viewport transform, snap (rules R1 and R2)."""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled, part_of_kernels
from sss_ref.raster.clip import W, X, Y, Z, clip
from sss_ref.raster.coverage import position, twice_area
from sss_ref.raster.viewport import Viewport

ONE, HALF = np.float32(1), np.float32(0.5)
GUARD = np.float32(2**24)  # snapped units: edge functions of corners within +-2^24 stay below 2^53


class Primitives(NamedTuple):
    """Triangles ready to rasterize. Pieces are in scene order, pieces of one triangle consecutive.

    corners: int32 (P, 3), the vertex indices of each piece. triangle: int32 (P,), the scene triangle it comes from.
    snapped: int32 (V, 2), window position less half a pixel in 1/2^bits pixel: samples lie on multiples of 2^bits.
    depth: float32 (V,), window depth, 0 near to 1 far. inverse_w: float32 (V,), 1/w, or 0 for a vertex in no piece.
    attributes: float32 (V, A), what the fragments interpolate, each in its own unit.
    """

    corners: np.ndarray
    triangle: np.ndarray
    snapped: np.ndarray
    depth: np.ndarray
    inverse_w: np.ndarray
    attributes: np.ndarray


def assemble(
    clip_position: np.ndarray, attributes: np.ndarray, triangles: np.ndarray, viewport: Viewport
) -> Primitives:
    """Clip triangles, divide by w, map to the window and snap.

    clip_position: float32 (V, 4), finite; attributes: float32 (V, A); triangles: int32 (T, 3), vertex indices.
    Dropped, because nothing of them can be covered: pieces of area zero after the snap, and pieces with a corner at
    w <= 0 (the eye itself) or, where float32 overflows, beyond 2^24 snapped units. No culling: both sides are kept.
    """
    primitives, _ = place(clip_position, attributes, triangles, viewport)
    kept = drawable(primitives)
    return primitives if kept.all() else only(primitives, kept)


def place(
    clip_position: np.ndarray, attributes: np.ndarray, triangles: np.ndarray, viewport: Viewport
) -> tuple[Primitives, np.ndarray]:
    """All pieces, those too of which nothing can be covered, and the clip positions of their vertices, (V, 4)."""
    pieces = clip(clip_position, attributes, triangles)
    count = len(pieces.clip_position)
    snapped, depth = np.zeros((count, 2), np.int32), np.zeros(count, np.float32)
    inverse_w = np.zeros(count, np.float32)
    project(pieces.clip_position, (viewport.width, viewport.height, viewport.step), snapped, depth, inverse_w)
    placed = Primitives(pieces.corners, pieces.triangle, snapped, depth, inverse_w, pieces.attributes)
    return placed, pieces.clip_position


def only(primitives: Primitives, kept: np.ndarray) -> Primitives:
    """Some of the pieces, bool (P,), and all vertices."""
    return primitives._replace(corners=primitives.corners[kept], triangle=primitives.triangle[kept])


def drawable(primitives: Primitives) -> np.ndarray:
    """Bool (P,): the pieces with three corners that have a place in the window, and an area."""
    kept = np.empty(len(primitives.corners), np.bool_)
    find_drawable(primitives.corners, primitives.snapped, primitives.inverse_w, kept)
    return kept


@compiled
def project(clip_position, size, snapped, depth, inverse_w):
    """Fill in window positions (V, 2), window depths (V,) and 1/w (V,); 0 stays where a vertex cannot be placed.

    1/w, then x*(1/w), then *W/2 and +W/2, each rounded to float32; the snap rounds half to even.
    size: (width, height, step).
    """
    width, height, step = size
    for vertex in range(len(clip_position)):
        if not clip_position[vertex, W] > 0:
            continue
        inverse = ONE / clip_position[vertex, W]
        x = snap(clip_position[vertex, X] * inverse, width, step)
        y = snap(clip_position[vertex, Y] * inverse, height, step)
        if abs(x) <= GUARD and abs(y) <= GUARD:  # false for NaN too
            snapped[vertex, 0], snapped[vertex, 1] = np.int32(x), np.int32(y)
            depth[vertex] = HALF * (clip_position[vertex, Z] * inverse) + HALF
            inverse_w[vertex] = inverse


@part_of_kernels
def snap(ndc, size, step):
    """A normalised device coordinate in snapped units, still float32: the whole number nearest to its position."""
    half_size = np.float32(size) * HALF
    window = ndc * half_size + half_size
    return np.rint((window - HALF) * np.float32(step))


@compiled
def find_drawable(corners, snapped, inverse_w, kept):
    """Fill in which pieces (P,) have three corners with a place in the window and an area."""
    for piece in range(len(corners)):
        a, b, c = corners[piece]
        placed = inverse_w[a] > 0 and inverse_w[b] > 0 and inverse_w[c] > 0
        area = twice_area(position(snapped, a), position(snapped, b), position(snapped, c))
        kept[piece] = placed and area != 0
