"""The right picture of an exercise, and beside it the reader's."""

import textwrap
from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from sss_ref.course import figures
from sss_ref.course.right_pictures import right_and_own


def right_and_yours(check: Callable[[Any], None], answer: Any, head: str) -> None:
    """What the stage of an exercise is for: the right picture, and beside it that of a reader's stage."""
    right, own = right_and_own(check, answer, head)
    _, axes = figures.row(2, 2.9, 3.3)
    for panel, image, title in zip(axes, (right, own), ("right", "yours"), strict=True):
        if isinstance(image, str):
            panel.text(0.5, 0.5, textwrap.fill(image, 40), ha="center", va="center", color=figures.FAINT, fontsize=8)
            figures.bare(panel, title)
        else:
            _shown(panel, image, title, right)


def _shown(axes: Axes, image: np.ndarray, title: str, right: np.ndarray) -> None:
    """A buffer: a colour as it is, a number within the range of the right ones."""
    if image.ndim == 3:
        figures.picture(axes, image, title)
    else:
        figures.values(axes, image, title, "", limits=(float(right.min()), float(right.max())))
