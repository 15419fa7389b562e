"""A wrong pixel cut down to the one stage that got it wrong, and the verdict on it alone."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sss_ref.dump.loss import Loss
from sss_ref.interpret.intervals.enclosing import CONDITION, WHICH_TEXEL
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.numerics.inward import no_farther
from sss_ref.validation.accept.known import Known
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.storage import moved
from sss_ref.validation.verdict.outcomes import OUTCOMES, compared
from sss_ref.validation.witness.situation import Situation


@dataclass(frozen=True)
class DrawnValue:
    """Where a value was drawn, and how it was kept.

    at: (column, row) of the pass's target, row 0 at the bottom. stored, rounded: of the buffer, as in `Drawing`.
    device: what drew it, in its own words.
    """

    pass_name: str
    buffer: str
    at: tuple[int, int]
    stored: str | Loss = "float32"
    rounded: str | Loss = "float32"
    device: str | None = None


@dataclass(frozen=True, eq=False)
class Witness:
    """A wrong pixel.

    situation: the stage, with what it read. output: the one that was wrong, by the stage's own name. got: its value
    as drawn, (C,), in the type of its buffer. profile: the processor that may have drawn it.
    """

    situation: Situation
    output: str
    got: np.ndarray
    drawn: DrawnValue
    profile: Profile

    @property
    def kind(self) -> Any:
        """The type of the output."""
        return self.situation.stage.outputs[self.output]

    @cached_property
    def known(self) -> Known:
        """What the stage gives, and all that a processor may make of it."""
        return self.situation.gives(self.output, self.profile)

    @property
    def expected(self) -> np.ndarray:
        """What the reference gives, (C,)."""
        values: np.ndarray = self.known.columns[0].astype(dtype_of(self.kind))
        return values

    @property
    def reach(self) -> np.ndarray:
        """How far from that a right value may lie, float64 (C,); what storage loses included."""
        there: np.ndarray = self.known.reach[0] + moved(self.drawn.stored, self.drawn.rounded, self.expected, self.got)
        return there

    @property
    def allowed(self) -> tuple[np.ndarray, np.ndarray]:
        """The least and the greatest right value of each component, (C,), in the type of the buffer."""
        return no_farther(self.expected, self.reach)

    @property
    def outcome(self) -> str:
        """One of `OUTCOMES`: what a run of `validate` says of this pixel."""
        expected, got, reach = (each.reshape(1, 1, -1) for each in (self.expected, self.got, self.reach))
        doubt = np.reshape(self.known.doubt != 0, (1, 1))
        drawn, everywhere = self.drawn, np.ones((1, 1), bool)
        check = Check(drawn.pass_name, self.situation.stage.name, drawn.buffer, everywhere, expected, got, reach, doubt)
        return OUTCOMES[compared(check).outcome[0]]

    @property
    def doubts(self) -> list[str]:
        """Why the interval holds several separate values, if it does, in sentences."""
        said = {CONDITION: "a condition may hold or not", WHICH_TEXEL: "one of several texels may be read"}
        return [text for bit, text in said.items() if np.any(self.known.doubt & bit)]


def as_value(kind: Any, array: np.ndarray) -> Any:
    """The components (C,) of a value of a type as that value."""
    return kind(*array) if CHANNELS[kind] > 1 else array[0]
