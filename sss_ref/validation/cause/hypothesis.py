"""An explanation of what is wrong, how well it fits, and which of several comes first."""

from collections.abc import Iterable
from dataclasses import dataclass

TELLING = 8  # wrong pixels from which on explanations mean something
ENOUGH = 0.98  # of the wrong pixels that an explanation must bring within reach, and of the right ones to stay there
ALL = 0.999
MOST_ALIKE = 4  # mistakes that compute the same, said one by one

STATE, NUMBER, STAGE, FITTED, MUTANT = range(5)  # what is the simpler explanation comes first


@dataclass(frozen=True)
class Hypothesis:
    """An explanation in words.

    share: of the wrong pixels tried, those that it brings within reach. kept: of the right ones, those that stay so.
    rank: how simple it is, one of STATE, NUMBER, STAGE, FITTED and MUTANT.
    """

    text: str
    share: float
    kept: float
    rank: int = STATE

    @property
    def order(self) -> tuple[bool, int, float]:
        """What explains all comes first, then what is simple, then what explains more."""
        return min(self.share, self.kept) < ALL, self.rank, -self.share - self.kept


def fitting(found: Iterable[Hypothesis]) -> list[Hypothesis]:
    """Those that fit well enough."""
    return [each for each in found if min(each.share, each.kept) >= ENOUGH]


def any_of(alike: list[str]) -> str:
    """The mistakes that compute the same, in words."""
    told = ", or ".join(alike[:MOST_ALIKE])
    left = len(alike) - MOST_ALIKE
    return f"{told}, or one of {left} more that compute the same" if left > 0 else told
