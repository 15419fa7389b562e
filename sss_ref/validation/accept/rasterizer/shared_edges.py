"""Where a sample is covered for certain though no single piece is: between pieces that share the edge beside it.

Take the pieces that meet at edges which may pass on either side of a sample. As the corners move in their boxes, the
number of them that cover the sample changes by an even number at an edge of two (one loses what the other wins, or both
win or lose at a silhouette), and by an odd one at a rim. So where there is no rim, an odd number stays odd, and the
sample is covered by one of them, wherever the corners are.
"""

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.validation.accept.rasterizer.boxes import Boxes
from sss_ref.validation.accept.rasterizer.candidates import FAR, Candidates

MOST = 64  # candidates of one pixel that are looked at; what is shared with a further one is taken for a rim


def certain_ends(boxes: Boxes, found: Candidates, turn: int, pixels: int) -> np.ndarray:
    """The far end of the nearest cover that is certain at each pixel, float64 (pixels,): infinite where none is."""
    ends = np.full(pixels, np.inf)
    limit = np.inf if turn else FAR
    find_certain(found, boxes.primitives.corners, boxes.same, limit, ends)
    return ends


@compiled
def find_certain(found, corners, places, limit, ends):
    """Lower `ends` to the far end of each certain cover that lies in front of the limit."""
    first, group, edges = 0, np.empty(MOST, np.int64), np.empty((MOST, 3), np.int64)
    while first < len(found.pixel):
        last = first
        while last < len(found.pixel) and found.pixel[last] == found.pixel[first]:
            last += 1
        end, alone = np.inf, True
        for k in range(first, last):
            if found.certain[k]:
                end = min(end, found.high[k])
            alone = alone and found.certain[k]
        if not alone:  # nobody but pieces that are uncertain by themselves make a group that is certain
            end = min(end, nearest_group(found, corners, places, first, min(last, first + MOST), group, edges))
        if end < limit:
            ends[found.pixel[first]] = end
        first = last


@compiled
def nearest_group(found, corners, places, first, last, group, edges):
    """The far end of the nearest group of pieces that together cover the sample; infinite if there is none."""
    count = last - first
    for i in range(count):
        group[i] = i
        for k in range(3):
            edges[i, k] = edge_number(found, corners, places, first + i, k)
    for i in range(count):
        for j in range(i):
            if shares(edges, i, j):
                merge(group, count, group[i], group[j])
    nearest = np.inf
    for name in range(count):
        inside, rim, end = False, False, -np.inf
        for i in range(count):
            if group[i] == name and not found.certain[first + i]:
                inside = inside != found.inside[first + i]
                rim = rim or has_rim(edges, count, i)
                end = max(end, found.high[first + i])
        if inside and not rim:
            nearest = min(nearest, end)
    return nearest


@compiled
def edge_number(found, corners, places, index, k):
    """A number for an edge that may lie on either side of the sample, the same from both its pieces; else -1."""
    if not found.band[index] & (1 << k):
        return -1
    a = places[corners[found.piece[index], (k + 1) % 3]]
    b = places[corners[found.piece[index], (k + 2) % 3]]
    return (min(a, b) << 32) | max(a, b)


@compiled
def shares(edges, i, j):
    """Whether two pieces have such an edge in common."""
    for k in range(3):
        for other in range(3):
            if edges[i, k] >= 0 and edges[i, k] == edges[j, other]:
                return True
    return False


@compiled
def merge(group, count, name, other):
    """Make one group of two."""
    for i in range(count):
        if group[i] == name:
            group[i] = other


@compiled
def has_rim(edges, count, i):
    """Whether an edge of a piece belongs to an odd number of the pieces here."""
    rim = False
    for k in range(3):
        if edges[i, k] >= 0:
            same = 0
            for j in range(count):
                for other in range(3):
                    same += edges[j, other] == edges[i, k]
            rim = rim or same % 2 == 1
    return rim
