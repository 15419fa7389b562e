"""Every stage on its own: it gets what the other implementation had, and must give what that one made of it.

So an error shows where it is made and nowhere else. A texture is taken as dumped; so is a value that an earlier stage
of the same pass handed on, if it was dumped. What was not dumped comes from the oracle.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from sss_ref.interpret import arrays
from sss_ref.interpret.arrays import CHUNK, draw_values, stage_input
from sss_ref.interpret.profile import Profile
from sss_ref.interpret.work import Fragments, Work, buffer_value
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import components
from sss_ref.methods.catalogue import method_of_scene
from sss_ref.raster.primitives import Primitives
from sss_ref.rendering import Rendering
from sss_ref.result import Result
from sss_ref.validation.acceptance import INTERPOLATION, acceptance_of, accepted, around
from sss_ref.validation.storage import step_of

Buffers = Mapping[str, np.ndarray]
Stored = Mapping[str, str]  # buffer -> its storage, of those that are not in float32
Pixels = tuple[np.ndarray, np.ndarray]  # rows, columns
RASTERIZER = "rasterizer"  # the name under which what the draw itself writes is judged


@dataclass(frozen=True)
class Check:
    """A buffer that a stage wrote, beside what it should have written.

    where: bool (H, W), the pixels that are compared. expected, got: (H, W) or (H, W, C). reach: float64, of the same
    shape: how far a processor of the profile may be off. undecided: bool (H, W), where it may choose one of several
    texels or sides.
    """

    pass_name: str
    stage: str
    buffer: str
    where: np.ndarray
    expected: np.ndarray
    got: np.ndarray
    reach: np.ndarray
    undecided: np.ndarray | None = None


@dataclass(frozen=True)
class Judgement:
    """How dumps are judged. profile: the processor that may have drawn them. stored: storages below float32."""

    profile: Profile
    stored: Stored = field(default_factory=dict)


def rebased(oracle: Result, dumped: Buffers) -> Rendering:
    """The rendering that stands where the dump does: with its buffers, and the oracle's where it has none."""
    rendering = Rendering(oracle.scene, arrays, None, set())
    rendering.buffers = {**oracle.buffers, **dumped}
    return rendering


def work_of(rendering: Rendering, one: Pass) -> Work:
    """A pass of that rendering, ready to be run at single pixels."""
    return Work(one, rendering.draw(one)[0], rendering.uniforms, rendering.buffers, {}, {})


def checks(oracle: Result, dumped: Buffers, how: Judgement) -> Iterator[Check]:
    """All buffers of a dump in stage order. oracle: the rendering of the same scene, with all buffers."""
    rendering = rebased(oracle, dumped)
    for one in method_of_scene(oracle.scene).passes:
        if not one.on_demand and set(one.outputs) & set(dumped):
            for check in _checks_of_pass(rendering, one, oracle, dumped, how):
                rounding = step_of(how.stored.get(check.buffer, ""), check.expected)
                yield replace(check, reach=check.reach + rounding)


def _checks_of_pass(
    rendering: Rendering, one: Pass, oracle: Result, dumped: Buffers, how: Judgement
) -> Iterator[Check]:
    work = work_of(rendering, one)
    fragments = work.fragments
    for name in (name for name in one.draw.outputs if name in dumped):
        yield _check_of_draw(one, name, fragments, oracle[name], dumped[name])
    if one.feedback:
        yield from _checks_of_rounds(rendering, one, fragments, dumped)
        return
    where = _comparable(one, fragments, oracle, dumped)
    found = {name: _empty(dumped[name]) for name in one.outputs if name in dumped and name not in one.draw.outputs}
    rows, columns = np.nonzero(where)
    for start in range(0, len(rows), CHUNK):
        at = rows[start : start + CHUNK], columns[start : start + CHUNK]
        _run(walk(work, at, dumped, how), at, found)
    writers = {name: stage.name for stage in one.stages for name in stage.writes.values()}
    for name, (expected, reach, undecided) in found.items():
        yield Check(one.name, writers[name], name, where, expected, dumped[name], reach, undecided)


def _checks_of_rounds(rendering: Rendering, one: Pass, fragments: Fragments, dumped: Buffers) -> Iterator[Check]:
    """A pass that runs in rounds is checked as a whole: what lies between two rounds is not dumped."""
    outputs = {own: rendering.buffers[name] for name, own in one.feedback.items()}
    for _ in range(one.rounds):
        fed = {name: outputs[own] for name, own in one.feedback.items()}
        outputs = rendering.shade(one, fragments, rendering.buffers | fed, list(outputs), check=False)
    for name in (name for name in outputs if name in dumped):
        reach = np.abs(outputs[name].astype(np.float64)) * 1e-5 * (outputs[name].dtype == np.float32)
        yield Check(one.name, one.stages[0].name, name, fragments.where, outputs[name], dumped[name], reach)


def _comparable(one: Pass, fragments: Fragments, oracle: Result, dumped: Buffers) -> np.ndarray:
    """The fragments on which both drew the same triangle; elsewhere the rasterizer is to be judged, not the stages."""
    where = fragments.where
    if isinstance(one.draw, MeshDraw):
        for name in (one.draw.triangle, one.draw.coverage):
            where = where & (oracle[name] == dumped[name]) if name in dumped else where
    return where


