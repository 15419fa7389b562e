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
    expected, got, reach = (np.atleast_3d(array)[check.where] for array in (check.expected, check.got, check.reach))
    unbounded = np.isinf(reach)
    undefined = ~np.isfinite(expected) | unbounded & ~np.isfinite(got)
    outcome = np.full(len(got), CERTAIN, np.uint8)
    if check.undecided is not None:
        outcome[check.undecided[check.where]] = AMBIGUOUS
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
    numbers = np.where(np.isfinite(expected), expected, 0).astype(np.float64)
    least, most = (end(numbers, axis=0, initial=0.0) for end in (np.min, np.max))
    return ~in_any_channel((numbers - reach > least) | (numbers + reach < most)) & (most > least).any()


def distance(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """How far values lie apart, float64; NaN for NaN and for two infinities."""
    with np.errstate(invalid="ignore"):
        return np.abs(a.astype(np.float64) - b.astype(np.float64))


def in_any_channel(holds: np.ndarray) -> np.ndarray:
    """Bool (N,), of bool (N, C); for so few channels faster than a reduction along the last axis."""
    return reduce(np.logical_or, holds.T)


def outcome_map(check: Check) -> np.ndarray:
    """The outcome of every pixel, uint8 (H, W); NOT_COMPARED elsewhere."""
    found = np.full(check.where.shape, NOT_COMPARED, np.uint8)
    found[check.where] = compared(check).outcome
    return found
