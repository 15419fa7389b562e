"""A buffer that is wrong, and what explanations are tried with."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sss_ref.language import Stage
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.cause.sample import Fit, fit_of
from sss_ref.validation.clock import Limit
from sss_ref.validation.verdict.outcomes import FAIL, outcome_map


@dataclass(frozen=True)
class Puzzle:
    """What is wrong, and what may be tried.

    drawn: the pass of the buffer. others: all stages by name, to be tried in the place of others. limit: the time for
    it all. wrong: bool (H, W), the compared pixels that are out of reach.
    """

    case: Case
    check: Check
    drawn: DrawnPass
    others: Mapping[str, Stage]
    limit: Limit
    wrong: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "wrong", outcome_map(self.check) == FAIL)

    def fit(self, holds: np.ndarray) -> Fit:
        """The shares of the wrong and of the right pixels on which something holds, bool (H, W)."""
        return fit_of(holds[self.check.where], self.wrong[self.check.where])
