"""What stands where nothing is drawn, beside what a buffer is cleared to there."""

from dataclasses import dataclass

import numpy as np

from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.verdict.outcomes import distance, in_any_channel, pixels_at
from sss_ref.validation.verdict.pixel_text import pixel_text


@dataclass(frozen=True)
class Background:
    """The pixels of a buffer on which nothing is drawn.

    compared: how many. wrong: how many of them hold something else than they should. got, expected: of the first of
    these as text, at the pixel (column, row), row 0 at the bottom. uniform: whether all of them hold the same.
    """

    compared: int
    wrong: int
    got: str
    expected: str
    at: tuple[int, int]
    uniform: bool

    def __str__(self) -> str:
        """As a sentence."""
        where = "" if self.uniform else f" at pixel {self.at[0]},{self.at[1]} and other values elsewhere"
        share = f"on {self.wrong} of these {self.compared} pixels"
        return f"where nothing is drawn {self.got} stands{where}, expected {self.expected}, {share}"


def background_of(check: Check) -> Background | None:
    """What is wrong where nothing is drawn; None where nothing is."""
    at = outside_and_wrong(check)
    if check.outside is None or not at.any():
        return None
    rows, columns = np.nonzero(at)
    got, first = np.atleast_3d(check.got)[at], (rows[0], columns[0])
    uniform = bool((got == got[0]).all())
    values = pixel_text(got[0]), pixel_text(np.atleast_3d(check.expected)[first])
    return Background(int(check.outside.sum()), len(rows), *values, (int(columns[0]), int(rows[0])), uniform)


def outside_and_wrong(check: Check) -> np.ndarray:
    """Bool (H, W): the pixels on which nothing is drawn and that hold something else than what they were cleared to."""
    found = np.zeros(check.where.shape, bool)
    if check.outside is not None:
        arrays = check.expected, check.got, check.reach
        apart = (check.expected != check.got).reshape(found.size, -1)
        differs = check.outside & in_any_channel(apart).reshape(found.shape)
        expected, got, reach = (pixels_at(each, differs) for each in arrays)
        found[differs] = in_any_channel(~(distance(expected, got) <= reach))
    return found
