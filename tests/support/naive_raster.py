"""The rasterization rules R1 to R5, read as plainly as possible: one triangle, one plane, one pixel at a time.

Imports nothing of the package. Numbers are Python integers, Fractions, Python floats (float64) or np.float32 scalars;
a vertex in clip space is a list [x, y, z, w, attribute, attribute, ...] of np.float32.
"""

from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np

F = np.float32
GUARD = 2**24


@dataclass
class Corner:
    """A vertex in the window: snapped position, window depth, 1/w, attributes."""

    x: int
    y: int
    depth: np.float32
    inverse_w: np.float32
    attributes: list


@dataclass
class Fragment:
    """A sample covered by a piece (its number among all pieces)."""

    piece: int
    column: int
    row: int
    depth: np.float32
    attributes: list


@dataclass
class Drawn:
    """One triangle: its pieces, its fragments, the planes that cross it, whether a sample lay on an edge."""

    pieces: list = field(default_factory=list)
    fragments: list = field(default_factory=list)
    planes: set = field(default_factory=set)
    on_edge: bool = False


def plane_distances(vertex):
    x, y, z, w = vertex[:4]
    return [w - x, w + x, w - y, w + y, w + z, w - z]


def clip(triangle, planes):
    """R1: a polygon in clip space; the numbers of the planes that cross it are added to `planes`."""
    if all(d >= 0 for vertex in triangle for d in plane_distances(vertex)):
        return triangle
    polygon = triangle
    for plane in range(6):
        result = []
        for k, here in enumerate(polygon):
            there = polygon[(k + 1) % len(polygon)]
            a, b = plane_distances(here)[plane], plane_distances(there)[plane]
            if a >= 0:
                result.append(here)
            if (a >= 0) != (b >= 0):
                result.append(crossing(here, a, there, b) if a >= 0 else crossing(there, b, here, a))
                planes.add(plane)
        polygon = result
    return polygon


def crossing(inside, a, outside, b):
    """The new vertex, mixed from the vertex nearer the plane (on a tie the inside one)."""
    if -b < a:
        return mix(outside, inside, b / (b - a))
    return mix(inside, outside, a / (a - b))


def mix(near, far, t):
    return [p * (F(1) - t) + q * t for p, q in zip(near, far, strict=True)]


def to_window(vertex, width, height, bits):
    """R2: the corner in the window, or None where w <= 0 or float32 has no place for it."""
    x, y, z, w = vertex[:4]
    if w <= 0:
        return None
    inverse_w = F(1) / w
    window_x = (x * inverse_w) * F(width / 2) + F(width / 2)
    window_y = (y * inverse_w) * F(height / 2) + F(height / 2)
    try:
        snapped = [round(Fraction(float(v - F(0.5))) * 2**bits) for v in (window_x, window_y)]  # half to even
    except (OverflowError, ValueError):  # infinity, NaN
        return None
    if max(abs(snapped[0]), abs(snapped[1])) > GUARD:
        return None
    return Corner(*snapped, F(0.5) * (z * inverse_w) + F(0.5), inverse_w, vertex[4:])


def side(p, q, x, y):
    """Twice the signed area of corners p, q and the point (x, y)."""
    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)


def edge_owns(p, q, opposite):
    """R3: whether the edge p-q of a triangle is a left edge, or a horizontal edge at its minimum row."""
    if p.y == q.y:
        return p.y < opposite.y
    edge_x = p.x + Fraction((opposite.y - p.y) * (q.x - p.x), q.y - p.y)
    return edge_x < opposite.x


def covering(piece, x, y):
    """R3: (e0, e1, e2), all >= 0, where the piece covers the sample, else None; and whether it lies on an edge."""
    a, b, c = piece
    on_edge, e = False, []
    for p, q, opposite in ((b, c, a), (c, a, b), (a, b, c)):
        area, whole = side(p, q, x, y), side(p, q, opposite.x, opposite.y)
        if area * whole < 0:
            return None, False
        if area == 0:
            on_edge = True
            if not edge_owns(p, q, opposite):
                e.append(None)
                continue
        e.append(abs(area))
    return (None if None in e else e), on_edge


def window_depth(piece, e):
    """R4, in float64."""
    z = [float(corner.depth) for corner in piece]
    e0, e1, e2 = (float(v) for v in e)
    depth = ((z[0] * e0 + z[1] * e1) + z[2] * e2) / (e0 + e1 + e2)
    return F(min(max(depth, 0.0), 1.0))


def interpolate(piece, e):
    """R5, in float32."""
    w0, w1, w2 = (F(v) * corner.inverse_w for v, corner in zip(e, piece, strict=True))
    corner_attributes = zip(*(corner.attributes for corner in piece), strict=True)
    return [((a0 * w0 + a1 * w1) + a2 * w2) / ((w0 + w1) + w2) for a0, a1, a2 in corner_attributes]


def draw(triangle, width, height, bits, first_piece=0):
    """Everything about one triangle (three vertices); its pieces are numbered from first_piece."""
    drawn, step = Drawn(), 2**bits
    polygon = [to_window(vertex, width, height, bits) for vertex in clip(triangle, drawn.planes)]
    for k in range(1, len(polygon) - 1):
        piece = [polygon[0], polygon[k], polygon[k + 1]]
        if None in piece or side(piece[0], piece[1], piece[2].x, piece[2].y) == 0:
            continue
        number = first_piece + len(drawn.pieces)
        drawn.pieces.append(piece)
        columns = range(max(0, min(c.x for c in piece) // step), min(width - 1, max(c.x for c in piece) // step) + 1)
        rows = range(max(0, min(c.y for c in piece) // step), min(height - 1, max(c.y for c in piece) // step) + 1)
        for row in rows:
            for column in columns:
                e, on_edge = covering(piece, column * step, row * step)
                drawn.on_edge |= on_edge
                if e is not None:
                    fragment = Fragment(number, column, row, window_depth(piece, e), interpolate(piece, e))
                    drawn.fragments.append(fragment)
    return drawn


def resolve(fragments, width, height):
    """The depth test: the nearest fragment of each pixel, in float32, or None; on a tie the one that came first."""
    picture = {}
    for fragment in fragments:
        pixel = fragment.column, fragment.row
        nearest = picture[pixel].depth if pixel in picture else F(1)
        if fragment.depth < nearest:
            picture[pixel] = fragment
    return [[picture.get((column, row)) for column in range(width)] for row in range(height)]
