"""Where the energy of a small bright disc comes to lie after diffusion, for a profile in rings and for taps.

Spread by weights at distances, a disc of radius f has within a circle of radius r around its middle the sum of the
weights times the share of a disc at that distance which the circle covers: no picture is made, so none has a size.
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def covered(distance: FloatArray, disc: float, circle: float) -> FloatArray:
    """The share of discs, their middles at these distances from that of a circle, which the circle covers; radii in mm.

    The area of a lens: two sectors less the kite between them.
    """
    small = min(disc, circle)
    apart = np.clip(distance, abs(disc - circle), disc + circle)
    with np.errstate(invalid="ignore", divide="ignore"):  # where one lies in the middle of the other
        first = np.arccos(np.clip((apart**2 + disc**2 - circle**2) / (2 * apart * disc), -1, 1))
        second = np.arccos(np.clip((apart**2 + circle**2 - disc**2) / (2 * apart * circle), -1, 1))
    kite = (disc + circle - apart) * (apart + disc - circle) * (apart - disc + circle) * (apart + disc + circle)
    lens = disc**2 * first + circle**2 * second - np.sqrt(np.maximum(kite, 0)) / 2
    whole = math.pi * small * small
    area = np.where(distance <= abs(disc - circle), whole, np.where(distance >= disc + circle, 0, lens))
    return np.asarray(area / (math.pi * disc * disc))


def energy_within(distances: FloatArray, weights: FloatArray, disc: float, circles: Sequence[float]) -> FloatArray:
    """The share of a disc's energy within each circle, once weights at these distances have spread it."""
    flat, given = distances.ravel(), weights.ravel()
    return np.array([float((given * covered(flat, disc, circle)).sum()) for circle in circles])


def separable(offsets: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Distances and weights of a kernel that is laid along x and then along y: every pair of its taps."""
    return np.hypot(offsets[:, np.newaxis], offsets), weights[:, np.newaxis] * weights


def strip_shares(radii: FloatArray, shares: FloatArray, half_widths: FloatArray) -> FloatArray:
    """The share of a profile in rings that lies within strips |x| < w: of a ring at r it is 2/pi * asin(w/r)."""
    with np.errstate(divide="ignore"):
        sines = np.minimum(1.0, half_widths[:, np.newaxis] / radii)
    return np.asarray((shares * (2 / math.pi) * np.arcsin(sines)).sum(axis=1))
