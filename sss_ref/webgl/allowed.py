"""What a buffer may hold, by the least and the largest number of its own type that is right."""

from dataclasses import dataclass

import numpy as np

from sss_ref.validation.accept.rebased import Check

NOT_COMPARED, COMPARED, SEVERAL, UNDEFINED, BACKGROUND = range(5)  # what is known of a pixel
SIGN = np.int64(1) << 31


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
    if middle.dtype.kind != "f":
        low, high = (np.rint(middle + sign * np.floor(reach)).astype(np.int64) for sign in (-1, 1))
        least, most = (0, 1) if middle.dtype == np.uint8 else (np.iinfo(np.int32).min, np.iinfo(np.int32).max)
        low, high = (np.clip(end, least, most).astype(middle.dtype) for end in (low, high))
        return Allowed(middle, low, high, state)
    return Allowed(middle, _farthest(middle, reach, -1), _farthest(middle, reach, 1), state)


def apart(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """How many numbers of their type lie from one to another that is not less, uint32."""
    steps: np.ndarray = (ordered(high) - ordered(low)).astype(np.uint32)
    return steps


def ordered(numbers: np.ndarray) -> np.ndarray:
    """Numbers as integers, int64, in the same order and without gaps: of floats their bits, -0 and 0 as one."""
    if numbers.dtype.kind != "f":
        return numbers.astype(np.int64)
    bits = np.ascontiguousarray(numbers).view(np.int32).astype(np.int64)
    return np.where(bits < 0, -SIGN - bits, bits)


def _farthest(middle: np.ndarray, reach: np.ndarray, side: int) -> np.ndarray:
    """The float32 farthest to one side whose distance from the middle, in float64, is at most the reach: bisected."""
    end = np.where(np.isinf(reach) & np.isfinite(middle), np.float32(side * np.inf), middle)
    open_ones = (reach > 0) & np.isfinite(reach)
    exact, most = middle[open_ones].astype(np.float64), reach[open_ones]
    start = ordered(middle[open_ones])
    near, far = np.zeros_like(start), ordered(np.full(start.shape, np.inf, np.float32)) - side * start
    while (far - near > 1).any():
        between = (near + far) // 2
        within = np.abs(exact - _numbers(start + side * between).astype(np.float64)) <= most
        near, far = np.where(within, between, near), np.where(within, far, between)
    end[open_ones] = _numbers(start + side * near)
    return end


def _numbers(places: np.ndarray) -> np.ndarray:
    """The float32 that integers stand for, as `ordered` gives them."""
    return np.where(places < 0, -SIGN - places, places).astype(np.int32).view(np.float32)


def _outside(check: Check) -> np.ndarray:
    """Bool (H, W): where its background stands."""
    return np.zeros(check.where.shape, bool) if check.outside is None else check.outside


def _in_all_channels(holds: np.ndarray) -> np.ndarray:
    return holds if holds.ndim == 2 else np.logical_and.reduce(holds, axis=-1)


def _spread(where: np.ndarray, like: np.ndarray) -> np.ndarray:
    """A mask (H, W) for all channels of a buffer."""
    return where if like.ndim == 2 else where[..., None]
