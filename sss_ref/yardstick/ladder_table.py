"""A ladder as a table: of each technique the error everywhere, the mean error in each region, and the cost."""

from collections.abc import Iterator

from sss_ref.yardstick.deviation import Deviation
from sss_ref.yardstick.ladder import By, Ladder

OVERALL = ("bias", "rms", "mean", "95 %", "dE", "dE 95 %")
NOISE, GPU = "noise of the truth", "GPU against the oracle"


def head(ladder: Ladder) -> list[str]:
    """The names of the columns: overall, then the mean error of each region, then the cost."""
    return ["technique", *OVERALL, *list(ladder.masks)[1:], "ms"]


def rows(ladder: Ladder) -> Iterator[list[str]]:
    """The noise, what a GPU drew if that is known, and the techniques, in this order."""
    yield _row(NOISE, ladder.noise, "")
    if ladder.gpu is not None:
        yield _row(GPU, ladder.gpu, "")
    for rung in ladder.rungs:
        yield _row(rung.name, ladder.deviations[rung.name], f"{rung.milliseconds:.0f}")


def as_markdown(ladder: Ladder) -> str:
    """The table, for a page of Markdown."""
    names = head(ladder)
    lines = ["| " + " | ".join(cells) + " |" for cells in (names, *rows(ladder))]
    return "\n".join([lines[0], "|---" + "|---:" * (len(names) - 1) + "|", *lines[1:]]) + "\n"


def _overall(found: Deviation) -> list[str]:
    """The cells of OVERALL."""
    return [f"{found.bias:+.1%}", *(f"{each:.1%}" for each in (found.rms, found.mean, found.tail)), *_colors(found)]


def _row(name: str, found: By, cost: str) -> list[str]:
    everywhere, *regions = found.values()
    return [name, *_overall(everywhere), *(f"{one.mean:.1%}" for one in regions), cost]


def _colors(found: Deviation) -> list[str]:
    return ["" if each is None else f"{each:.1f}" for each in (found.color, found.color_tail)]
