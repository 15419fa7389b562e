"""The numbers that a texture can hold, by its storage: the nearest to each value, and whether values are such."""

from collections.abc import Callable

import numpy as np

from sss_ref.dump.loss import LARGEST_SHARED
from sss_ref.dump.srgb import srgb_decoded, srgb_encoded

NEARLY = 2.0**-22  # relative: two ways from a code to a float32 may round differently
NEARLY_SRGB = 0.45  # codes: what a sampler decoded may lie nearly half a code beside the formula
Held = Callable[[np.ndarray], np.ndarray]


def are_held(values: np.ndarray, storage: str) -> np.ndarray:
    """Bool (H, W, C): which values a texture can hold; infinity and NaN those of floats."""
    finite = np.isfinite(values)
    exact = np.where(finite, values, 0).astype(np.float64)
    with np.errstate(over="ignore"):
        if storage == "srgb8":
            codes = srgb_encoded(exact) * 255
            near = (exact >= 0) & (exact <= 1) & (np.abs(codes - np.rint(codes)) <= NEARLY_SRGB)
        else:
            near = np.abs(HELD[storage](exact) - exact) <= np.abs(exact) * NEARLY
    return np.asarray(near & finite | ~finite & (storage in FLOATS))


def _floats(values: np.ndarray) -> np.ndarray:
    """Floats without a sign, five bits of exponent, and 6, 6, 5 bits of mantissa; of fewer than three channels 6."""
    bits = np.array([6, 6, 5] if values.shape[-1:] == (3,) else [6])
    _, exponent = np.frexp(values)
    step = np.ldexp(1.0, np.maximum(exponent - 1, -14) - bits)
    return np.maximum(np.rint(values / step) * step, 0.0)


def _shared(values: np.ndarray) -> np.ndarray:
    """Nine bits of each channel below the exponent of the largest."""
    _, exponent = np.frexp(values.max(axis=-1, keepdims=True, initial=0.0))
    step = np.ldexp(1.0, np.maximum(exponent, -15) - 9)
    return np.clip(np.rint(values / step) * step, 0.0, LARGEST_SHARED)


def _codes(largest: int, least: int = 0) -> Held:
    return lambda values: np.rint(np.clip(values, least, 1) * largest) / largest


def _halves(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float16).astype(np.float64)


HELD: dict[str, Held] = {
    "unorm8": _codes(255),
    "srgb8": lambda values: srgb_decoded(_codes(255)(srgb_encoded(values))),
    "rgb10a2": _codes(1023),
    "unorm16": _codes(65535),
    "snorm8": _codes(127, -1),
    "snorm16": _codes(32767, -1),
    "r11g11b10f": _floats,
    "rgb9e5": _shared,
    "float16": _halves,
}
FLOATS = ("float16", "r11g11b10f")
