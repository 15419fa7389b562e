"""The sum of six Gaussians that comes nearest to where a material's light leaves again.

A Gaussian of variance v has within a radius r the share 1 - e^(-r^2/(2*v)). The variances are in the same ratio each to
the next; the weights of a channel are the likeliest for the photons of its rings.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sss_ref.scene_file.profiles import Gaussian
from sss_ref.truth.searchlight import RadialProfile

FloatArray = NDArray[np.float64]
COUNT = 6  # as d'Eon and Luebke (2007) have it
NEAREST, FARTHEST = 0.03, 0.98  # shares of the light: the radii within which these leave span the variances
ROUNDS = 500  # of Richardson and Lucy
DIGITS = 6  # of a weight


@dataclass(frozen=True)
class GaussianFit:
    """Rows (v, red, green, blue), v in mm^2, and how far off each channel is."""

    rows: tuple[Gaussian, ...]  # each channel's weights have the sum 1
    misplaced: tuple[float, ...]  # the largest difference of the light within a radius


def fitted_gaussians(profiles: Sequence[RadialProfile]) -> GaussianFit:
    """Fit one sum to the profiles of red, green and blue."""
    variances = _variances(profiles)
    weights = np.array([_likeliest(profile, variances) for profile in profiles])
    misplaced = tuple(_misplaced(*each, variances) for each in zip(profiles, weights, strict=True))
    rows = (
        (float(f"{v:.4g}"), *(round(float(weight), DIGITS) for weight in row))
        for v, row in zip(variances, weights.T, strict=True)
    )
    return GaussianFit(tuple((v, red, green, blue) for v, red, green, blue in rows), misplaced)


def _variances(profiles: Sequence[RadialProfile]) -> FloatArray:
    """From the one half of whose square the narrowest channel's light leaves within, to the widest channel's."""
    low = min(profile.quantile(NEAREST) for profile in profiles)
    high = max(profile.quantile(FARTHEST) for profile in profiles)
    ends = low**2 / (-2 * np.log1p(-NEAREST)), high**2 / (-2 * np.log1p(-FARTHEST))
    return np.asarray(np.geomspace(*ends, COUNT))


def _likeliest(profile: RadialProfile, variances: FloatArray) -> FloatArray:
    """Weights by Richardson (1972) and Lucy (1974): w * sum over rings of (share/own share) * the Gaussian's there."""
    rings = np.diff(_within(profile, variances), prepend=0, append=1, axis=1)
    share = np.append(np.diff(_borders(profile), prepend=0), 1 - _borders(profile)[-1])
    weights = np.full(COUNT, 1 / COUNT)
    for _ in range(ROUNDS):
        own = weights @ rings
        weights = weights * (rings @ np.divide(share, own, out=np.zeros_like(own), where=own > 0))
    return np.asarray(weights / weights.sum())


def _misplaced(profile: RadialProfile, weights: FloatArray, variances: FloatArray) -> float:
    return float(np.abs(weights @ _within(profile, variances) - _borders(profile)).max())


def _within(profile: RadialProfile, variances: FloatArray) -> FloatArray:
    """The share of each Gaussian within each ring's outer border (Gaussians, rings)."""
    return np.asarray(-np.expm1(-np.square(profile.radii[1:]) / (2 * variances[:, np.newaxis])))


def _borders(profile: RadialProfile) -> FloatArray:
    """The share of the photons that leave within each ring's outer border (rings,)."""
    return np.asarray(np.cumsum(profile.counts[:-1]) / profile.counts.sum())
