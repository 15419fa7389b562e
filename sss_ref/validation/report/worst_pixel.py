"""A stage at the pixel farthest out of reach: each line as it should have been and may be, and what was drawn."""

from dataclasses import replace

import numpy as np

from sss_ref.explanation.rows import Detail, Row, Section, row_of, section_of
from sss_ref.explanation.traces import StageTrace
from sss_ref.interpret.intervals.bounded_trace import bounds_of, with_bounds
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.trace import scalar, trace
from sss_ref.interpret.work import buffer_value
from sss_ref.validation.accept.acceptance import around
from sss_ref.validation.accept.known import Pixels
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.walk import StageRun


def worst_pixel(check: Check, pixel: tuple[int, int], run: StageRun, profile: Profile) -> Section:
    """The stage that is wrong, run at one pixel (column, row) with what was dumped before it."""
    section = section_of(_traced(run, profile), Detail(depth=1, glsl=True))
    section.rows.append(_got(check, run, (np.array([pixel[1]]), np.array([pixel[0]]))))
    return section


def _traced(run: StageRun, profile: Profile) -> StageTrace:
    """A stage at a single pixel, line by line."""
    inputs, names = [scalar(value) for value in run.inputs], run.stage.reads
    steps, writes = trace(run.stage, inputs)
    given = {own: known.bounds for own, known in run.read.items()}
    bounded = with_bounds(steps, run.stage, given, profile)
    bounds = {names[own]: bounds_of(value) for own, value in given.items()}
    return StageTrace(run.stage, dict(zip(names.values(), inputs, strict=True)), bounded, writes, bounds=bounds)


def _got(check: Check, run: StageRun, at: Pixels) -> Row:
    """What the dump holds, with the bounds that it was held against, storage included."""
    (kind,) = (run.stage.outputs[own] for own, name in run.stage.writes.items() if name == check.buffer)
    allowed = run.written[check.buffer].bounds
    if check.expected.dtype == np.float32:
        allowed = around(buffer_value(kind, check.expected, *at), check.reach[at].reshape(1, -1))
    row = row_of("got", f"{check.buffer}, as drawn", scalar(buffer_value(kind, check.got, *at)))
    return replace(row, bounds=bounds_of(allowed))
