"""The right picture of an exercise, and beside it the reader's."""

import textwrap
from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from sss_ref.course import figures
from sss_ref.course.right_pictures import right_and_own
from sss_ref.results.diff import differing_pixels

SEEN = 0.004  # of linear light, or of a number's range: what an eye may see


def right_and_yours(check: Callable[[Any], None], answer: Any, head: str) -> None:
    """What the stage of an exercise is for: the right picture, and beside it that of a reader's stage."""
    right, own = right_and_own(check, answer, head)
    _, (left, beside) = figures.row(2, 2.9, 3.3)
    _shown(left, right, "right", right)
    if isinstance(own, str):
        beside.text(0.5, 0.5, textwrap.fill(own, 40), ha="center", va="center", color=figures.FAINT, fontsize=8)
        figures.bare(beside, "yours")
    else:
        _shown(beside, own, compared(right, own), right)


def compared(right: np.ndarray, own: np.ndarray) -> str:
    """How a reader's buffer compares with the right one, as a title."""
    others = differing_pixels(own, right).mean()
    apart = np.abs(own.astype(np.float64) - right).max() / max(float(np.ptp(right)), 1.0)
    if others == 0 or apart > SEEN:
        return "yours, the same bits" if others == 0 else "yours"
    return f"yours: to the eye the same, other bits in {max(others, 0.01):.0%}"


def _shown(axes: Axes, image: np.ndarray, title: str, right: np.ndarray) -> None:
    """A buffer: a colour as it is, a number within the range of the right ones."""
    if image.ndim == 3:
        figures.picture(axes, image, title)
    else:
        figures.values(axes, image, title, "", limits=(float(right.min()), float(right.max())))
