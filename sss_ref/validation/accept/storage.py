"""What a texture keeps of a value: it rounds to a neighbour, one way or the other, and clamps to its range."""

import numpy as np

from sss_ref.dump.loss import EXACT, Loss, loss_of
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.numerics.interval import INFINITY, Interval, point

DEPTHS = {"D16": "unorm16", "D24": "unorm24", "D32F": "float32"}


def depth_storage(profile: Profile) -> str:
    """How a processor of the profile stores a depth."""
    return DEPTHS[profile.depth_format]


def step_of(storage: str | Loss, values: np.ndarray) -> np.ndarray:
    """The step of a storage at these values, float64; 0 for float32 and integers."""
    loss = loss_of(storage)
    return np.zeros(values.shape) if loss == EXACT else loss.step(values)


def before_storage(storage: str | Loss, held: np.ndarray) -> Interval:
    """The values, float64, that a texture may have been given that holds these.

    Where one holds the end of its range, or infinity, it may have been given anything beyond; where it holds 0, any
    number that it may flush.
    """
    loss = loss_of(storage)
    if loss == EXACT:
        return point(held.astype(np.float64))
    exact = np.clip(held.astype(np.float64), loss.low, loss.high)
    step = np.where(exact == 0, np.maximum(loss.step(exact), loss.flushed), loss.step(exact))
    low = np.where(exact <= loss.low, -INFINITY, exact - step)
    return Interval(low, np.where(exact >= loss.high, INFINITY, exact + step))


def after_storage(storage: str | Loss, given: Interval) -> Interval:
    """The values, float64, that a texture may hold that was given one of these: a neighbour, an end, infinity, 0."""
    loss = loss_of(storage)
    low, high = np.clip(given.low, loss.low, loss.high), np.clip(given.high, loss.low, loss.high)
    nearest_0 = np.clip(0.0, low, high)
    low, high = low - loss.step(low), high + loss.step(high)
    flushed = np.abs(nearest_0) < loss.flushed
    low, high = np.where(flushed, np.minimum(low, 0.0), low), np.where(flushed, np.maximum(high, 0.0), high)
    if loss.relative:  # a float, which may have become infinite
        low, high = np.where(given.low < loss.low, -INFINITY, low), np.where(given.high > loss.high, INFINITY, high)
    return Interval(low, high)


def lost_in_storage(storage: str | Loss, computed: np.ndarray, held: np.ndarray) -> np.ndarray:
    """How far, float64, storage may have moved a value from where it was computed: a step, or what it cut off."""
    if loss_of(storage) == EXACT:
        return np.zeros(held.shape)
    given = before_storage(storage, held)
    exact, step = computed.astype(np.float64), step_of(storage, held)
    likeliest = np.clip(exact, given.low, given.high)
    with np.errstate(invalid="ignore"):
        moved = np.fmax(step, np.abs(held - likeliest))  # of NaN nothing is known but its step
    return np.where(np.isinf(held) & (likeliest != exact), step, moved)  # what is in range never becomes infinite


def moved(stored: str | Loss, rounded: str | Loss, computed: np.ndarray, held: np.ndarray) -> np.ndarray:
    """How far, float64, a file and the texture before it may have moved a value; stored, rounded: as in `Drawing`."""
    return lost_in_storage(stored, computed, held) + step_of(rounded, held)
