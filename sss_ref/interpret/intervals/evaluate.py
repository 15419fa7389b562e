"""Stages on intervals: for each fragment, everything that a correct processor may compute from what it may be given."""

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.enclosing import Evaluated, Outcome, enclosed, enclosed_lines
from sss_ref.interpret.intervals.operations import Operations
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import Texels, componentwise, computable, picked
from sss_ref.interpret.intervals.watching import Watching
from sss_ref.language.stage import Stage
from sss_ref.language.types import Texture, Vector, components
from sss_ref.numerics.interval import Interval, each_end, point

CHUNK = 1 << 16  # fragments at a time, so that memory stays small


def run_intervals(
    stage: Stage, inputs: Mapping[str, Any], profile: Profile, pool: Executor | None = None
) -> dict[str, Outcome]:
    """Run a stage on all fragments; buffer -> what it may hold, floats as float32.

    inputs: parameter -> Interval, vector of Intervals, `Texels`, or a value of the array interpreter, taken exactly.
    profile: what the processor that runs the stage may do.
    Fragments are arrays (N,); scalars are the same for all of them, and where nothing else is read N is 1.
    pool: shares the chunks of fragments; the result is the same.
    """
    operations = Operations(profile)
    names = {name: _lifted(inputs[name]) for name in stage.parameters}
    count = max(map(_length, names.values()))
    chunks = [slice(start, min(start + CHUNK, count)) for start in range(0, count, CHUNK)]
    parts = list((pool.map if pool else map)(lambda at: _chunk(stage, names, at, operations), chunks))
    return {stage.writes[own]: _concatenated([part[own] for part in parts]) for own in stage.outputs}


def run_lines(stage: Stage, inputs: Mapping[str, Any], profile: Profile) -> dict[Evaluated, Outcome]:
    """Run a stage on one fragment; what each expression in its lines may give, as in `enclosed_lines`.

    inputs, profile: as in `run_intervals`.
    """
    operations = Operations(profile)
    names = {name: _lifted(inputs[name]) for name in stage.parameters}
    with np.errstate(all="ignore"):
        return enclosed_lines(stage.body, _arguments(names, slice(0, 1), operations), operations)


def elements_read(stage: Stage, inputs: Mapping[str, Any], profile: Profile) -> dict[str, set[tuple[int, ...]]]:
    """Parameter -> the elements that a stage may read of it at one fragment: (row, column) of a texture, (index,).

    inputs, profile: as in `run_intervals`. Of an index that may be anything only the first elements are told.
    """
    operations = Watching(profile)
    names = {name: _lifted(inputs[name]) for name in stage.parameters}
    _chunk(stage, names, slice(0, 1), operations)
    held = {
        name: value.low if isinstance(value, Texels) else getattr(value, "data", None) for name, value in names.items()
    }
    return {name: operations.read_of(array) for name, array in held.items() if array is not None}


def _chunk(stage: Stage, names: Mapping[str, Any], at: slice, operations: Operations) -> dict[str, Outcome]:
    """The outcomes of some fragments."""
    with np.errstate(all="ignore"):
        results = enclosed(stage.body, _arguments(names, at, operations), operations)
    return {name: _expanded(outcome, at.stop - at.start) for name, outcome in results.items()}


def _arguments(names: Mapping[str, Any], at: slice, operations: Operations) -> dict[str, Outcome]:
    """What a stage reads at some fragments."""
    return {name: Outcome(_computable(picked(value, at), operations)) for name, value in names.items()}


def _lifted(value: Any) -> Any:
    """An input as a value on intervals."""
    if isinstance(value, Texture):
        return Texels(value.data, value.data)
    if isinstance(value, Vector):
        return componentwise(_lifted, value)
    return point(value) if isinstance(value, np.ndarray | np.generic | bool | int | float) else value


def _length(value: Any) -> int:
    """How many fragments a value is of."""
    parts = [part for part in components(value) if isinstance(part, Interval)]
    return max((np.size(part.low) for part in parts), default=1)


def _computable(value: Any, operations: Operations) -> Any:
    """A value in the types that intervals compute with."""
    if isinstance(value, Vector):
        return componentwise(lambda part: _computable(part, operations), value)
    return operations.read(each_end(computable, value)) if isinstance(value, Interval) else value


def _expanded(outcome: Outcome, count: int) -> Outcome:
    """An outcome with an element for every fragment."""
    return Outcome(componentwise(lambda a: _full(a, count), outcome.value), np.broadcast_to(outcome.doubt, count))


def _full(a: Interval, count: int) -> Interval:
    def narrowed(end: Any) -> Any:
        end = np.asarray(end)
        return np.broadcast_to(end.astype(np.float32) if end.dtype == np.float64 else end, count)

    return each_end(narrowed, a)


def _concatenated(parts: Sequence[Outcome]) -> Outcome:
    value = componentwise(lambda *chunks: _in_a_row(chunks), *(part.value for part in parts))
    return Outcome(value, np.concatenate([part.doubt for part in parts]))


def _in_a_row(chunks: Sequence[Interval]) -> Interval:
    low = np.concatenate([chunk.low for chunk in chunks])
    same = all(chunk.is_point for chunk in chunks)
    return Interval(low, low if same else np.concatenate([chunk.high for chunk in chunks]))
