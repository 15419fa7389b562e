"""Rays against the triangles of a mesh, in float64 (compiled): where the nearest is, and how far a ray is inside.

A triangle is met as by Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
"""

import math

from sss_ref.cache.compiled import compiled

NO_TRIANGLE = -1
STEEPEST = 1e300  # instead of 1/0: no product with a distance is without meaning
ROUNDING = 1.0 + 4e-16  # a box is left no sooner than it is, three roundings at most


@compiled
def nearest(tree, origin, direction, limit, inwards):
    """The nearest triangle within a distance at which a ray goes inside, or outside: (distance, triangle).

    (limit, NO_TRIANGLE) where there is none. Since a ray is asked for one of the two alone, the triangle that it starts
    on is not met again, nor one beside it on whose edge it starts.
    """
    inverse = steepness(direction[0]), steepness(direction[1]), steepness(direction[2])
    found, box = NO_TRIANGLE, 0
    while box < len(tree.beyond):
        if not meets(tree, box, origin, inverse, limit):
            box = tree.beyond[box]
            continue
        for triangle in range(tree.triangles[box, 0], tree.triangles[box, 1]):
            distance, determinant = crossing(tree, triangle, origin, direction)
            if 0.0 <= distance < limit and (determinant > 0.0) == inwards:
                limit, found = distance, triangle
        box += 1
    return limit, found


@compiled
def inside_length(tree, origin, direction, limit):
    """How far a ray from a point inside goes through the body up to a distance; less than 0 where that is not known.

    The distances at which it leaves less those at which it comes in again. Not known: it does not leave once more often
    than it comes in, since it passes between two triangles or along one.
    """
    inverse = steepness(direction[0]), steepness(direction[1]), steepness(direction[2])
    total, balance, box = 0.0, 0, 0
    while box < len(tree.beyond):
        if not meets(tree, box, origin, inverse, limit):
            box = tree.beyond[box]
            continue
        for triangle in range(tree.triangles[box, 0], tree.triangles[box, 1]):
            distance, determinant = crossing(tree, triangle, origin, direction)
            if 0.0 <= distance < limit:
                outwards = determinant < 0.0
                total += distance if outwards else -distance
                balance += 1 if outwards else -1
        box += 1
    return total if balance == 1 else -1.0


@compiled
def steepness(component):
    """1 / component, or as much as can be computed with."""
    return 1.0 / component if abs(component) > 1.0 / STEEPEST else STEEPEST


@compiled
def meets(tree, box, origin, inverse, limit):
    """Whether a ray may meet a box within a distance."""
    enters, leaves = 0.0, limit
    for axis in range(3):
        one = (tree.low[box, axis] - origin[axis]) * inverse[axis]
        other = (tree.high[box, axis] - origin[axis]) * inverse[axis]
        enters = max(enters, min(one, other))
        leaves = min(leaves, max(one, other) * ROUNDING)
    return enters <= leaves


@compiled
def crossing(tree, triangle, origin, direction):
    """The distance to a triangle, less than 0 if it is not met, and a number above 0 where the ray goes inside."""
    ax, ay, az = tree.edge1[triangle, 0], tree.edge1[triangle, 1], tree.edge1[triangle, 2]
    bx, by, bz = tree.edge2[triangle, 0], tree.edge2[triangle, 1], tree.edge2[triangle, 2]
    dx, dy, dz = direction
    px, py, pz = dy * bz - dz * by, dz * bx - dx * bz, dx * by - dy * bx
    determinant = ax * px + ay * py + az * pz
    if determinant == 0.0:
        return -1.0, determinant
    sx = origin[0] - tree.corner[triangle, 0]
    sy = origin[1] - tree.corner[triangle, 1]
    sz = origin[2] - tree.corner[triangle, 2]
    u = (sx * px + sy * py + sz * pz) / determinant
    qx, qy, qz = sy * az - sz * ay, sz * ax - sx * az, sx * ay - sy * ax
    v = (dx * qx + dy * qy + dz * qz) / determinant
    if u < 0.0 or v < 0.0 or u + v > 1.0:
        return -1.0, determinant
    return (bx * qx + by * qy + bz * qz) / determinant, determinant


@compiled
def normal(tree, triangle):
    """The unit normal of a triangle, outwards."""
    ax, ay, az = tree.edge1[triangle, 0], tree.edge1[triangle, 1], tree.edge1[triangle, 2]
    bx, by, bz = tree.edge2[triangle, 0], tree.edge2[triangle, 1], tree.edge2[triangle, 2]
    x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, z / length
