"""What a render target keeps of a value, and which values it may have been given."""

from typing import Literal

import numpy as np

from sss_ref.numerics.directed import downward, upward
from sss_ref.numerics.interval import INFINITY, Interval

Encoding = Literal["float32", "float16", "unorm8", "unorm16"]

STEPS = {"unorm8": 255.0, "unorm16": 65535.0}  # from 0 to 1


def stored(a: Interval, encoding: Encoding) -> Interval:
    """What a target may hold of these values: of each both neighbours that the encoding has.

    Unsigned normalised targets clamp to 0 ... 1; what they hold is meant as n/255 or n/65535, in float32 or not.
    """
    if encoding == "float32":
        return a
    if encoding == "float16":
        return Interval(_half_below(a.low), -_half_below(-np.asarray(a.high)))
    steps = STEPS[encoding]
    low, high = (np.clip(end, 0.0, 1.0) * steps for end in (a.low, a.high))
    return Interval(downward(np.floor(low) / steps), upward(np.ceil(high) / steps))


def before_storage(held: np.ndarray, encoding: Encoding) -> Interval:
    """The values that a target may have been given that holds these.

    An unsigned normalised one that holds 0 or 1 may have been given anything below or above.
    """
    held = np.asarray(held)
    if encoding == "float32":
        return Interval(held, held)
    if encoding == "float16":
        half = held.astype(np.float16)
        return Interval(*(np.nextafter(half, np.float16(way)).astype(np.float64) for way in (-INFINITY, INFINITY)))
    steps = STEPS[encoding]
    place = np.rint(held.astype(np.float64) * steps)
    low, high = (place - 1.0) / steps, (place + 1.0) / steps
    return Interval(np.where(place == 0, -INFINITY, low), np.where(place == steps, INFINITY, high))


def _half_below(x: np.ndarray) -> np.ndarray:
    """The largest float16 <= x, as float64."""
    with np.errstate(over="ignore"):
        half = np.asarray(x).astype(np.float16)
    below = np.where(half.astype(np.float64) > x, np.nextafter(half, np.float16(-INFINITY)), half)
    return below.astype(np.float64)
