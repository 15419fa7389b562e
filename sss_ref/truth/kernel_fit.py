"""The thirteen taps that come nearest to where a material's light leaves again.

What is compared is the energy of a small bright disc within circles around its middle (`small_feature`): by the walk's
R(r), and by taps at hbh09's points, an offset of 1 being so many mm.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.scene_file.kernels import HBH09, Tap
from sss_ref.truth.searchlight import RadialProfile
from sss_ref.truth.small_feature import covered, energy_within

FloatArray = NDArray[np.float64]
OFFSETS = np.hypot([tap[0] for tap in HBH09], [tap[1] for tap in HBH09])
PUBLISHED = np.array([tap[2:] for tap in HBH09])
GROUPS = np.digitize(OFFSETS, (0.05, 1.0, 3.0))  # the middle, and three rings of points about it
SHARED = np.array([(group == GROUPS) / np.count_nonzero(group == GROUPS) for group in range(4)])  # (groups, taps)
SCALES = 2.0 ** (np.arange(-16, 17) / 8)  # tried about the first guess: a quarter of it to four times
CIRCLES = 2.0 ** (np.arange(-2, 13) / 2)  # radii, in discs
ROUNDS = 300  # of Richardson and Lucy


@dataclass(frozen=True)
class KernelFit:
    """A kernel in mm, and the share of a disc's energy that it puts to a wrong radius, for red, green and blue."""

    disc: float  # mm, the disc's radius
    mm_per_offset: float
    taps: tuple[Tap, ...]
    misplaced: tuple[float, ...]
    published_mm: tuple[float, ...]  # for hbh09 with its own weights, each channel by itself: the best mm_per_offset
    published_misplaced: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class _Feature:
    """A disc's energy within circles by a profile."""

    profile: RadialProfile
    disc: float

    @cached_property
    def truth(self) -> FloatArray:
        radii = self.profile.radii
        shares = self.profile.counts[:-1] / self.profile.counts.sum()
        return energy_within((radii[1:] + radii[:-1]) / 2, shares, self.disc, self.circles)

    @property
    def circles(self) -> Sequence[float]:
        return [float(self.disc * each) for each in CIRCLES]

    def of_taps(self, scale: float) -> FloatArray:
        """The same of each tap alone, with weight 1 (taps, circles)."""
        return np.array([covered(scale * OFFSETS, self.disc, circle) for circle in self.circles]).T

    def misplaced(self, scale: float, weights: FloatArray) -> float:
        """The largest difference of the energy within a circle."""
        return float(np.abs(weights @ self.of_taps(scale) - self.truth).max())


def fitted_kernel(profiles: Sequence[RadialProfile]) -> KernelFit:
    """One scale for three profiles, and each channel's weights, so that the worst of them is least wrong.

    The disc is as wide as the mean of the radii within which half of each channel's light leaves.
    """
    disc = float(np.mean([profile.quantile(0.5) for profile in profiles]))
    features = [_Feature(profile, disc) for profile in profiles]
    scales = SCALES * disc / float(OFFSETS @ PUBLISHED.mean(axis=1))
    found = [(*_at_scale(features, float(scale)), float(scale)) for scale in scales]
    misplaced, weights, scale = min(found, key=lambda each: max(each[0]))
    alone = [_published(feature, channel, scales) for channel, feature in enumerate(features)]
    published_mm, published_misplaced = zip(*alone, strict=True)
    return KernelFit(disc, scale, _taps(weights), misplaced, published_mm, published_misplaced)


def _taps(weights: FloatArray) -> tuple[Tap, ...]:
    """hbh09's points with weights (3, taps), as a scene file has them."""
    rows = (tuple(round(float(weight), 6) for weight in row) for row in weights.T)
    return tuple((tap[0], tap[1], red, green, blue) for tap, (red, green, blue) in zip(HBH09, rows, strict=True))


def _at_scale(features: Sequence[_Feature], scale: float) -> tuple[tuple[float, ...], FloatArray]:
    """How wrong the channels are with the best weights at a scale, and these (3, taps)."""
    weights = np.array([_nearest_weights(feature, scale) for feature in features])
    return tuple(each.misplaced(scale, own) for each, own in zip(features, weights, strict=True)), weights


def _nearest_weights(feature: _Feature, scale: float) -> FloatArray:
    """Weights with sum 1, the same for all points of a ring, whose energies between the circles are likeliest.

    Richardson (1972) and Lucy (1974): w * sum over rings of (true/own energy) * the tap's energy there, many times.
    """
    rings = np.diff(SHARED @ feature.of_taps(scale), prepend=0, append=1, axis=1)
    truth = np.diff(feature.truth, prepend=0, append=1)
    weights = np.full(len(SHARED), 1 / len(SHARED))
    for _ in range(ROUNDS):
        own = weights @ rings
        ratio = np.divide(truth, own, out=np.zeros_like(own), where=own > 0)
        weights = weights * (rings @ ratio)
        weights /= weights.sum()
    return np.asarray(weights @ SHARED)


def _published(feature: _Feature, channel: int, scales: FloatArray) -> tuple[float, float]:
    """For a channel of hbh09 as published, the scale at which it is least wrong, and how wrong."""
    weights = PUBLISHED[:, channel] / PUBLISHED[:, channel].sum()
    wrong, scale = min((feature.misplaced(float(scale), weights), float(scale)) for scale in scales)
    return scale, wrong
