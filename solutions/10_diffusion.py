"""Solutions of lesson 10."""

import math

from sss_ref.truth.chandrasekhar import half_space_reflectance


def free_path(chance, extinction):
    """The length after which the share that still goes straight is the random number."""
    return -math.log(chance) / extinction


def photons_needed(share, relative):
    """sqrt(p (1 - p) / n) / p is the relative error."""
    return (1 - share) / share / relative**2


def albedo_of(reflectance):
    """Bisection: the curve rises."""
    low, high = 0.0, 1 - 1e-9
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if half_space_reflectance(middle) < reflectance else (low, middle)
    return high
