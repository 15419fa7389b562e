"""What becomes of each compared pixel: right beyond doubt, one of several right values, wrong, or unknown."""

from dataclasses import dataclass, replace
from functools import reduce

import numpy as np

from sss_ref.results.diff import bits
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.sparing import SAMPLED

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
    outcome: uint8 (N,), indices of OUTCOMES. bounded: uint8 (N,), where bounds were worked out, as in `Reached`; None:
    everywhere.
    """

    expected: np.ndarray
    got: np.ndarray
    reach: np.ndarray
    differs: np.ndarray
    outcome: np.ndarray
    bounded: np.ndarray | None = None

    def count(self, outcome: int) -> int:
        """How many pixels have an outcome; of one that bounds decide, the spared ones as often as those like them."""
        there = self.outcome == outcome
        if self.bounded is None or outcome not in (AMBIGUOUS, UNBOUNDED):
            return int(there.sum())
        defined = self.outcome != UNDEFINED
        spared, alike = (defined & (self.bounded == reason) for reason in (0, SAMPLED))
        share = (there & alike).sum() / max(alike.sum(), 1)
        return int(there.sum()) + round(float(share * spared.sum()))

    @property
    def sample(self) -> np.ndarray:
        """Bool (N,): the pixels that stand for all in what is said of how wide bounds are."""
        defined = self.outcome != UNDEFINED
        return defined if self.bounded is None else defined & (self.bounded & SAMPLED != 0)


def compared(check: Check) -> Compared:
    """The compared pixels and their outcomes; a NaN where only numbers are right is a failure."""
    expected, got = (pixels_at(array, check.where) for array in (check.expected, check.got))
    outcome, reach = np.full(len(got), CERTAIN, np.uint8), np.zeros(got.shape)
    outcome[in_any_channel(~np.isfinite(expected))] = UNDEFINED
    pixels = Compared(expected, got, reach, in_any_channel(bits(expected) != bits(got)), outcome)
    if check.bounded is None:
        return _decided(pixels, check, check.where, expected)
    bounded = pixels_at(check.bounded, check.where)[:, 0]
    told = np.flatnonzero(bounded)
    some = Compared(expected[told], got[told], reach[told], pixels.differs[told], outcome[told])
    some = _decided(some, check, check.where & (check.bounded != 0), expected)
    reach[told], outcome[told] = some.reach, some.outcome
    return replace(pixels, bounded=bounded)


def _decided(pixels: Compared, check: Check, where: np.ndarray, numbers: np.ndarray) -> Compared:
    """The pixels of a mask, bool (H, W), with their reach and what that makes of them. numbers: the whole buffer's."""
    expected, got, reach = pixels.expected, pixels.got, pixels_at(check.reach, where)
    unbounded, outcome, differs = np.isinf(reach), pixels.outcome.copy(), pixels.differs
    undefined = ~np.isfinite(expected) | unbounded & ~np.isfinite(got)
    if check.undecided is not None:
        outcome[pixels_at(check.undecided, where)[:, 0]] = AMBIGUOUS
    outcome[in_any_channel(unbounded) | _holds_all(expected, reach, numbers)] = UNBOUNDED
    outcome[in_any_channel(undefined)] = UNDEFINED
    beyond = ~(distance(expected[differs], got[differs]) <= reach[differs]) & ~undefined[differs]
    outcome[np.flatnonzero(differs)[in_any_channel(beyond)]] = FAIL
    return replace(pixels, reach=reach, outcome=outcome)


def _holds_all(expected: np.ndarray, reach: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    """Bool (N,): the pixels whose intervals hold 0 and every one of these numbers, in all channels: no test of them."""
    if expected.dtype.kind != "f" or not reach.any():
        return np.zeros(len(expected), bool)
    finite = (np.where(np.isfinite(each), each, np.float32(0)) for each in numbers.T)
    least, most = np.array([(column.min(initial=0), column.max(initial=0)) for column in finite], float).T
    found = ~in_any_channel(reach < WIDE * (most - least))
    numbers, reach = np.where(np.isfinite(expected), expected, 0)[found].astype(np.float64), reach[found]
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
