"""What a texture keeps of a value: it rounds to a neighbour, one way or the other, and clamps to its range."""

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.numerics.interval import INFINITY, Interval

# Storage -> the step between neighbours: relative to the value, and at least.
STEPS = {
    "float16": (2.0**-10, 2.0**-24),
    "float11": (2.0**-6, 2.0**-20),
    "float10": (2.0**-5, 2.0**-19),
    "unorm8": (0.0, 1 / 255),
    "unorm10": (0.0, 1 / 1023),
    "unorm16": (0.0, 1 / 65535),
    "unorm24": (0.0, 1 / (2**24 - 1)),
    "srgb8": (0.0, 3.3 / 255),  # a code near white stands for more linear light than one near black
}
DEPTHS = {"D16": "unorm16", "D24": "unorm24", "D32F": "float32"}


def depth_storage(profile: Profile) -> str:
    """How a processor of the profile stores a depth."""
    return DEPTHS[profile.depth_format]


def step_of(storage: str, values: np.ndarray) -> np.ndarray:
    """The step of a storage at these values, float64; 0 for float32 and integers."""
    relative, least = STEPS.get(storage, (0.0, 0.0))
    size = np.abs(values.astype(np.float64))
    return np.maximum(np.where(np.isfinite(size), size, 0.0) * relative, least)


def before_storage(storage: str, held: np.ndarray) -> Interval:
    """The values, float64, that a texture may have been given that holds these.

    Where a normalised one holds 0 or 1 it may have been given anything below or above.
    """
    step, exact = step_of(storage, held), held.astype(np.float64)
    clamps = "norm" in storage
    low = np.where(clamps & (held == 0), -INFINITY, exact - step)
    return Interval(low, np.where(clamps & (held == 1), INFINITY, exact + step))


def lost_in_storage(storage: str, computed: np.ndarray, held: np.ndarray) -> np.ndarray:
    """How far, float64, storage may have moved a value from where it was computed: a step, or what it cut off."""
    given = before_storage(storage, held)
    likeliest = np.clip(computed.astype(np.float64), given.low, given.high)
    with np.errstate(invalid="ignore"):
        return np.fmax(step_of(storage, held), np.abs(held - likeliest))  # of NaN nothing is known but its step
