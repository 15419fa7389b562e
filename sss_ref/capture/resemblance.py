"""How much two pictures are alike, channel by channel, from 0 to 1, even where a stage has drawn one of them wrong.

Of four parts. *Close*: how far the numbers are apart, beside how far those expected spread. *Straight* and *ordered*:
how well a line, or any rising curve, leads from one to the other; a distance that was squared is in perfect order.
*Shaped*: where both hold something else than their background. All but the last count orders of magnitude, so that the
right buffer stands out from those that are nearly it.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

CLOSE, STRAIGHT, ORDERED, SHAPED = 0.5, 0.2, 0.2, 0.1  # what each part weighs
NEAREST = 1e-4  # of the spread: what is nearer counts as the same, as processors round otherwise
STRAIGHTEST = 1e-2  # of the spread beside the line; storages of few bits leave so much
LEAST_SPREAD = 1e-2  # of the largest value: of what hardly varies


@dataclass(frozen=True, eq=False)
class Columns:
    """The channels of a picture at some pixels, float64 (P, C), and over all of it.

    drawn: bool (G, C), on a grid, where there is something else than the commonest value.
    """

    values: np.ndarray
    drawn: np.ndarray
    standard: np.ndarray
    ranks: np.ndarray

    @classmethod
    def of(cls, values: np.ndarray, drawn: np.ndarray) -> "Columns":
        """With what comparing them takes."""
        return cls(values, drawn, _standard(values), _standard(_ranks(values)))

    @cached_property
    def spread(self) -> np.ndarray:
        """How far the middle nine tenths of each channel reach from their centre, float64 (C,)."""
        low, high = np.percentile(self.values, (5, 95), axis=0)
        largest = np.abs(self.values).max(initial=0.0)
        return np.asarray(np.maximum((high - low) / 2, max(LEAST_SPREAD * largest, np.finfo(np.float32).tiny)))


@dataclass(frozen=True, eq=False)
class Resemblance:
    """How alike each channel of a file (rows) is to each of a buffer (columns): in all, and in its numbers alone."""

    total: np.ndarray
    close: np.ndarray


def resemblance(held: Columns, expected: Columns, tolerance: np.ndarray, whole: bool) -> Resemblance:
    """The likeness of what a file holds to what a buffer should.

    tolerance: (P, C), how far the file's numbers may be off. whole: whether they are numbers of which two are the same
    or not, and none is near another.
    """
    apart = np.abs(held.values[:, :, None] - expected.values[:, None, :])
    close = _same(apart, tolerance) if whole else _close(apart - tolerance[:, :, None], expected.spread)
    straight, ordered = (_straight(a, b) for a, b in ((held.standard, expected.standard), (held.ranks, expected.ranks)))
    is_constant = ~expected.standard.any(axis=0)
    straight, ordered = (np.where(is_constant, close, part) for part in (straight, ordered))
    shaped = _overlap(held.drawn, expected.drawn)
    return Resemblance(CLOSE * close + STRAIGHT * straight + ORDERED * ordered + SHAPED * shaped, close)


def uncommon(values: np.ndarray) -> np.ndarray:
    """Where each channel of (G, C) holds something else than its commonest value."""
    found = np.empty(values.shape, bool)
    for channel, column in enumerate(values.T):
        distinct, counts = np.unique(column, return_counts=True)
        found[:, channel] = column != distinct[counts.argmax()]
    return found


def _close(apart: np.ndarray, spread: np.ndarray) -> np.ndarray:
    """The mean number of orders of magnitude between the distances and the spread, as a share of those that count."""
    return np.asarray(_orders(apart / spread, NEAREST).mean(axis=0))


def _same(apart: np.ndarray, tolerance: np.ndarray) -> np.ndarray:
    return _orders((apart > tolerance[:, :, None] + NEAREST).mean(axis=0), NEAREST)


def _straight(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """What of the one the other does not tell, from the correlation of each pair of channels that rise together."""
    correlation = np.clip(np.tensordot(a, b, (0, 0)) / len(a), 0.0, 1.0)
    return _orders(np.sqrt(1 - correlation**2), STRAIGHTEST)


def _orders(share: np.ndarray, least: float) -> np.ndarray:
    """0 for 1 and above, 1 for the least share and below, as many orders of magnitude between."""
    return np.asarray(np.log10(np.clip(share, least, 1.0)) / np.log10(least))


def _overlap(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The pixels that both have drawn, as a share of those that one has; 1 where neither has any."""
    both = np.tensordot(a.astype(np.float64), b.astype(np.float64), (0, 0))
    either = a.sum(axis=0)[:, None] + b.sum(axis=0)[None, :] - both
    return np.where(either > 0, both / np.maximum(either, 1), 1.0)


def _standard(values: np.ndarray) -> np.ndarray:
    """Of mean 0 and variance 1; 0 where a channel is constant."""
    moved = values - values.mean(axis=0)
    size = np.sqrt((moved**2).mean(axis=0))
    is_constant = size <= np.finfo(np.float32).eps * np.abs(values).max(axis=0, initial=0.0)
    return np.where(is_constant, 0.0, moved / np.where(is_constant, 1.0, size))


def _ranks(values: np.ndarray) -> np.ndarray:
    """The place of each value among those of its channel; equal ones share the mean of theirs."""
    ranks = np.empty(values.shape)
    for channel, column in enumerate(values.T):
        _, inverse, counts = np.unique(column, return_inverse=True, return_counts=True)
        ranks[:, channel] = (np.cumsum(counts) - (counts - 1) / 2)[inverse]
    return ranks
