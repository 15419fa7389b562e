"""What becomes of each compared pixel: right beyond doubt, one of several right values, wrong, or unknown."""

from dataclasses import dataclass
from functools import reduce

import numpy as np

from sss_ref.results.diff import bits
from sss_ref.validation.accept.rebased import Check

OUTCOMES = ("certain", "ambiguous", "fail", "undefined", "unbounded")
"""In reach; in reach where a processor may take one of several texels or sides; out of reach; not finite where that may
be, as after a division by 0 or a NaN in what was read; in reach because every number is that the buffer holds."""
CERTAIN, AMBIGUOUS, FAIL, UNDEFINED, UNBOUNDED = range(len(OUTCOMES))
NOT_COMPARED = 255
WIDE = 0.4  # of what lies between two numbers: an interval that holds both reaches half as far


@dataclass(frozen=True)
class Compared:
    """The N compared pixels of a check, row by row from the bottom.

    expected, got: (N, C). reach: float64 (N, C), how far they may differ. differs: bool (N,), whether any bit does.
    outcome: uint8 (N,), indices of OUTCOMES.
    """

    expected: np.ndarray
    got: np.ndarray
    reach: np.ndarray
    differs: np.ndarray
    outcome: np.ndarray

    def count(self, outcome: int) -> int:
        """How many pixels have an outcome."""
        return int((self.outcome == outcome).sum())


def compared(check: Check) -> Compared:
    """The compared pixels and their outcomes; a NaN where only numbers are right is a failure."""
    arrays = check.expected, check.got, check.reach
    expected, got, reach = (pixels_at(array, check.where) for array in arrays)
    unbounded = np.isinf(reach)
    undefined = ~np.isfinite(expected) | unbounded & ~np.isfinite(got)
    outcome = np.full(len(got), CERTAIN, np.uint8)
    if check.undecided is not None:
        outcome[pixels_at(check.undecided, check.where)[:, 0]] = AMBIGUOUS
    outcome[in_any_channel(unbounded) | _holds_all(expected, reach)] = UNBOUNDED
    outcome[in_any_channel(undefined)] = UNDEFINED
    differs = in_any_channel(bits(expected) != bits(got))
    beyond = ~(distance(expected[differs], got[differs]) <= reach[differs]) & ~undefined[differs]
    outcome[np.flatnonzero(differs)[in_any_channel(beyond)]] = FAIL
    return Compared(expected, got, reach, differs, outcome)


def _holds_all(expected: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """Bool (N,): the pixels whose intervals hold 0 and every number of the buffer, in all channels: no test of it."""
    if expected.dtype.kind != "f" or not reach.any():
        return np.zeros(len(expected), bool)
    numbers = np.where(np.isfinite(expected), expected, np.float32(0))
    least, most = (np.array([end(column, initial=0) for column in numbers.T], float) for end in (np.min, np.max))
    found = ~in_any_channel(reach < WIDE * (most - least))
    numbers, reach = numbers[found].astype(np.float64), reach[found]
    found[found] = ~in_any_channel((numbers - reach > least) | (numbers + reach < most)) & (most > least).any()
    return found


def distance(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """How far values lie apart, float64; NaN for NaN and for two infinities."""
    with np.errstate(invalid="ignore"):
        return np.abs(a.astype(np.float64) - b.astype(np.float64))


def in_any_channel(holds: np.ndarray) -> np.ndarray:
    """Bool (N,), of bool (N, C); for so few channels faster than a reduction along the last axis."""
    if not holds.any():
        return np.zeros(len(holds), bool)
    return reduce(np.logical_or, holds.T)


def pixels_at(array: np.ndarray, where: np.ndarray) -> np.ndarray:
    """The pixels (N, C), row by row, of an array (H, W) or (H, W, C) that a mask, bool (H, W), chooses."""
    pixels = array.reshape(where.size, -1)
    return pixels if where.all() else pixels[np.flatnonzero(where)]


def outcome_map(check: Check) -> np.ndarray:
    """The outcome of every pixel, uint8 (H, W); NOT_COMPARED elsewhere."""
    found = np.full(check.where.shape, NOT_COMPARED, np.uint8)
    found[check.where] = compared(check).outcome
    return found
