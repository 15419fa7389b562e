"""What is to be judged, and its passes as a right processor may have drawn them, ready to be run at single pixels."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from sss_ref.interpret.arrays import draw_values
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import Fragments, Work, uniform_value
from sss_ref.language.pipeline import Pass
from sss_ref.numerics.ieee import Ieee
from sss_ref.rendering.draw import Machine, draw, varying_columns
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import INTERPOLATION, around
from sss_ref.validation.accept.dumped import Buffers, Drawing
from sss_ref.validation.accept.known import Known, KnownBuffer, Pixels, stacked
from sss_ref.validation.accept.rasterizer.boxes import boxes_of
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import Visible, visible


@dataclass(frozen=True)
class DrawnPass:
    """A pass, ready to be run at single pixels.

    read: name -> what is known of the buffers that its stages read. visible: what its rasterizer may show; None where
    that is fixed. drawing: what was dumped of what its stages hand on. profile: the processor that runs them.
    """

    work: Work
    read: Mapping[str, KnownBuffer]
    visible: Visible | None
    drawing: Drawing
    profile: Profile

    @property
    def this_pass(self) -> Pass:
        """The pass that is drawn."""
        return self.work.this_pass

    def reading(self, buffers: Mapping[str, KnownBuffer]) -> "DrawnPass":
        """The same, where its stages read these buffers."""
        return replace(self, read=buffers)

    def given(self, at: Pixels) -> dict[str, Known]:
        """What the draw gives some pixels: name -> value, the varyings with all that they may be."""
        values = draw_values(self.work, *at)
        known = {name: Known.exactly(value) for name, value in values.items()}
        if self.visible is not None:
            known |= {name: Known(values[name], self._spread(name, at, values)) for name in self._varyings}
        return known

    def outside(self, name: str, kind: Any, at: Pixels) -> Known:
        """What a stage reads that neither the draw nor a stage of this pass gives: a buffer or a uniform."""
        if name in self.read:
            return self.read[name].read(kind, at)
        return Known.exactly(uniform_value(kind, self.work.uniforms[name]))

    @property
    def _varyings(self) -> Mapping[str, int]:
        return self.work.fragments.varyings

    def _spread(self, name: str, at: Pixels, values: Mapping[str, Any]) -> Any:
        """A varying with all that other vertex stages and snaps may give, and the rounding of its interpolation."""
        fragments = self.work.fragments
        assert fragments.piece is not None and self.visible is not None
        own = stacked(values[name])
        columns = slice(self._varyings[name], self._varyings[name] + own.shape[1])
        slack = interpolation_slack(self.visible.boxes, fragments.piece[at], at[1], at[0], own, columns)
        rounding = np.abs(own.astype(np.float64)).max(axis=-1, keepdims=True) * INTERPOLATION
        return around(values[name], slack + rounding)


@dataclass(frozen=True)
class Case:
    """What is to be judged: what another implementation drew of a scene.

    oracle: the rendering of the same scene, with all buffers. drawing: what was drawn. profile: the processor that may
    have drawn it.
    """

    oracle: Result
    drawing: Drawing
    profile: Profile
    _visible: dict[str, Visible] = field(default_factory=dict)  # pass -> what its rasterizer may show, where known

    @property
    def of_oracle(self) -> "Case":
        """The same, had the oracle's buffers been drawn."""
        return replace(self, drawing=replace(self.drawing, buffers=self.oracle.buffers))

    @cached_property
    def buffers(self) -> Buffers:
        """What was drawn, and what the oracle has of all else."""
        return {**self.oracle.buffers, **self.drawing.buffers}

    def drawn(self, this_pass: Pass) -> DrawnPass:
        """A pass, with the triangles that were dumped, or those that every right processor shows."""
        scene, rasterized = self.oracle.scene, self.visible(this_pass)
        if rasterized:
            boxes, (varyings, _) = rasterized.boxes, varying_columns(this_pass)
            size = boxes.viewport.width, boxes.viewport.height
            piece = rasterized.shown(self.drawing.buffers)
            fragments = Fragments(*size, boxes.primitives, piece, boxes.viewport.step, varyings)
        else:
            fragments = draw(scene, this_pass, self.buffers, self._machine).fragments
        read = {name for stage in this_pass.stages for name in stage.reads.values()} & set(self.buffers)
        known = {name: self.drawing.as_read(name, self.buffers[name]) for name in read}
        work = Work(this_pass, fragments, scene.uniforms, self.buffers, {}, {})
        return DrawnPass(work, known, rasterized, self.drawing, self.profile)

    def visible(self, this_pass: Pass) -> Visible | None:
        """What the rasterizer may show in a pass; a draw that reads no buffer is the same for all dumps, done once."""
        if not this_pass.draw.vertex_stages or isinstance(self.profile.arithmetic, Ieee):
            return None
        if set(this_pass.draw.reads) & set(self.buffers):
            return self._found(this_pass)
        if this_pass.name not in self._visible:
            self._visible[this_pass.name] = self._found(this_pass)
        return self._visible[this_pass.name]

    def _found(self, this_pass: Pass) -> Visible:
        scene = self.oracle.scene
        boxes = boxes_of(scene, this_pass, self.buffers, self.profile)
        return visible(boxes, this_pass.draw, scene.settings.irradiance_map.overlap, self.profile)

    @property
    def _machine(self) -> Machine:
        return Machine(subpixel_bits=self.profile.subpixel_bits, stops=False)
