"""An explanation of what is wrong, how well it fits, and which of several comes first."""

from collections.abc import Iterable
from dataclasses import dataclass

TELLING = 8  # wrong pixels from which on explanations mean something
ENOUGH = 0.98  # of the wrong pixels that an explanation must bring within reach, and of the right ones to stay there
ALL = 0.999
MOST_ALIKE = 4  # mistakes that compute the same, said one by one

STATE, NUMBER, STAGE, FITTED, MUTANT = range(5)  # what is the simpler explanation comes first
SOURCE, SETTING, INPUT = "source", "setting", "input"  # what an explanation blames


@dataclass(frozen=True)
class Charge:
    """What may be wrong, in words.

    blames: SOURCE, what a stage computes; SETTING, how it is drawn and stored; or INPUT, what it is given.
    names: of the uniforms or buffers that the words are about.
    """

    text: str
    blames: str
    names: tuple[str, ...] = ()

    def fitting(self, fit: tuple[float, float], rank: int) -> "Hypothesis":
        """The same with how well it fits: its share and what it keeps, as a hypothesis has them."""
        return Hypothesis(self.text, *fit, rank, self.blames, self.names)


@dataclass(frozen=True)
class Hypothesis:
    """An explanation in words.

    share: of the wrong pixels tried, those that it brings within reach. kept: of the right ones, those that stay so.
    rank: how simple it is, one of STATE, NUMBER, STAGE, FITTED and MUTANT. blames, names: as a charge has them.
    """

    text: str
    share: float
    kept: float
    rank: int
    blames: str
    names: tuple[str, ...] = ()

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
