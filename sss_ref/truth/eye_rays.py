"""The rays of a camera's pixels, and what is gathered along many of them (compiled)."""

import math
from typing import NamedTuple

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.numerics.random_numbers import restart, uniform
from sss_ref.truth.path import LOST, gathered

SAMPLE_BITS = 32  # of a stream's number: above them the sample, below them pixel and channel


class Eye(NamedTuple):
    """A camera in world space. across, up: float64 (3,), from the picture's middle to its right and upper border."""

    origin: np.ndarray  # (3,)
    ahead: np.ndarray  # (3,), unit
    across: np.ndarray  # at distance 1, of a perspective
    up: np.ndarray
    is_parallel: bool
    width: int  # pixels
    height: int
    spread: float  # 0: all samples through the pixel's centre; 1: evenly over the pixel


class Sums(NamedTuple):
    """What the samples of each pixel and channel add up to; a sample that is lost is in none of them."""

    total: np.ndarray  # float64 (H, W, 3)
    square: np.ndarray  # float64 (H, W, 3), of each sample's square
    counted: np.ndarray  # int64 (H, W, 3)


@compiled
def gather_row(stream, scenery, volumes, eye, row, samples, sums):
    """Add samples first ... last - 1 of the pixels of a row, each in order."""
    for column in range(eye.width):
        for channel in range(3):
            pixel = (row * eye.width + column) * 3 + channel
            for sample in range(samples[0], samples[1]):
                restart(stream, (sample << SAMPLE_BITS) + pixel)
                x = column + 0.5 + eye.spread * (uniform(stream) - 0.5)
                y = row + 0.5 + eye.spread * (uniform(stream) - 0.5)
                found = gathered(stream, scenery, volumes[channel], eye_ray(eye, x, y), channel)
                if found != LOST:
                    sums.total[row, column, channel] += found
                    sums.square[row, column, channel] += found * found
                    sums.counted[row, column, channel] += 1


@compiled
def eye_ray(eye, x, y):
    """Origin and unit direction of the ray through a point of the picture, pixels from its lower left corner."""
    u, v = 2.0 * x / eye.width - 1.0, 2.0 * y / eye.height - 1.0
    aside = (
        u * eye.across[0] + v * eye.up[0],
        u * eye.across[1] + v * eye.up[1],
        u * eye.across[2] + v * eye.up[2],
    )
    if eye.is_parallel:
        origin = (eye.origin[0] + aside[0], eye.origin[1] + aside[1], eye.origin[2] + aside[2])
        return origin, (eye.ahead[0], eye.ahead[1], eye.ahead[2])
    dx, dy, dz = eye.ahead[0] + aside[0], eye.ahead[1] + aside[1], eye.ahead[2] + aside[2]
    length = math.sqrt(dx * dx + dy * dy + dz * dz)
    return (eye.origin[0], eye.origin[1], eye.origin[2]), (dx / length, dy / length, dz / length)
