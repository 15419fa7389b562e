"""Cutting triangles at the view volume, -w <= x, y, z <= w in clip space (rule R1).

A triangle whose three corners pass all six tests is left alone. Any other is cut by the six planes one after the
other (Sutherland and Hodgman 1974), in float32, and the polygon that remains becomes a fan around its first vertex.
"""

from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled, part_of_kernels

PLUS, MINUS, ONE = np.float32(1), np.float32(-1), np.float32(1)
X, Y, Z, W = 0, 1, 2, 3

# distance = w + sign*coordinate, inside where it is >= 0; the order of the planes is part of the rule
PLANES = ((X, MINUS), (X, PLUS), (Y, MINUS), (Y, PLUS), (Z, PLUS), (Z, MINUS))

# A cut leaves at most 3/2 of the vertices, be the polygon convex or, by rounding, not quite: 3, 4, 6, 9, 13, 19, 28.
MOST_VERTICES = 28


class Pieces(NamedTuple):
    """What lies inside the view volume; triangles keep their order, pieces of one triangle are consecutive.

    corners: int32 (P, 3), vertex indices. triangle: int32 (P,), the triangle each piece comes from.
    clip_position: float32 (V, 4); attributes: float32 (V, A): the given vertices, then those of the cut polygons.
    """

    corners: np.ndarray
    triangle: np.ndarray
    clip_position: np.ndarray
    attributes: np.ndarray


def clip(clip_position: np.ndarray, attributes: np.ndarray, triangles: np.ndarray) -> Pieces:
    """Cut triangles (int32 (T, 3)) at the view volume; attributes (float32 (V, A)) are cut like positions (V, 4)."""
    order = np.arange(len(triangles), dtype=np.int32)
    inside, whole = np.empty(len(clip_position), np.bool_), np.empty(len(triangles), np.bool_)
    find_whole(clip_position, triangles, inside, whole)
    if whole.all():
        return Pieces(triangles, order, clip_position, attributes)
    sizes, vertices = cut_triangles(clip_position, attributes, triangles[~whole])

    pieces = np.ones(len(triangles), np.int64)
    pieces[~whole] = np.maximum(sizes - 2, 0)
    triangle = np.repeat(order, pieces)
    corners = triangles[triangle]
    corners[~whole[triangle]] = len(clip_position) + fans(sizes)
    return Pieces(
        corners,
        triangle,
        np.concatenate([clip_position, vertices[:, :4]]),
        np.concatenate([attributes, vertices[:, 4:]]),
    )


def fans(sizes: np.ndarray) -> np.ndarray:
    """The triangles (first, k, k + 1) of polygons with `sizes` vertices each, stored one after the other: (N, 3)."""
    pieces = np.maximum(sizes - 2, 0)
    first = np.repeat(np.cumsum(sizes) - sizes, pieces)
    k = np.arange(pieces.sum()) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    return np.stack([first, first + k + 1, first + k + 2], axis=1)


@compiled
def find_whole(clip_position, triangles, inside, whole):
    """Fill in which vertices (V,) pass all six tests, and which triangles (T,) have three such corners."""
    for vertex in range(len(clip_position)):
        inside[vertex] = is_inside(clip_position[vertex])
    for triangle in range(len(triangles)):
        a, b, c = triangles[triangle]
        whole[triangle] = inside[a] and inside[b] and inside[c]


@part_of_kernels
def is_inside(vertex):
    """Whether a clip position passes all six tests."""
    inside = True
    for plane in PLANES:
        inside = inside and distance(vertex, plane) >= 0
    return inside


@part_of_kernels
def distance(vertex, plane):
    """How far a vertex lies inside a plane (below 0: outside), in clip space units."""
    axis, sign = plane
    return vertex[W] + sign * vertex[axis]


@compiled
def cut_triangles(clip_position, attributes, triangles):
    """Cut triangles by all planes: the polygons' sizes, int64 (T,), and their vertices, float32 (M, 4 + A).

    A vertex is a row x, y, z, w, attributes, because a cut treats them all alike.
    """
    channels = 4 + attributes.shape[1]
    sizes = np.empty(len(triangles), np.int64)
    vertices = np.empty((MOST_VERTICES + 4 * len(triangles), channels), np.float32)
    polygon, spare = np.empty((MOST_VERTICES, channels), np.float32), np.empty((MOST_VERTICES, channels), np.float32)
    used = 0
    for triangle in range(len(triangles)):
        for k in range(3):
            polygon[k, :4] = clip_position[triangles[triangle, k]]
            polygon[k, 4:] = attributes[triangles[triangle, k]]
        size = cut_by_all_planes(polygon, spare)
        if used + size > len(vertices):
            vertices = np.concatenate((vertices, np.empty_like(vertices)))
        vertices[used : used + size] = polygon[:size]
        sizes[triangle] = size
        used += size
    return sizes, vertices[:used]


@part_of_kernels
def cut_by_all_planes(polygon, spare):
    """Cut the triangle in polygon[:3] and return the number of vertices left in `polygon`; `spare` is overwritten."""
    size = 3
    for plane in PLANES:  # their number is even, so the last cut writes to `polygon` again
        size = cut(polygon, size, plane, spare)
        if size == 0:
            break
        polygon, spare = spare, polygon
    return size


@part_of_kernels
def cut(polygon, size, plane, kept):
    """Write the part of a polygon inside one plane to `kept` and return its size.

    Vertex after vertex: the vertex itself if it is inside, then the new one if the edge to the next vertex crosses.
    """
    count = 0
    for k in range(size):
        here, there = polygon[k], polygon[k + 1 if k + 1 < size else 0]
        here_distance, there_distance = distance(here, plane), distance(there, plane)
        if here_distance >= 0:
            kept[count] = here
            count += 1
        if (here_distance >= 0) != (there_distance >= 0):
            if is_nearer(here_distance, there_distance):
                cross(here, there, here_distance, there_distance, kept[count])
            else:
                cross(there, here, there_distance, here_distance, kept[count])
            count += 1
    return count


@part_of_kernels
def is_nearer(distance, other):
    """Whether the first of two vertices on either side of a plane is the nearer; on a tie, whether it is inside.

    A tie means t = 1/2, where either order gives the same bits unless the sum of the distances overflows.
    """
    return abs(distance) < abs(other) or (abs(distance) == abs(other) and distance >= 0)


@part_of_kernels
def cross(near, far, near_distance, far_distance, vertex):
    """Where an edge meets a plane: mix(near, far, t), the position and every attribute alike.

    Starting from the nearer vertex, not from the one that comes first, gives both triangles of a shared edge the same
    bits and keeps t <= 1/2.
    """
    t = near_distance / (near_distance - far_distance)
    for k in range(len(vertex)):
        vertex[k] = near[k] * (ONE - t) + far[k] * t
