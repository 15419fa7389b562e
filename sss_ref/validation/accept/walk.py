"""The stages of a pass one after the other, each with all that is known of what it reads and writes.

A stage gets what was dumped of the stages before it in its pass; of what was not dumped, all that they may have given.
"""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.interpret.arrays import in_chunks, run_stages
from sss_ref.language.layout import dtype_of, shape_of
from sss_ref.language.stage import Stage
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import accepted
from sss_ref.validation.accept.contraction import contracted
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import Known, KnownBuffer, Pixels


@dataclass(frozen=True)
class StageRun:
    """A stage at some pixels. read: parameter -> what is known of it. written: buffer -> what the stage may give."""

    stage: Stage
    read: Mapping[str, Known]
    written: Mapping[str, Known]

    @property
    def inputs(self) -> list[Any]:
        """What it reads, one value for each parameter."""
        return [known.exact for known in self.read.values()]


def walk(drawn: DrawnPass, at: Pixels) -> Iterator[StageRun]:
    """Run the stages of a pass at some pixels."""
    known, dumped = drawn.given(at), drawn.drawing
    for stage in drawn.this_pass.stages:
        named = [(own, stage.reads[own], kind) for own, kind in stage.parameters.items()]
        read = {own: known[name] if name in known else drawn.outside(name, kind, at) for own, name, kind in named}
        results = drawn.results(stage, [each.exact for each in read.values()], at)
        bounds = accepted(stage, {own: each.bounds for own, each in read.items()}, drawn.profile, len(at[0]))
        written = {name: Known(value, *bounds[name]) for name, value in results.items()}
        yield StageRun(stage, read, written)
        known |= written
        for own, name in ((own, name) for own, name in stage.writes.items() if name in dumped.buffers):
            kind = stage.outputs[own]
            known[name] = contracted(dumped.handed_on(name, kind, at), written[name], kind, drawn.profile)


def run_stage(drawn: DrawnPass, at: Pixels, buffer: str) -> StageRun:
    """The stage that writes a buffer, at some pixels."""
    return next(run for run in walk(drawn.running(_group_of(drawn, buffer)), at) if buffer in run.written)


def exact_run(drawn: DrawnPass, at: Pixels, buffer: str) -> tuple[Stage, list[Any]]:
    """The stage that writes a buffer, and what it reads exactly at some pixels, one value for each parameter."""
    group = drawn.running(_group_of(drawn, buffer))
    runs = run_stages(group.exactly, *at, group.exactly_given(at))
    return next((stage, inputs) for stage, inputs, results in runs if buffer in results)


def groups(drawn: DrawnPass) -> list[tuple[Stage, ...]]:
    """The stages of a pass, those together of which one needs the bounds of what another gives: it was not dumped."""
    stages, found = drawn.this_pass.stages, list[set[int]]()
    for number, stage in enumerate(stages):
        joined = {number}
        for group in found:
            if any(drawn.hands_bounds_on(stages[each], stage) for each in group):
                joined |= group
        found = [group for group in found if not group <= joined] + [joined]
    return [tuple(stages[each] for each in sorted(group)) for group in found]


def _group_of(drawn: DrawnPass, buffer: str) -> tuple[Stage, ...]:
    """The group with the stage that writes a buffer."""
    return next(group for group in groups(drawn) if any(buffer in stage.writes.values() for stage in group))


def filled(drawn: DrawnPass, where: np.ndarray, start: Mapping[str, KnownBuffer]) -> dict[str, KnownBuffer]:
    """What the stages of a pass may write into the wanted buffers, run once; on large pictures by several threads.

    where: bool (H, W), the pixels at which they run. start: what the buffers hold elsewhere; left as it is.
    """
    buffers = {name: buffer.copy() for name, buffer in start.items()}

    def fill(at: Pixels) -> None:
        for run in walk(drawn, at):
            for name in (name for name in run.written if name in buffers):
                buffers[name].write(run.written[name], at)

    side_by_side(fill, where)
    return buffers


def side_by_side(fill: Callable[[Pixels], None], where: np.ndarray) -> None:
    """Do something with all pixels of a mask, bool (H, W), some at a time; on large pictures by several threads."""
    chunks = list(in_chunks(where))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for _ in (pool.map if len(chunks) > 1 else map)(fill, chunks):
            pass


def in_rounds(
    drawn: DrawnPass, there: Mapping[str, KnownBuffer], where: np.ndarray, start: Mapping[str, KnownBuffer]
) -> Mapping[str, KnownBuffer]:
    """The same of a pass that runs as often as it has rounds; each reads what the one before it may have written.

    there: what the first round reads. where, start: as in `filled`.
    """
    return drawn.this_pass.folded(there, lambda read: filled(drawn.reading(read), where, start))


def untouched(oracle: Result, drawn: DrawnPass, names: Iterable[str]) -> dict[str, KnownBuffer]:
    """What stays in buffers where no stage runs: what the oracle has there, or 0 in a register, where nobody looks."""
    kinds, size = drawn.this_pass.values, oracle.scene.size(drawn.this_pass)
    blank = {name: np.zeros(shape_of(kinds[name], *size), dtype_of(kinds[name])) for name in names}
    return {name: KnownBuffer.exactly(oracle.buffers.get(name, blank[name])) for name in names}
