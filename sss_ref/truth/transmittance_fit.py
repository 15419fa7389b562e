"""The power law x^y / d^p that comes nearest to what a slab lets through, and the exponential e^(-k*d) beside it."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sss_ref.truth.photon import TRANSMITTED, Volume
from sss_ref.truth.searchlight import diffusion_length
from sss_ref.truth.slab import slab

FloatArray = NDArray[np.float64]
BASE = 2.0  # x, as the presets have it
PAPER = 0.6  # the paper's exponent
STEPS = 2.0 ** (np.arange(-8, 5) / 2)  # thicknesses in diffusion lengths: a sixteenth to four
CERTAIN = 10.0  # standard errors that a share must be, to count


@dataclass(frozen=True, eq=False)
class TransmittanceFit:
    """T(d) of a slab lit from all sides, and the nearest laws. Worst: the largest |law / truth - 1| of a thickness."""

    thickness: FloatArray  # mm
    share: FloatArray  # T, of the light that has entered
    error: FloatArray  # its standard error
    factor: float  # of factor / max(d, d_min)^exponent, d in mm
    exponent: float
    d_min: float  # mm, below which the law stays what it is
    worst: float
    paper_at: float  # mm, where T falls as d^-0.6; nan where it nowhere does
    amplitude: float  # of amplitude * e^(-fading * d)
    fading: float  # per mm
    fading_worst: float

    def y(self, mm_per_unit: float) -> float:
        """The power of BASE that gives the factor, for thicknesses in scene units."""
        return math.log2(self.factor * mm_per_unit**-self.exponent)  # BASE is 2


def fitted_transmittance(
    volume: Volume, photons: int, threads: int | None = None, on_slab: Callable[[int, int], None] | None = None
) -> TransmittanceFit:
    """Walk so many photons through each of many slabs of a volume and fit T(d), by least squares of ln T.

    threads: all processors where it is None. on_slab(number, count) is told after each. Raises SceneError as `slab`.
    """
    found = []
    for number, step in enumerate(STEPS, start=1):
        thickness = float(step) * diffusion_length(volume)
        tally = slab(volume, thickness, photons, threads=threads)
        found.append((thickness, tally.share(TRANSMITTED), tally.share_error(TRANSMITTED)))
        if on_slab:
            on_slab(number, len(STEPS))
    thickness, share, error = np.array(found).T
    certain = share > CERTAIN * error
    d, logarithm = thickness[certain], np.log(share[certain])
    law = min((_power_law(d, logarithm, first) for first in range(len(d) - 2)), key=lambda each: each[-1])
    fading, height = _line(d, logarithm)
    paper_at, fading_worst = _falls_as_paper(d, logarithm), _worst(fading * d + height - logarithm)
    return TransmittanceFit(thickness, share, error, *law, paper_at, math.exp(height), -fading, fading_worst)


def _power_law(d: FloatArray, logarithm: FloatArray, first: int) -> tuple[float, float, float, float]:
    """Factor, exponent, d_min and the worst of the law that is fitted from one of the thicknesses on."""
    slope, height = _line(np.log(d[first:]), logarithm[first:])
    law = slope * np.log(np.maximum(d, d[first])) + height
    return math.exp(height), -slope, float(d[first]), _worst(law - logarithm)


def _line(x: FloatArray, y: FloatArray) -> tuple[float, float]:
    """Slope and height of the nearest line."""
    middle, mean = x.mean(), y.mean()
    slope = float(((x - middle) * (y - mean)).sum() / np.square(x - middle).sum())
    return slope, float(mean - slope * middle)


def _worst(logarithm_off: FloatArray) -> float:
    """The largest |law / truth - 1|."""
    return float(np.abs(np.expm1(logarithm_off)).max())


def _falls_as_paper(d: FloatArray, logarithm: FloatArray) -> float:
    """The thickness at which -d ln T / d ln d is the paper's exponent, between the middles of neighbouring ones."""
    falls = -np.diff(logarithm) / np.diff(np.log(d))
    middles = np.sqrt(d[1:] * d[:-1])
    if not falls.min() <= PAPER <= falls.max():
        return math.nan
    after = int(np.argmax(falls >= PAPER))
    if after == 0:
        return float(middles[0])
    share = (PAPER - falls[after - 1]) / (falls[after] - falls[after - 1])
    return float(middles[after - 1] * (middles[after] / middles[after - 1]) ** share)