@dataclass(frozen=True)
class Step:
    """A stage at some pixels. accepted: buffer -> the intervals of what it may write, and the doubt."""

    stage: Stage
    inputs: list[Any]
    results: dict[str, Any]
    accepted: dict[str, tuple[Any, np.ndarray]]


def walk(work: Work, at: Pixels, dumped: Buffers, how: Judgement) -> Iterator[Step]:
    """Run the stages of a pass at some pixels, each with what was dumped of the stages before it.

    What the pass handed on had not been stored: a dump in few bits stands for the values around it, and what was not
    dumped for all that the stage before may have given.
    """
    values = draw_values(work, *at)
    spread = spread_varyings(work, at, values)
    for stage in work.one.stages:
        inputs = [stage_input(work, values, stage.reads[own], kind, at) for own, kind in stage.parameters.items()]
        with np.errstate(all="ignore"):
            results = dict(zip(stage.writes.values(), stage(*inputs), strict=True))
        named = zip(stage.reads.items(), inputs, strict=True)
        given = {own: spread.get(name, value) for (own, name), value in named}
        bounds = accepted(stage, given, how.profile, len(at[0]))
        yield Step(stage, inputs, results, bounds)
        values |= results
        spread |= {name: value for name, (value, _) in bounds.items()}
        for own, name in ((own, name) for own, name in stage.writes.items() if name in dumped):
            values[name] = buffer_value(stage.outputs[own], dumped[name], *at)
            del spread[name]
            if name in how.stored:
                spread[name] = around(values[name], step_of(how.stored[name], stacked(values[name])))


def _run(steps: Iterator[Step], at: Pixels, found: Mapping[str, Any]) -> None:
    """Note what each stage of a pass should have written at some pixels, and how near that must be."""
    for step in steps:
        for name in (name for name in step.results if name in found):
            expected, reach, undecided = found[name]
            base = stacked(step.results[name])
            expected[at] = _shaped(base, expected)
            near, undecided[at] = acceptance_of(base, *step.accepted[name])
            reach[at] = _shaped(near, reach)


def spread_varyings(work: Work, at: Pixels, values: Mapping[str, Any]) -> dict[str, Any]:
    """The varyings with all that is within half a subpixel, and the rounding of their interpolation."""
    fragments = work.fragments
    if fragments.primitives is None or fragments.piece is None:
        return {}
    slack = half_subpixel(fragments.primitives, fragments.primitives.attributes, fragments.piece[at], fragments.step)
    spread = {}
    for name, first in fragments.varyings.items():
        own = stacked(values[name]).astype(np.float64)
        rounding = np.abs(own).max(axis=-1, keepdims=True) * INTERPOLATION
        spread[name] = around(values[name], slack[:, first : first + own.shape[1]] + rounding)
    return spread


def half_subpixel(primitives: Primitives, attributes: np.ndarray, pieces: np.ndarray, step: int) -> np.ndarray:
    """How much attributes float32 (V, A) change over half a subpixel along both axes together, float64 (N, A).

    So far may interpolation on the triangle as it is, and on the snapped one, lie apart. Gradient of a linear function
    from its values a at three corners: 2 * area * gradient = sum of (a_i - a_0) * the edge opposite to i, turned.
    """
    corners = primitives.corners[pieces].T
    x, y = np.moveaxis(primitives.snapped[corners].astype(np.float64), -1, 0) / step
    a = attributes[corners].astype(np.float64)
    area = np.abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]))
    opposite = np.abs(np.roll(x, -1, 0) - np.roll(x, 1, 0)) + np.abs(np.roll(y, -1, 0) - np.roll(y, 1, 0))
    change = sum((np.abs(a[k] - a[0]) * opposite[k, :, None] for k in (1, 2)), np.zeros(a.shape[1:]))
    return change / area[:, None] * (0.5 / step)


def stacked(value: Any) -> np.ndarray:
    """The components of a value side by side: (N, C), or (1, C) for a uniform."""
    return np.stack([np.atleast_1d(part) for part in components(value)], axis=-1)


def _shaped(values: np.ndarray, buffer: np.ndarray) -> np.ndarray:
    return values[:, 0] if buffer.ndim == 2 else values


def _empty(buffer: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Room for what is expected, its reach, and whether it is undecided."""
    return np.zeros_like(buffer), np.zeros(buffer.shape), np.zeros(buffer.shape[:2], bool)


def _check_of_draw(one: Pass, name: str, fragments: Fragments, expected: np.ndarray, got: np.ndarray) -> Check:
    """What the rasterizer wrote; a depth may be off by half a subpixel, and by a step of a 24-bit depth buffer."""
    reach = np.zeros(expected.shape)
    if expected.dtype == np.float32 and fragments.primitives is not None and fragments.piece is not None:
        where = fragments.where
        depth = fragments.primitives.depth[:, None]
        slack = half_subpixel(fragments.primitives, depth, fragments.piece[where], fragments.step)
        reach[where] = slack[:, 0] + 2.0**-23
    return Check(one.name, RASTERIZER, name, np.ones(expected.shape, bool), expected, got, reach)
