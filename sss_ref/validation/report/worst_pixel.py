"""A stage at the pixel farthest out of reach: each line as it should have been and may be, and what was drawn."""

from dataclasses import replace

import numpy as np

from sss_ref.explanation.rows import Detail, Row, Section, row_of, section_of
from sss_ref.explanation.traces import StageTrace
from sss_ref.interpret.intervals.bounded_trace import bounds_of, with_bounds
from sss_ref.interpret.trace import scalar, trace
from sss_ref.interpret.work import buffer_value
from sss_ref.validation.accept.acceptance import around
from sss_ref.validation.accept.drawn import Buffers, Drawn, Pixels
from sss_ref.validation.accept.rebased import RASTERIZER, Check, Judgement, Step, walk


def worst_pixel(
    check: Check, pixel: tuple[int, int], pass_drawn: Drawn, buffers: Buffers, how: Judgement
) -> Section | None:
    """The stage that is wrong, at one pixel (column, row), with what was dumped before it; None of the rasterizer."""
    if check.stage == RASTERIZER:
        return None
    at = np.array([pixel[1]]), np.array([pixel[0]])
    step = next(step for step in walk(pass_drawn, at, buffers, how) if check.buffer in step.results)
    section = section_of(_traced(step, how), Detail(depth=1, glsl=True))
    section.rows.append(_drawn(check, step, at))
    return section


def _traced(step: Step, how: Judgement) -> StageTrace:
    """A stage at a single pixel, line by line."""
    inputs, names = [scalar(value) for value in step.inputs], step.stage.reads
    steps, writes = trace(step.stage, inputs)
    bounded = with_bounds(steps, step.stage, step.given, how.profile)
    bounds = {names[own]: bounds_of(value) for own, value in step.given.items()}
    return StageTrace(step.stage, dict(zip(names.values(), inputs, strict=True)), bounded, writes, bounds=bounds)


def _drawn(check: Check, step: Step, at: Pixels) -> Row:
    """What the dump holds, with the bounds that it was held against, storage included."""
    (kind,) = (step.stage.outputs[own] for own, name in step.stage.writes.items() if name == check.buffer)
    allowed, _ = step.accepted[check.buffer]
    if check.expected.dtype == np.float32:
        allowed = around(buffer_value(kind, check.expected, *at), check.reach[at].reshape(1, -1))
    drawn = row_of("got", f"{check.buffer}, as drawn", scalar(buffer_value(kind, check.got, *at)))
    return replace(drawn, bounds=bounds_of(allowed))
