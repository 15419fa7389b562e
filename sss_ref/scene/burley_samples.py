"""Where normalized diffusion is sampled: a spiral, as dense at each radius as the widest channel's light is.

The share of light within r is C = 1 - (q^3 + 3*q)/4 with q = e^(-r/(3*d)). Sample i of n lies where C = (i + .5)/n: q
is found from the polynomial by halving, in float64, and r = -3*d*ln(q).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.numerics.elementary import log2_array
from sss_ref.numerics.trigonometry import cosine, sine
from sss_ref.scene_file.diffusion import Diffusion

HALVINGS = 60
LN_2 = 0.6931471805599453
GOLDEN_ANGLE = 137.50776405003785  # degrees: from one sample to the next


class Samples(NamedTuple):
    """Samples of a disc, from the inside out, float64."""

    distance: tuple[float, float, float]  # d of red, green and blue, mm
    place: NDArray[np.float64]  # (N, 2): shares of the outermost radius
    radius: NDArray[np.float64]  # (N,): mm
    area: NDArray[np.float64]  # (N,): one over the density of the samples there, times a number that all share


def burley_samples(diffusion: Diffusion) -> Samples:
    """The samples of a scene: where they lie is the same for all channels, what they weigh is not."""
    widest = max(diffusion.scatter_distance)
    shares = (np.arange(diffusion.samples) + 0.5) / diffusion.samples
    thirds = decay_within(shares)
    radius = (-3.0 * widest * LN_2) * log2_array(np.float32(thirds)).astype(np.float64)
    angles = [GOLDEN_ANGLE * number for number in range(diffusion.samples)]
    directions = np.array([(cosine(angle), sine(angle)) for angle in angles])
    area = widest * radius / (thirds * thirds * thirds + thirds)
    return Samples(diffusion.scatter_distance, directions * (radius / radius[-1])[:, None], radius, area)


def decay_within(shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """The e^(-r/(3*d)) of the radii within which these shares of the light leave, (N,)."""
    low, high = np.zeros_like(shares), np.ones_like(shares)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        beyond = (middle * middle * middle + 3.0 * middle) / 4 > 1.0 - shares
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return (low + high) / 2
