"""A stage for one fragment, line by line, each line with all that a right processor may make of it."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.enclosing import Evaluated, Outcome
from sss_ref.interpret.intervals.evaluate import run_lines
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.interpret.trace import Bounds, Step
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture, Vector, mat3, mat4
from sss_ref.numerics.interval import Interval


def with_bounds(steps: Sequence[Step], stage: Stage, inputs: Mapping[str, Any], profile: Profile) -> tuple[Step, ...]:
    """The steps of a trace with the bounds of each line, and of each call in it; the lines of functions get none.

    inputs: what the stage may read, as in `run_intervals`. profile: the processor.
    """
    return tuple(_bounded(steps, run_lines(stage, inputs, profile), count()))


def bounds_of(value: Any) -> Bounds | None:
    """What a value of one fragment is at least and at most; None of textures, arrays and matrices.

    value: an Interval, a number that is taken exactly, or a vector of these; NumPy arrays hold one element.
    """
    if isinstance(value, Texture | Texels | Array | mat3 | mat4):
        return None
    return _end(value, "low"), _end(value, "high")


def _bounded(steps: Sequence[Step], found: Mapping[Evaluated, Outcome], numbers: Iterator[int]) -> Iterator[Step]:
    """Steps with bounds; numbers: of the lines to come, which loops and their turns are not."""
    for step in steps:
        if isinstance(step.source, str):
            yield replace(step, inner=tuple(_bounded(step.inner, found, numbers)))
        else:
            number = next(numbers)
            calls = tuple(replace(call, bounds=_at(found, number, call)) for call in step.inner)
            yield replace(step, inner=calls, bounds=_at(found, number, step))


def _at(found: Mapping[Evaluated, Outcome], number: int, step: Step) -> Bounds | None:
    """The bounds of an expression in a line; None of textures, arrays and matrices."""
    outcome = found.get((number, id(step.source)))
    return bounds_of(outcome.value) if outcome else None


def _end(value: Any, end: str) -> Any:
    """One end of each component, floats as float32."""
    if isinstance(value, Vector):
        return type(value)(*(_end(part, end) for part in value))
    (number,) = np.ravel(getattr(value, end) if isinstance(value, Interval) else value)
    return np.float32(number) if number.dtype.kind == "f" else number
