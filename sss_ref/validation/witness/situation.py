"""A stage at a single fragment: what it reads there, and all that it may then give."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.evaluate import elements_read
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.trace import scalar, trace
from sss_ref.language.stage import Stage
from sss_ref.validation.accept.acceptance import accepted
from sss_ref.validation.accept.known import Known
from sss_ref.validation.accept.walk import StageRun


@dataclass(frozen=True, eq=False)
class Situation:
    """What a stage reads.

    exact: parameter -> its value, as `trace` takes it. bounds: the same with all that it may be, as `run_intervals`
    takes it; where it can be nothing else once more the value. The stage has its own names.
    """

    stage: Stage
    exact: Mapping[str, Any]
    bounds: Mapping[str, Any]

    @classmethod
    def of(cls, run: StageRun) -> "Situation":
        """Of a stage that was run at a single pixel."""
        exact = {own: scalar(known.exact) for own, known in run.read.items()}
        sure = {own for own, known in run.read.items() if known.bounds is known.exact}
        bounds = {own: exact[own] if own in sure else known.bounds for own, known in run.read.items()}
        return cls(unbound(run.stage), exact, bounds)

    def gives(self, output: str, profile: Profile) -> Known:
        """What an output is, and all that it may be on a processor of the profile."""
        _, writes = trace(self.stage, [self.exact[own] for own in self.stage.parameters])
        return Known(writes[output], *accepted(self.stage, self.bounds, profile, 1)[output])

    def reads(self, profile: Profile) -> dict[str, set[tuple[int, ...]]]:
        """The elements of textures and arrays that it may read; see `elements_read`."""
        with np.errstate(all="ignore"):
            return elements_read(self.stage, self.bounds, profile)


def unbound(stage: Stage) -> Stage:
    """A stage by its own names."""
    reads, writes = ({own: own for own in names} for names in (stage.parameters, stage.outputs))
    return replace(stage, reads=reads, writes=writes)
