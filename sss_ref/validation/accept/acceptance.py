"""What a processor of a given profile may make of a stage's inputs: the stage run on intervals."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.evaluate import run_intervals
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.language import Stage
from sss_ref.language.types import Vector, components
from sss_ref.numerics.interval import Interval

INTERPOLATION = 2.0**-21  # relative error of interpolating a varying, besides the snap


def around(value: Any, steps: np.ndarray) -> Any:
    """A value of fragments with everything that lies within its steps (N, at least C)."""
    parts = []
    for k, part in enumerate(components(value)):
        exact = np.asarray(part, np.float64)
        parts.append(Interval(exact - steps[:, k], exact + steps[:, k]))
    return type(value)(*parts) if isinstance(value, Vector) else parts[0]


def accepted(
    stage: Stage, inputs: Mapping[str, Any], profile: Profile, count: int
) -> dict[str, tuple[Any, np.ndarray]]:
    """Buffer -> the intervals of what the stage may write, one element for each of `count` fragments, and the doubt."""
    outcomes = run_intervals(stage, inputs, profile)
    return {name: (_each(each.value, count), np.broadcast_to(each.doubt, count)) for name, each in outcomes.items()}


def _each(value: Any, count: int) -> Any:
    """Intervals with an element for every fragment."""
    if isinstance(value, Vector):
        return type(value)(*(_each(part, count) for part in components(value)))
    return Interval(np.broadcast_to(value.low, count), np.broadcast_to(value.high, count))
