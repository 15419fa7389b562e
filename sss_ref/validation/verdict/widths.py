"""How much is let pass: the widths of the acceptance intervals in ULP, so that a pass that means nothing is seen."""

import math
from dataclasses import dataclass
from functools import reduce

import numpy as np

from sss_ref.validation.verdict.outcomes import in_any_channel

WIDTH_BOUNDS = (0.0, 1.0, 8.0, 64.0, 1024.0, 65536.0, np.finfo(np.float64).max)  # the largest of each class
WIDTH_CLASSES = ("0", "to 1", "to 8", "to 64", "to 1k", "to 64k", "more", "unbounded")
NEARLY_ALL = 0.95
LARGEST = float(np.finfo(np.float32).max)


@dataclass(frozen=True)
class Widths:
    """The widths of a buffer's intervals. counts: values in each of WIDTH_CLASSES.

    most: the width in ULP that 95 of 100 values have at most; infinite where too many are unbounded, 0 without values.
    """

    counts: tuple[int, ...]
    most: float


def widths_of(expected: np.ndarray, reach: np.ndarray) -> Widths:
    """The widths of intervals of this reach, float64 (N, C), around expected values (N, C), which are finite."""
    if not reach.any():
        return Widths((reach.size, *[0] * (len(WIDTH_CLASSES) - 1)), 0.0)
    open_ones = in_any_channel(reach > 0)
    near, around = (each if open_ones.all() else each[open_ones] for each in (reach, expected))
    width = in_ulps(2 * near, around, near).reshape(-1)
    up_to = [np.count_nonzero(width <= bound) for bound in WIDTH_BOUNDS]
    counts = np.diff([0, *up_to, width.size])
    exact = reach.size - width.size
    counts[0] += exact
    rank = math.ceil(NEARLY_ALL * reach.size) - exact  # among those that are not exact, the smallest being 1
    most = np.partition(width, rank - 1)[rank - 1] if rank > 0 else 0.0
    return Widths(tuple(counts.tolist()), float(most))


def share_let_pass(expected: np.ndarray, reach: np.ndarray) -> float:
    """How much of what a buffer holds, from 0 or its least number to its largest, is let pass on average, 0 to 1.

    expected, reach: (N, C). By channel, and 0 of numbers that all are 0, or that are no floats.
    """
    if expected.dtype.kind != "f" or not reach.any():
        return 0.0
    middle = expected.astype(np.float64)
    least, most = (np.array([end(column, initial=0) for column in expected.T], float) for end in (np.min, np.max))
    passes = np.minimum(middle + reach, most) - np.maximum(middle - reach, least)
    there = most > least
    if not there.all():
        passes = passes[:, there]
    return float((passes / (most - least)[there]).mean()) if there.any() else 0.0


def in_ulps(length: np.ndarray, expected: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """Lengths in units in the last place of the largest number in the interval, float64 (N, C); 1 for integers.

    Of a vector its largest component counts: a normal's component near 0 has no finer unit than the others.
    """
    if expected.dtype.kind != "f":
        return length
    size = reduce(np.maximum, np.abs(expected).T).astype(np.float64)[:, None]
    largest = np.minimum(size + reach, LARGEST)
    _, exponent = np.frexp(largest)
    with np.errstate(over="ignore"):
        return length / np.ldexp(1.0, np.maximum(exponent - 24, -149))


def compact(ulps: float) -> str:
    """A width in ULP in few letters."""
    if ulps == float("inf"):
        return "unbounded"
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if ulps >= size:
            return f"{ulps / size:.3g}{letter}"
    return f"{ulps:.0f}"
