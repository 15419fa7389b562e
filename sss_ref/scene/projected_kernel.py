"""The kernel of the separable blur: a profile projected on a line, and gathered into taps (Jimenez et al. 2015).

Of a sum of Gaussians the projection is one too, a(x) = sum of w*e^(-x^2/(2*v))/sqrt(v), but for a factor that goes when
the weights are divided by their sum.
"""

from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.numerics.elementary import exp_array
from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.profiles import Gaussian

STEPS = 64  # of the sum over a tap's part of the line


class LineKernel(NamedTuple):
    """Taps along a line, from one end to the other, float64."""

    place: NDArray[np.float64]  # (N,): -1 to 1, shares of the reach
    weight: NDArray[np.float64]  # (N, 3): red, green and blue, of sum 1


def projected_kernel(diffusion: Diffusion) -> LineKernel:
    """The taps: denser where light is, each with what the projection has nearer to it than to its neighbours.

    With t from -1 to 1 in even steps a place is t*|t|. A weight is the integral of a(x) over the tap's part of the
    line, by the midpoint rule with STEPS steps, in float64 but for e^x, which is a float32.
    """
    turns = 2.0 * np.arange(diffusion.taps) / (diffusion.taps - 1) - 1.0
    place = turns * np.abs(turns)
    ends = np.concatenate([place[:1], (place[1:] + place[:-1]) / 2, place[-1:]]) * diffusion.reach_mm
    low, width = ends[:-1], (ends[1:] - ends[:-1]) / STEPS
    parts = [projected(diffusion.gaussians, low + width * (step + 0.5)) * width[:, None] for step in range(STEPS)]
    weight = reduce(np.add, parts)
    return LineKernel(place, weight / reduce(np.add, weight))


def projected(gaussians: tuple[Gaussian, ...], x: NDArray[np.float64]) -> NDArray[np.float64]:
    """What a sum of Gaussians has at places on a line, (N,) in mm, when it is projected on that: (N, 3), not scaled.

    Each channel's weights are divided by their sum first.
    """
    rows = np.array(gaussians, np.float64)
    weights = rows[:, 1:] / reduce(np.add, rows[:, 1:])
    terms = [
        weight / np.sqrt(variance) * exp_array(np.float32(-x * x / (2.0 * variance))).astype(np.float64)[:, None]
        for variance, weight in zip(rows[:, 0], weights, strict=True)
    ]
    return reduce(np.add, terms)
