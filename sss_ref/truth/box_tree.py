"""A tree of boxes over the triangles of a mesh, so that a ray asks few of them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
LEAF = 4  # triangles at most


class BoxTree(NamedTuple):
    """Boxes depth first: below an inner one come its two parts, and `beyond` is where to go on without looking inside.

    triangles: int64 (N, 2), the first and the one after the last triangle of a leaf, in the tree's own order; equal for
    an inner box. corner, edge1, edge2: (T, 3), a triangle's first corner and the ways to the other two, in that order.
    """

    low: FloatArray  # (N, 3)
    high: FloatArray  # (N, 3)
    beyond: IntArray  # (N,)
    triangles: IntArray  # (N, 2)
    corner: FloatArray
    edge1: FloatArray
    edge2: FloatArray


def box_tree_of(corners: FloatArray) -> BoxTree:
    """The tree of triangles (T, 3 corners, xyz): a box is cut at its middle triangle along its longest side."""
    low, high, centres = corners.min(axis=1), corners.max(axis=1), corners.mean(axis=1)
    boxes: list[tuple[IntArray, int, int]] = []  # members, depth, first place in the order
    beyond: list[int] = []
    waiting = [(np.arange(len(corners)), 0, 0)]
    while waiting:
        members, depth, first = waiting.pop()
        boxes.append((members, depth, first))
        if len(members) > LEAF:
            left, right = _halves(members, centres)
            waiting += [(right, depth + 1, first + len(left)), (left, depth + 1, first)]
    order = np.empty(len(corners), np.int64)
    ranges = np.zeros((len(boxes), 2), np.int64)
    for number, (members, _, first) in enumerate(boxes):
        if len(members) <= LEAF:
            order[first : first + len(members)] = members
            ranges[number] = first, first + len(members)
    beyond = _next_not_deeper([depth for _, depth, _ in boxes])
    bounds = np.array([(low[members].min(axis=0), high[members].max(axis=0)) for members, _, _ in boxes])
    a, b, c = np.ascontiguousarray(np.moveaxis(corners[order], 1, 0))
    return BoxTree(bounds[:, 0].copy(), bounds[:, 1].copy(), np.array(beyond), ranges, a, b - a, c - a)


def _halves(members: IntArray, centres: FloatArray) -> tuple[IntArray, IntArray]:
    """The members before and after the middle one along the longest side of their centres' box."""
    own = centres[members]
    axis = int(np.argmax(np.ptp(own, axis=0)))
    ordered = members[np.argsort(own[:, axis], kind="stable")]
    return ordered[: len(ordered) // 2], ordered[len(ordered) // 2 :]


def _next_not_deeper(depths: list[int]) -> list[int]:
    """For each box of a list depth first, the next that is not inside it; their number after the last."""
    found = [len(depths)] * len(depths)
    for number in range(len(depths) - 2, -1, -1):
        following = number + 1
        while following < len(depths) and depths[following] > depths[number]:
            following = found[following]
        found[number] = following
    return found
