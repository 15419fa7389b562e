"""Exams: each stage alone, handed the reference's own inputs, beside all that a right processor then writes.

Nothing that a device has drawn goes into another exam, so that its bounds are known beforehand, and a mistake shows
where it is made and nowhere else.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.work import Fragments, Work, buffer_value, uniform_value
from sss_ref.language.pipeline import PIXEL, Pass, ScreenDraw
from sss_ref.language.stage import Stage
from sss_ref.language.types import ivec2
from sss_ref.rendering.result import Result
from sss_ref.scene.scene import Scene
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer, pixels_of
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.walk import in_rounds, untouched
from sss_ref.webgl.allowed import Allowed, allowed
from sss_ref.webgl.reference_draw import reference_draw

WEBGL = replace(PROFILES["vulkan"], subpixel_bits=4, snap="any")  # whatever snaps to 4 bits or more stays within


@dataclass(frozen=True, eq=False)
class Exam:
    """A stage on its own.

    of: the pass that it belongs to. alone: a pass of that stage and nothing else, on a rectangle; all that it reads of
    others are buffers. where: bool (H, W), the pixels that are judged. given: what it reads beside uniforms, by name.
    right: buffer -> what it may write.
    """

    of: Pass
    alone: Pass
    where: np.ndarray
    given: Mapping[str, np.ndarray]
    right: Mapping[str, Allowed]

    @property
    def stage(self) -> Stage:
        """The stage that is judged."""
        (stage,) = self.alone.stages
        return stage

    def inputs(self, uniforms: Mapping[str, Any]) -> list[Any]:
        """What the stage reads at the pixels that are judged, row by row: one value for each parameter."""
        rows, columns = pixels_of(self.where)
        pixel = ivec2(columns.astype(np.int32), rows.astype(np.int32))

        def value(name: str, kind: Any) -> Any:
            if name in self.given:
                return buffer_value(kind, self.given[name], rows, columns)
            return pixel if name == PIXEL else uniform_value(kind, uniforms[name])

        return [value(self.stage.reads[own], kind) for own, kind in self.stage.parameters.items()]


def every_value(scene: Scene) -> list[str]:
    """All that the passes of a scene write without being asked, registers too."""
    return [name for each in scene.method.passes if not each.on_demand for name in each.values]


def exams(oracle: Result, this_pass: Pass) -> Iterator[Exam]:
    """The stages of a pass in order, but those that never run. oracle: a rendering that has kept every value."""
    if not this_pass.rounds:
        return
    drawn = reference_draw(oracle, this_pass)
    where, buffers = drawn.where, {**oracle.buffers, **drawn.varyings}
    for stage in this_pass.stages:
        rectangle = ScreenDraw() if this_pass.draw.vertex_stages else this_pass.draw
        alone = replace(this_pass, name=f"{this_pass.name}/{stage.name}", draw=rectangle, stages=(stage,))
        read = {*alone.needs} & {*buffers}
        given = {name: buffers[name] for name in sorted(read)}
        yield Exam(this_pass, alone, where, given, _right(oracle, alone, where, buffers))


def _right(oracle: Result, alone: Pass, where: np.ndarray, buffers: Mapping[str, np.ndarray]) -> dict[str, Allowed]:
    """What a stage alone may write at some pixels, and the background that stands beside them."""
    height, width = where.shape
    fragments = Fragments(width, height, stencil=where.astype(np.uint8))
    work = Work(alone, fragments, oracle.scene.uniforms, buffers, {}, {})
    known = {name: KnownBuffer.exactly(buffer) for name, buffer in buffers.items()}
    drawn = DrawnPass(work, known, None, Drawing({}), WEBGL, oracle.buffers)
    found = in_rounds(drawn, known, where, untouched(oracle, drawn, alone.values))
    return {name: allowed(_check(oracle, alone, name, found[name], where)) for name in alone.values}


def _check(oracle: Result, alone: Pass, name: str, known: KnownBuffer, where: np.ndarray) -> Check:
    """What is compared of a buffer: the pixels on which the stage runs and, of a stencil, those that it leaves out."""
    stage = alone.stages[0].name
    beside = ~where if alone.draw.stencil and not alone.is_register(name) else None
    reach = np.where(where if known.exact.ndim == 2 else where[..., None], known.reach, 0.0)
    expected = oracle[name]
    return Check(alone.name, stage, name, where, expected, expected, reach, known.doubt, outside=beside)
