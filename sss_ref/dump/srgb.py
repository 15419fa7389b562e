"""The sRGB transfer function both ways, between its codes as well, and what a sampler may make of a code."""

import numpy as np

from sss_ref.numerics.interval import Interval

LARGEST_CODE_OF_SRGB = 255
DECODING = 0.5  # codes by which a sampler may be off: Mesa's is by 0.34, where it uses a polynomial


def srgb_encoded(linear: np.ndarray) -> np.ndarray:
    """Encoded by IEC 61966-2-1, float64; what is negative as 0."""
    v = np.clip(linear.astype(np.float64), 0, None)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def srgb_decoded(encoded: np.ndarray) -> np.ndarray:
    """The way back, float64."""
    v = np.clip(encoded.astype(np.float64), 0, None)
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def decoded_around(linear: np.ndarray) -> Interval:
    """What a sampler may make of the codes of these values, float64."""
    encoded, off = srgb_encoded(linear), DECODING / LARGEST_CODE_OF_SRGB
    return Interval(srgb_decoded(encoded - off), srgb_decoded(np.minimum(encoded + off, 1.0)))
