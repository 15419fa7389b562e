"""R(r): where light leaves a half-space again that has entered it as a thin beam, straight down."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.truth.photon import REFLECTED, Setup, Volume
from sss_ref.truth.tally import Progress, Tally, Walk, nothing_walked

FloatArray = NDArray[np.float64]
RINGS = 1024
DIFFUSION_LENGTHS = 12.0  # the largest ring; beyond, hardly 1 photon of 10^5 leaves


@dataclass(frozen=True, eq=False)
class RadialProfile:
    """What has left through the lit face, by its distance r from the beam, mm."""

    tally: Tally

    @cached_property
    def radii(self) -> FloatArray:
        """The borders of the rings (R + 1,), from 0."""
        return np.array((0.0, *self.tally.of.radii))

    @cached_property
    def counts(self) -> NDArray[np.int64]:
        """The photons that left in each ring, and beyond all (R + 1,)."""
        counts: NDArray[np.int64] = self.tally.counts[REFLECTED].sum(axis=0)
        return counts

    @property
    def reflectance(self) -> float:
        """The share of the light that leaves again."""
        return self.tally.share(REFLECTED)

    @property
    def reflectance_error(self) -> float:
        """The standard error of `reflectance`."""
        return self.tally.share_error(REFLECTED)

    @property
    def density(self) -> FloatArray:
        """R of each ring (R,): the share of the light that leaves there, per mm^2."""
        return self.counts[:-1] / (self.tally.photons * self._areas)

    @property
    def density_error(self) -> FloatArray:
        """The standard error of `density`."""
        share = self.counts[:-1] / self.tally.photons
        return np.sqrt(share * (1 - share) / self.tally.photons) / self._areas

    @property
    def _areas(self) -> FloatArray:
        return math.pi * np.diff(np.square(self.radii))

    def within(self, radius: float) -> float:
        """Of the light that leaves again, the share that does so within a radius, mm; in a ring it is spread evenly."""
        return float(np.interp(radius * radius, np.square(self.radii), self._cumulative))

    def within_error(self, radius: float) -> float:
        """The standard error of `within`."""
        share = self.within(radius)
        return math.sqrt(share * (1 - share) / int(self.counts.sum()))

    def quantile(self, share: float) -> float:
        """The radius, mm, within which this share of the light leaves again that does."""
        return math.sqrt(np.interp(share, self._cumulative, np.square(self.radii)))

    def quantile_error(self, share: float) -> float:
        """The standard error of `quantile`: half of what it moves for one standard error of the share either way."""
        step = math.sqrt(share * (1 - share) / int(self.counts.sum()))
        return (self.quantile(share + step) - self.quantile(share - step)) / 2

    @cached_property
    def _cumulative(self) -> FloatArray:
        """The share within each border."""
        return np.asarray(np.concatenate(([0], np.cumsum(self.counts[:-1]))) / self.counts.sum())


def searchlight(
    volume: Volume,
    photons: int,
    seed: int = 0,
    threads: int | None = None,
    on_progress: Progress | None = None,
    diffuse: bool = False,
) -> RadialProfile:
    """Walk so many photons of a beam into a half-space of a volume; the same bits for any number of threads.

    seed: of the random numbers. threads: all processors where it is None. on_progress(done, photons) is told now and
    then. diffuse: whether light enters in that point from all sides (cosine), or straight down.
    To go on with a profile's photons: `RadialProfile(profile.tally.more(photons))`.
    Raises SceneError for a volume without absorption: its photons would walk for ever.
    """
    return RadialProfile(nothing_walked(beam(volume, seed, diffuse)).more(photons, threads, on_progress))


def beam(volume: Volume, seed: int = 0, diffuse: bool = False) -> Walk:
    """The walk of a beam into a half-space, with rings as far as light goes, narrower towards the beam."""
    reach = DIFFUSION_LENGTHS * diffusion_length(volume)
    return Walk(volume, Setup(math.inf, diffuse), rings(reach), seed)


def rings(reach: float, count: int = RINGS) -> tuple[float, ...]:
    """The outer radii reach * (k/count)^2 of rings, mm."""
    return tuple(reach * (k / count) * (k / count) for k in range(1, count + 1))


def diffusion_length(volume: Volume) -> float:
    """1 / sqrt(3 * a * (a + s * (1 - g))), mm: over which light fades to 1/e deep in a body; inf without absorption."""
    reduced = volume.scattering * (1 - volume.anisotropy)
    square = 3 * volume.absorption * (volume.absorption + reduced)
    return 1 / math.sqrt(square) if square > 0 else math.inf
