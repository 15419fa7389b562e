"""What buffers may hold at pixels where one of several things may have been drawn: the hull of those that may be."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sss_ref.validation.accept.known import KnownBuffer, Pixels

Ends = tuple[np.ndarray, np.ndarray]  # the low and the high ends of what some pixels may hold, (N, C)


@dataclass(frozen=True, eq=False)
class Alternatives:
    """The alternatives that have been found so far.

    number: int64 (H, W), the place of each of N pixels; of no others. every, agreeing: buffer -> float64 (2, N, C), the
    low and high ends of all alternatives, and of those that agree with what was dumped; low above high where there is
    none yet.
    """

    number: np.ndarray
    every: Mapping[str, np.ndarray]
    agreeing: Mapping[str, np.ndarray]

    @classmethod
    def none_yet(cls, where: np.ndarray, buffers: Mapping[str, KnownBuffer]) -> "Alternatives":
        """No alternative at the pixels of a mask, bool (H, W), for what these buffers hold."""
        number = np.zeros(where.shape, np.int64)
        number[where] = np.arange(np.count_nonzero(where))
        every, agreeing = ({name: _empty(where, buffer) for name, buffer in buffers.items()} for _ in range(2))
        return cls(number, every, agreeing)

    def add(self, at: Pixels, agrees: np.ndarray, values: Mapping[str, Ends]) -> None:
        """One more alternative at some pixels, each of them once. agrees: bool (N,). values: what buffers then hold."""
        number = self.number[at]
        for name in self.every:
            _widen(self.every[name], number, values[name])
            low, high = values[name]
            _widen(self.agreeing[name], number[agrees], (low[agrees], high[agrees]))

    def ends(self, name: str) -> np.ndarray:
        """What a buffer may hold, float64 (2, N, C)."""
        low, high = self.agreeing[name]
        return np.where(low <= high, self.agreeing[name], self.every[name])


def _empty(where: np.ndarray, buffer: KnownBuffer) -> np.ndarray:
    """The ends of no values at all."""
    shape = (np.count_nonzero(where), np.atleast_3d(buffer.exact).shape[2])
    return np.stack([np.full(shape, np.inf), np.full(shape, -np.inf)])


def _widen(ends: np.ndarray, number: np.ndarray, values: Ends) -> None:
    """Take values (N, C) in."""
    low, high = values
    ends[0, number] = np.minimum(ends[0, number], low)
    ends[1, number] = np.maximum(ends[1, number], high)
