"""Operations that remember which elements of textures and arrays a stage may have read."""

from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.operations import Operations
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import CANDIDATES
from sss_ref.numerics.interval import Interval


class Watching(Operations):
    """Those of one fragment; they give what the others give."""

    def __init__(self, profile: Profile) -> None:
        super().__init__(profile)
        self._read: dict[int, set[tuple[int, ...]]] = {}

    def read_of(self, array: np.ndarray) -> set[tuple[int, ...]]:
        """The elements that may have been read of this very array, which must still be there."""
        return self._read.get(id(array), set())

    def fetched(self, low: np.ndarray, high: np.ndarray, index: Sequence[Interval]) -> tuple[Any, Any]:
        """As of any operations; an index outside counts as the nearest one inside."""
        axes = [_candidates(at, count) for at, count in zip(index, low.shape, strict=False)]
        self._read.setdefault(id(low), set()).update(product(*axes))
        return super().fetched(low, high, index)


def _candidates(at: Interval, count: int) -> range:
    """The elements among `count` on an axis that an index of one fragment may mean."""
    first, last = (int(np.clip(np.ravel(end)[0], 0, count - 1)) for end in (at.low, at.high))
    return range(first, min(last, first + CANDIDATES - 1) + 1)
