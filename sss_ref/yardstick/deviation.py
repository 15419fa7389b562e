"""How far a picture is from the truth: of radiance, and as it is seen."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.yardstick.color_difference import color_difference

FloatArray = NDArray[np.float64]
Mask = NDArray[np.bool_]
DARKEST = 0.05  # of white: an error of what is darker counts against this
TAIL = 0.95


@dataclass(frozen=True)
class Deviation:
    """What the pixels of a region have in common.

    A pixel's error is the sum over red, green and blue of |picture - truth|, over that of the truth, or of a twentieth
    of white where that is more.
    """

    pixels: int
    bias: float  # the picture's light over the truth's, less 1
    rms: float  # root of the mean squared difference of a channel, less the truth's noise, over the truth's mean
    mean: float  # of the pixels' errors
    tail: float  # the error that 95 % of the pixels do not exceed
    color: float | None  # mean CIEDE2000, both with one exposure; None: scikit-image is not there
    color_tail: float | None  # that 95 % of the pixels do not exceed


@dataclass(frozen=True, eq=False)
class Truth:
    """What pictures are held against."""

    mean: FloatArray  # linear RGB (H, W, 3)
    error: FloatArray  # its standard error
    white: float  # the radiance that is shown as 1

    @cached_property
    def as_noisy(self) -> FloatArray:
        """What a picture without error would be held for: the truth, and as much noise again as it has."""
        return self.mean + self.error * np.random.default_rng(0).standard_normal(self.mean.shape)

    def deviations(self, image: FloatArray, regions: Mapping[str, Mask]) -> dict[str, Deviation]:
        """Region -> how far the picture is off in it."""
        relative, color = self.relative(image), color_difference(image / self.white, self.mean / self.white)
        return {name: self._deviation(image, relative, color, mask) for name, mask in regions.items()}

    def relative(self, image: FloatArray) -> FloatArray:
        """Each pixel's error (H, W)."""
        floor = DARKEST * 3 * self.white
        return np.asarray(np.abs(image - self.mean).sum(axis=-1) / np.maximum(self.mean.sum(axis=-1), floor))

    def _deviation(self, image: FloatArray, relative: FloatArray, color: FloatArray | None, mask: Mask) -> Deviation:
        seen, true = image[mask], self.mean[mask]
        square = float(np.square(seen - true).mean() - np.square(self.error[mask]).mean())
        return Deviation(
            pixels=int(mask.sum()),
            bias=float(seen.sum() / true.sum() - 1) if true.any() else 0.0,
            rms=float(np.sqrt(max(square, 0.0)) / true.mean()) if true.any() else 0.0,
            mean=float(relative[mask].mean()),
            tail=float(np.quantile(relative[mask], TAIL)),
            color=None if color is None else float(color[mask].mean()),
            color_tail=None if color is None else float(np.quantile(color[mask], TAIL)),
        )
