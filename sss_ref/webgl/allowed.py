"""What a buffer may hold, by the least and the largest number of its own type that is right."""

from dataclasses import dataclass

import numpy as np

from sss_ref.numerics.inward import no_farther, ordered
from sss_ref.validation.accept.rebased import Check

NOT_COMPARED, COMPARED, SEVERAL, UNDEFINED, BACKGROUND = range(5)  # what is known of a pixel


@dataclass(frozen=True, eq=False)
class Allowed:
    """A buffer of an exam.

    middle, low, high: (H, W) or (H, W, C), of the buffer's type: what the reference has, and the least and the largest
    number that is right. state: uint8 (H, W), `NOT_COMPARED` to `BACKGROUND`: `SEVERAL` where a processor may choose
    one of several texels or sides, `UNDEFINED` where the reference has no number, `BACKGROUND` where nothing is drawn.
    """

    middle: np.ndarray
    low: np.ndarray
    high: np.ndarray
    state: np.ndarray

    @property
    def below(self) -> np.ndarray:
        """How many numbers of its type lie from the least to the middle, uint32."""
        return apart(self.low, self.middle)

    @property
    def above(self) -> np.ndarray:
        """How many lie from the middle to the largest, uint32."""
        return apart(self.middle, self.high)


def allowed(check: Check) -> Allowed:
    """What a check accepts: every number that is no further from the expected one than its reach."""
    middle = check.expected
    within, numbers = check.where | _outside(check), np.isfinite(middle)
    state = np.where(check.where, np.uint8(COMPARED), np.uint8(NOT_COMPARED))
    if check.undecided is not None:
        state[check.where & check.undecided] = SEVERAL
    state[_outside(check)] = BACKGROUND
    state[within & ~_in_all_channels(numbers)] = UNDEFINED
    reach = np.where(numbers & _spread(within, middle), check.reach, 0.0)
    return Allowed(middle, *no_farther(middle, reach), state)


def apart(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """How many numbers of their type lie from one to another that is not less, uint32."""
    steps: np.ndarray = (ordered(high) - ordered(low)).astype(np.uint32)
    return steps


def _outside(check: Check) -> np.ndarray:
    """Bool (H, W): where its background stands."""
    return np.zeros(check.where.shape, bool) if check.outside is None else check.outside


def _in_all_channels(holds: np.ndarray) -> np.ndarray:
    return holds if holds.ndim == 2 else np.logical_and.reduce(holds, axis=-1)


def _spread(where: np.ndarray, like: np.ndarray) -> np.ndarray:
    """A mask (H, W) for all channels of a buffer."""
    return where if like.ndim == 2 else where[..., None]
