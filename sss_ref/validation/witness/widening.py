"""Why an interval is as wide as it is: what is read inexactly, and the lines of the stage that widen it most."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from sss_ref.interpret.intervals.bounded_trace import bounds_of, with_bounds
from sss_ref.interpret.trace import Bounds, Step, trace
from sss_ref.language import tree
from sss_ref.language.types import components
from sss_ref.validation.verdict.widths import compact
from sss_ref.validation.witness.witness import Witness

MOST = 3  # inputs, and lines, that are told
LONGEST = 48  # characters of a line


def widening(witness: Witness) -> list[str]:
    """What is read inexactly, then the lines that make most of the width they are given, then what is undecided."""
    situation = witness.situation
    steps, _ = trace(situation.stage, [situation.exact[own] for own in situation.stage.parameters])
    found = {own: bounds_of(value) for own, value in situation.bounds.items()}
    read = {own: width for own, ends in found.items() if ends and (width := _width(ends))}
    lines = [*_lines(with_bounds(steps, situation.stage, situation.bounds, witness.profile))]
    inputs = [f"{own} as read: {compact(width)} ulp" for own, width in read.items()]
    return [*inputs[:MOST], *_steepest(lines, read), *witness.doubts]


def _lines(steps: Sequence[Step]) -> Iterator[tuple[Step, float]]:
    """The lines that give floats, each with its width; of a loop those of its last turn."""
    for step in steps:
        if isinstance(step.source, str):
            yield from _lines(step.inner[-1].inner if step.inner else ())
        elif step.bounds:
            yield step, _width(step.bounds)


def _steepest(lines: Sequence[tuple[Step, float]], read: Mapping[str, float]) -> list[str]:
    """The lines that widen most, in order. read: width of what the stage is given inexactly."""
    known, growths = dict(read), []
    for step, width in lines:
        given = max((known.get(name, 0.0) for name in _names(step)), default=0.0)
        growths.append(width / max(given, 1.0) if width < np.inf else float(given < np.inf))
        known[step.name] = width
    chosen = sorted(range(len(lines)), key=lambda k: -growths[k])[:MOST]
    return [_told(*lines[k]) for k in sorted(chosen) if growths[k] > 0]


def _names(step: Step) -> Iterator[str]:
    assert not isinstance(step.source, str)
    return tree.names_in(step.source)


def _told(step: Step, width: float) -> str:
    text = f"{step.name} = {step.text}"
    shortened = text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."
    return f"{shortened}: {compact(width)}{' ulp' if width < np.inf else ''}"


def _width(bounds: Bounds) -> float:
    """The width of the widest component, in units in the last place of the vector's greatest number; 0 of no floats."""
    low, high = (np.array(components(end)) for end in bounds)
    if low.dtype.kind != "f" or (low == high).all():
        return 0.0
    greatest = np.maximum(np.abs(low), np.abs(high)).max()
    if not np.isfinite(greatest):
        return float("inf")
    return float((high.astype(float) - low.astype(float)).max() / np.spacing(np.float32(greatest)))
