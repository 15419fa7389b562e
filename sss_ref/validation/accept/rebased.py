"""Every stage on its own: it gets what the other implementation had, and must give what that one made of it.

So an error shows where it is made and nowhere else. A texture is taken as dumped; so is a value that an earlier stage
of the same pass handed on, if it was dumped. What was not dumped comes from the oracle.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.dump.loss import Loss
from sss_ref.interpret.arrays import draw_values, in_chunks, stage_input
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import Texels, componentwise
from sss_ref.interpret.work import Fragments, buffer_value
from sss_ref.language.pipeline import Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import Texture
from sss_ref.numerics.interval import Interval
from sss_ref.rendering.draw import shade
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import acceptance_of, accepted
from sss_ref.validation.accept.drawn import Buffers, Drawn, Pixels, Rebased, Seen, spread_varyings, stacked
from sss_ref.validation.accept.storage import before_storage, depth_storage, lost_in_storage, step_of

Stored = Mapping[str, str | Loss]  # buffer -> its storage, of those that are not in float32
RASTERIZER = "rasterizer"  # the name under which what the draw itself writes is judged


@dataclass(frozen=True)
class Check:
    """A buffer that a stage wrote, beside what it should have written.

    where: bool (H, W), the pixels that are compared. expected, got: (H, W) or (H, W, C). reach: float64, of the same
    shape: how far a processor of the profile may be off. undecided: bool (H, W), where it may choose one of several
    texels or sides. covered: of the rasterizer, uint8 (H, W), whether a pixel must be covered (`MUST_NOT` to `MUST`).
    """

    pass_name: str
    stage: str
    buffer: str
    where: np.ndarray
    expected: np.ndarray
    got: np.ndarray
    reach: np.ndarray
    undecided: np.ndarray | None = None
    covered: np.ndarray | None = None


@dataclass(frozen=True)
class Judgement:
    """How dumps are judged.

    profile: the processor that may have drawn them. stored: storages below float32. rounded: buffer -> the storage of
    its texture, of those whose files have fewer bits than that.
    """

    profile: Profile
    stored: Stored = field(default_factory=dict)
    rounded: Stored = field(default_factory=dict)

    def before(self, name: str, held: np.ndarray) -> Interval:
        """All that may have been computed, float64, where the dump of a buffer holds this: texture and file round."""
        file = before_storage(self.stored.get(name, "float32"), held)
        texture = self.rounded.get(name, "float32")
        return Interval(before_storage(texture, file.low).low, before_storage(texture, file.high).high)

    def as_read(self, name: str, value: Any) -> Any:
        """A dumped buffer as the shader read it: exactly, unless its file has fewer bits than the texture had."""
        if name not in self.rounded:
            return value
        read = partial(before_storage, self.stored.get(name, "float32"))
        if isinstance(value, Texture):
            held = read(value.data)
            return Texels(held.low, held.high)
        return componentwise(read, value)


def checks(oracle: Result, dumped: Buffers, how: Judgement, seen: Seen | None = None) -> Iterator[Check]:
    """All buffers of a dump in stage order. oracle: the rendering of the same scene, with all buffers."""
    rendering = Rebased(oracle, dumped, how.profile, seen)
    for one in oracle.scene.method.passes:
        if set(one.values) & set(dumped):
            for check in _checks_of_pass(rendering, one, oracle, dumped, how):
                yield _as_stored(check, how)


def _as_stored(check: Check, how: Judgement) -> Check:
    """The check of what a texture kept."""
    is_depth = check.stage == RASTERIZER and check.got.dtype == np.float32
    storage = how.stored.get(check.buffer, depth_storage(how.profile) if is_depth else "float32")
    texture = step_of(how.rounded.get(check.buffer, "float32"), check.got)
    return replace(check, reach=check.reach + lost_in_storage(storage, check.expected, check.got) + texture)


def _checks_of_pass(rendering: Rebased, one: Pass, oracle: Result, dumped: Buffers, how: Judgement) -> Iterator[Check]:
    pass_drawn = rendering.drawn(one)
    fragments = pass_drawn.work.fragments
    yield from _checks_of_draw(pass_drawn, oracle, dumped)
    if one.fed_back:
        yield from _checks_of_rounds(rendering, one, fragments, dumped, how)
        return
    where = fragments.where if pass_drawn.visible else _same_triangle(one, fragments, oracle, dumped)
    found = {name: _empty(dumped[name]) for name in one.values if name in dumped and name not in one.draw.outputs}
    for at in in_chunks(where):
        _run(walk(pass_drawn, at, dumped, how), at, found)
    writers = {name: stage.name for stage in one.stages for name in stage.writes.values()}
    for name, (expected, reach, undecided) in found.items():
        yield Check(one.name, writers[name], name, where, expected, dumped[name], reach, undecided)


def _checks_of_draw(pass_drawn: Drawn, oracle: Result, dumped: Buffers) -> Iterator[Check]:
    """What the rasterizer wrote: it may show any triangle that is visible on a right processor, as deep as it is."""
    one, seen = pass_drawn.work.this_pass, pass_drawn.visible
    reach = seen.reach(oracle.buffers, dumped) if seen else {}
    for name in (name for name in one.draw.outputs if name in dumped):
        expected = oracle[name]
        near = reach.get(name, np.zeros(expected.shape))
        check = Check(one.name, RASTERIZER, name, np.ones(expected.shape, bool), expected, dumped[name], near)
        yield replace(check, undecided=seen.several, covered=seen.covered) if seen else check


def _checks_of_rounds(
    rendering: Rebased, one: Pass, fragments: Fragments, dumped: Buffers, how: Judgement
) -> Iterator[Check]:
    """A pass that runs in rounds is checked as a whole: what lies between two rounds is not dumped."""
    scene, machine, names = rendering.scene, rendering.machine, [*one.fed_back]
    outputs = one.folded(rendering.buffers, lambda read: shade(scene, one, fragments, read, names, machine))
    for name in (name for name in outputs if name in dumped):
        reach = np.abs(outputs[name].astype(np.float64)) * 1e-5 * (outputs[name].dtype == np.float32)
        for read in (read for read, own in one.repetition["feedback"].items() if own == name and read in how.rounded):
            reach += step_of(how.stored.get(read, ""), outputs[name])  # a mean of texels is as far off as they are
        yield Check(one.name, one.stages[0].name, name, fragments.where, outputs[name], dumped[name], reach)


def _same_triangle(one: Pass, fragments: Fragments, oracle: Result, dumped: Buffers) -> np.ndarray:
    """The fragments on which both drew the same triangle; elsewhere the rasterizer is to be judged, not the stages."""
    where = fragments.where
    if one.draw.vertex_stages:
        for name in (one.draw.triangle, one.draw.coverage):
            where = where & (oracle[name] == dumped[name]) if name in dumped else where
    return where


@dataclass(frozen=True)
class Step:
    """A stage at some pixels.

    inputs: one for each parameter. given: parameter -> what it may be as well, on intervals. results: buffer -> value.
    accepted: buffer -> the intervals of what the stage may write, and the doubt.
    """

    stage: Stage
    inputs: list[Any]
    given: dict[str, Any]
    results: dict[str, Any]
    accepted: dict[str, tuple[Any, np.ndarray]]


def walk(pass_drawn: Drawn, at: Pixels, dumped: Buffers, how: Judgement) -> Iterator[Step]:
    """Run the stages of a pass at some pixels, each with what was dumped of the stages before it.

    What the pass handed on had not been stored: a dump in few bits stands for the values around it, and what was not
    dumped for all that the stage before may have given.
    """
    work = pass_drawn.work
    values = draw_values(work, *at)
    spread = spread_varyings(pass_drawn, at, values)
    for stage in work.this_pass.stages:
        inputs = [stage_input(work, values, stage.reads[own], kind, at) for own, kind in stage.parameters.items()]
        with np.errstate(all="ignore"):
            results = dict(zip(stage.writes.values(), stage(*inputs), strict=True))
        named = zip(stage.reads.items(), inputs, strict=True)
        given = {own: spread[name] if name in spread else how.as_read(name, value) for (own, name), value in named}
        bounds = accepted(stage, given, how.profile, len(at[0]))
        yield Step(stage, inputs, given, results, bounds)
        values |= results
        spread |= {name: value for name, (value, _) in bounds.items()}
        for own, name in ((own, name) for own, name in stage.writes.items() if name in dumped):
            values[name] = buffer_value(stage.outputs[own], dumped[name], *at)
            del spread[name]
            if name in how.stored:
                spread[name] = componentwise(partial(how.before, name), values[name])


def _run(steps: Iterator[Step], at: Pixels, found: Mapping[str, Any]) -> None:
    """Note what each stage of a pass should have written at some pixels, and how near that must be."""
    for step in steps:
        for name in (name for name in step.results if name in found):
            expected, reach, undecided = found[name]
            base = stacked(step.results[name])
            expected[at] = _shaped(base, expected)
            near, undecided[at] = acceptance_of(base, *step.accepted[name])
            reach[at] = _shaped(near, reach)


def _shaped(values: np.ndarray, buffer: np.ndarray) -> np.ndarray:
    return values[:, 0] if buffer.ndim == 2 else values


def _empty(buffer: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Room for what is expected, its reach, and whether it is undecided."""
    return np.zeros_like(buffer), np.zeros(buffer.shape), np.zeros(buffer.shape[:2], bool)
