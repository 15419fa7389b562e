"""Normalized diffusion: the fit of Christensen and Burley, "Approximate Reflectance Profiles" (Pixar, 2015).

R(r) = A * (e^(-r/w) + e^(-r/(3*w))) / (8 * pi * w * r), with w = l / s, the mean free path l and, for a beam straight
down, s = 1.85 - A + 7 * |A - .8|^3 of the reflectance A.
"""

import math
from typing import NamedTuple

HALVINGS = 200  # of a bisection, to the last bit
FARTHEST = 1e4  # times the width: beyond it there is nothing


class BurleyFit(NamedTuple):
    """The profile of a reflectance, for a beam straight down into a half-space."""

    reflectance: float  # A, 0 to 1
    width: float  # w, mm

    def within(self, radius: float) -> float:
        """The share of what leaves that does so within a radius, mm: 1 - e^(-r/w)/4 - 3*e^(-r/(3*w))/4."""
        x = radius / self.width
        return 1 - math.exp(-x) / 4 - 3 * math.exp(-x / 3) / 4

    def quantile(self, share: float) -> float:
        """The radius, mm, within which this share leaves."""
        low, high = 0.0, FARTHEST * self.width
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if self.within(middle) < share else (low, middle)
        return high


def burley_fit(reflectance: float, mean_free_path: float) -> BurleyFit:
    """The fit for a reflectance A and a `mean_free_path` 1 / (scattering + absorption), mm."""
    s = 1.85 - reflectance + 7 * abs(reflectance - 0.8) ** 3
    return BurleyFit(reflectance, mean_free_path / s)
