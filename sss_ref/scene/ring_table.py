"""The table of pre-integrated skin: what rings of a material give back at every angle to the light, by their curvature.

D(t, k) = sum of max(cos(t + x), 0) * R(2*sin(|x|/2)/k) over sum of R(2*sin(|x|/2)/k), x once round the ring of radius
1/k; R is the profile, a sum of Gaussians e^(-r^2/(2*v))/v (Penner and Borshukov 2011).
"""

from functools import cache, reduce

import numpy as np
from numpy.typing import NDArray

from sss_ref.numerics.elementary import exp_array
from sss_ref.numerics.trigonometry import cosine, sine
from sss_ref.scene_file.diffusion import Diffusion

SIDE = 64  # texels of either axis
STEPS = 256  # of half a ring
Array64 = NDArray[np.float64]


def ring_table(diffusion: Diffusion) -> Array64:
    """(SIDE, SIDE, 3): along a row N.L from -1 to 1, upwards the curvature from 0 to the sharpest, in even steps.

    At curvature 0 the ring is a plane, where D = max(N.L, 0).
    """
    cosines = 2.0 * np.arange(SIDE) / (SIDE - 1) - 1.0
    sines = np.sqrt(1.0 - cosines * cosines)
    curvatures = diffusion.sharpest_curvature * np.arange(1, SIDE) / (SIDE - 1)
    weight = ring_weights(diffusion, curvatures)
    along, across, _ = ring()
    light = (
        np.maximum(cosines * a - sines * b, 0.0) + np.maximum(cosines * a + sines * b, 0.0)
        for a, b in zip(along, across, strict=True)
    )
    total = reduce(np.add, (at[None, :, None] * own[:, None] for at, own in zip(light, weight, strict=True)))
    whole = reduce(np.add, weight) * 2.0
    plane = np.repeat(np.maximum(cosines, 0.0)[None, :, None], 3, axis=2)
    return np.concatenate([plane, total / whole[:, None]])


def ring_weights(diffusion: Diffusion, curvatures: Array64) -> Array64:
    """R at each step of half a ring times the step's width, (STEPS, K, 3), by curvature (K,) per mm.

    Of 0 to 1 in even steps, each of which counts in its middle, x = 180 degrees * t^3: dense where light is.
    """
    middle = (np.arange(STEPS) + 0.5) / STEPS
    _, _, half = ring()
    chord = 2.0 * half[:, None] / curvatures
    rows = np.array(diffusion.gaussians, np.float64)
    shares = rows[:, 1:] / reduce(np.add, rows[:, 1:])
    terms = [
        exp_array(np.float32(-chord * chord / (2.0 * variance))).astype(np.float64)[..., None] * (share / variance)
        for variance, share in zip(rows[:, 0], shares, strict=True)
    ]
    profile: Array64 = reduce(np.add, terms)
    return profile * (middle * middle)[:, None, None]


@cache
def ring() -> tuple[Array64, Array64, Array64]:
    """Cosine and sine of the x of each step of half a ring, and the sine of half of it, (STEPS,)."""
    middle = (np.arange(STEPS) + 0.5) / STEPS
    degrees = (180.0 * (middle * middle * middle)).tolist()
    along, across, half = ([f(angle) for angle in degrees] for f in (cosine, sine, lambda x: sine(x / 2)))
    return np.array(along), np.array(across), np.array(half)
