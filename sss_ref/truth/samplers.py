"""What a walk draws: free paths and directions, from + - * / sqrt and compares alone, so the same bits everywhere.

Directions are tuples (x, y, z) of float64.
"""

import math

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.random_numbers import uniform


@compiled
def exponential(stream):
    """A number with density e^-t: von Neumann, "Various Techniques Used in Connection With Random Digits" (1951).

    A run of falling numbers that ends after an odd count gives its first one; each even run before it adds 1.
    """
    whole = 0.0
    while True:
        first = uniform(stream)
        last, count = first, 1
        following = uniform(stream)
        while following < last:
            last = following
            count += 1
            following = uniform(stream)
        if count % 2 == 1:
            return whole + first
        whole += 1.0


@compiled
def in_disc(stream):
    """A point of the unit disc and its squared distance q from the middle, which is uniform: (a, b, q), q > 0."""
    while True:
        a, b = 2.0 * uniform(stream) - 1.0, 2.0 * uniform(stream) - 1.0
        q = a * a + b * b
        if q < 1.0:
            return a, b, q


@compiled
def cosine_direction(stream):
    """A direction about +z with density cos/pi: a point of the disc, lifted onto the hemisphere (Malley)."""
    a, b, q = in_disc(stream)
    return a, b, math.sqrt(1.0 - q)


@compiled
def scattered(stream, direction, anisotropy):
    """The direction after a scattering by Henyey and Greenstein (1941), anisotropy g the mean cosine.

    cos = (1 + g^2 - ((1 - g^2)/(1 + g - 2*g*q))^2) / (2*g); for g = 0 it is 1 - 2*q (Marsaglia 1972).
    """
    a, b, q = in_disc(stream)
    if anisotropy == 0.0:
        spread = 2.0 * math.sqrt(1.0 - q)
        return a * spread, b * spread, 1.0 - 2.0 * q
    square = anisotropy * anisotropy
    share = (1.0 - square) / (1.0 + anisotropy - 2.0 * anisotropy * q)
    cosine = (1.0 + square - share * share) / (2.0 * anisotropy)
    spread = math.sqrt(max(0.0, 1.0 - cosine * cosine) / q)
    return about(direction, (a * spread, b * spread, cosine))


@compiled
def about(axis, direction):
    """A direction given about +z, turned so that it is about a unit axis.

    The frame is that of Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 2017).
    """
    x, y, z = axis
    sign = 1.0 if z >= 0.0 else -1.0
    a = -1.0 / (sign + z)
    b = x * y * a
    u, v, w = direction
    return (
        (1.0 + sign * x * x * a) * u + b * v + x * w,
        sign * b * u + (sign + y * y * a) * v + y * w,
        -sign * x * u - y * v + z * w,
    )


@compiled
def reflectance(cosine, ior):
    """How much of unpolarised light is reflected where it meets a smooth border (Fresnel).

    cosine: between its direction and the normal, 0 to 1. ior: the index of refraction where it comes from, divided by
    that beyond. 1 where it cannot leave.
    """
    squared_sine = ior * ior * (1.0 - cosine * cosine)
    if squared_sine >= 1.0:
        return 1.0
    beyond = math.sqrt(1.0 - squared_sine)
    across = (ior * cosine - beyond) / (ior * cosine + beyond)
    along = (cosine - ior * beyond) / (cosine + ior * beyond)
    return 0.5 * (across * across + along * along)
