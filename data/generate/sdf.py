"""Signed distance functions: the clay from which a shipped mesh is modelled.

A field is a float array over sample points: negative inside, positive outside, zero on the surface, in the length
unit of the points, which have shape (3, ...). Far from the surface a field may be off in size, never in sign.
The formulas are Inigo Quilez's, "Distance functions" and "Smooth minimum" (iquilezles.org). For generation only:
nothing here feeds a rendered buffer.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

Points = np.ndarray  # (3, ...)
Field = np.ndarray  # (...)
Vector = Sequence[float] | np.ndarray  # x, y, z


def from_origin(points: Points, origin: Vector) -> Points:
    """Return the points as seen from `origin`."""
    return np.stack([axis - start for axis, start in zip(points, origin, strict=True)])


def dot(points: Points, direction: Vector) -> Field:
    """Return the dot product of every point with one direction."""
    x, y, z = direction
    return points[0] * x + points[1] * y + points[2] * z


def norm(points: Points) -> Field:
    """Return every point's distance from the origin."""
    return np.sqrt(points[0] * points[0] + points[1] * points[1] + points[2] * points[2])


def half_space(points: Points, origin: Vector, normal: Vector) -> Field:
    """Everything behind the plane through `origin` whose unit `normal` points out of the body."""
    return dot(from_origin(points, origin), normal)


def ellipsoid(points: Points, centre: Vector, radii: Vector) -> Field:
    """Ellipsoid with axes along x, y, z: k0 (k0 - 1) / k1, the first-order distance to the implicit surface."""
    offset = from_origin(points, centre)
    once = np.stack([axis / radius for axis, radius in zip(offset, radii, strict=True)])
    twice = np.stack([axis / radius for axis, radius in zip(once, radii, strict=True)])
    k0, k1 = norm(once), norm(twice)
    return k0 * (k0 - 1) / np.maximum(k1, 1e-6)


def rounded_cone(points: Points, start: Vector, end: Vector, radii: tuple[float, float]) -> Field:
    """Capsule from `start` to `end` whose radius runs from one to the other (for equal radii: a capsule, exactly)."""
    axis = np.subtract(end, start)
    offset = from_origin(points, start)
    t = np.clip(dot(offset, axis) / float(axis @ axis), 0, 1)
    nearest = offset - np.stack([t * step for step in axis])
    return norm(nearest) - (radii[0] + (radii[1] - radii[0]) * t)


def tube(points: Points, knots: Sequence[Vector], steps: int = 8) -> Field:
    """Tube along a Catmull-Rom spline; a knot is (x, y, z, radius), and the spline passes through every knot."""
    path = catmull_rom(np.asarray(knots, float), steps)
    field = np.full(points.shape[1:], np.inf, points.dtype)
    for start, end in pairwise(path):
        np.minimum(field, rounded_cone(points, start[:3], end[:3], (start[3], end[3])), out=field)
    return field


def catmull_rom(knots: np.ndarray, steps: int) -> np.ndarray:
    """Sample the uniform Catmull-Rom spline through `knots`, shape (n, any), at `steps` values a span and its end."""
    ends = np.vstack([2 * knots[0] - knots[1], knots, 2 * knots[-1] - knots[-2]])
    p0, p1, p2, p3 = (ends[i : len(ends) - 3 + i, None] for i in range(4))
    t = (np.arange(steps) / steps)[:, None]
    spans = p1 + 0.5 * t * ((p2 - p0) + t * ((2 * p0 - 5 * p1 + 4 * p2 - p3) + t * (3 * (p1 - p2) + p3 - p0)))
    return np.vstack([spans.reshape(-1, knots.shape[1]), knots[-1]])


def smooth_union(a: Field, b: Field, radius: float) -> Field:
    """Union whose seam is filled over about `radius`: min(a, b) - h^2 radius / 4, h = max(1 - |a - b| / radius, 0)."""
    h = np.maximum(1 - np.abs(a - b) / radius, 0)
    return np.minimum(a, b) - h * h * (radius / 4)


def smooth_intersection(a: Field, b: Field, radius: float) -> Field:
    """Intersection with its edge rounded over about `radius`."""
    return -smooth_union(-a, -b, radius)


def smooth_subtraction(a: Field, b: Field, radius: float) -> Field:
    """The body `a` without `b`, the rim rounded over about `radius`."""
    return smooth_intersection(a, -b, radius)


def smooth_mirror(points: Points, radius: float) -> Points:
    """Fold the half x < 0 onto x > 0: x becomes sqrt(x^2 + radius^2), so no crease is left on the symmetry plane."""
    return np.stack([np.sqrt(points[0] * points[0] + radius * radius), points[1], points[2]])
