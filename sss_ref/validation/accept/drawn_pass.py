"""A pass as a right processor may have drawn it, ready to be run at single pixels."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from sss_ref.interpret.arrays import draw_values, pixel_numbers
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import Work, buffer_value, uniform_value
from sss_ref.language.pipeline import PIXEL, Pass
from sss_ref.language.stage import Stage
from sss_ref.results.diff import bits
from sss_ref.validation.accept.acceptance import INTERPOLATION, around
from sss_ref.validation.accept.contraction import contracted
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import Known, KnownBuffer, Pixels, stacked
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import Visible


@dataclass(frozen=True)
class DrawnPass:
    """A pass, ready to be run at single pixels.

    read: name -> what is known of the buffers that its stages read. visible: what its rasterizer may show; None where
    that is fixed. drawing: what was dumped of what its stages hand on. profile: the processor that runs them. oracle:
    the buffers of its rendering.
    """

    work: Work
    read: Mapping[str, KnownBuffer]
    visible: Visible | None
    drawing: Drawing
    profile: Profile
    oracle: Mapping[str, np.ndarray]

    @property
    def this_pass(self) -> Pass:
        """The pass that is drawn."""
        return self.work.this_pass

    def reading(self, buffers: Mapping[str, KnownBuffer]) -> "DrawnPass":
        """The same, where its stages read these buffers."""
        return replace(self, read=buffers)

    @property
    def possible(self) -> np.ndarray:
        """Bool (H, W): where there may be a fragment; those of the work are there on every right processor."""
        stencil, where = self.read.get(self.this_pass.draw.stencil), self.work.fragments.where
        return where if stencil is None else stencil.high != 0

    def showing(self, wanted: Collection[str], at: Pixels, piece: np.ndarray) -> "DrawnPass":
        """The same with one piece at each of some pixels and nothing elsewhere, and the stages for some outputs."""
        pieces = np.full(self.work.fragments.where.shape, -1, np.int32)
        pieces[at] = piece
        fragments = replace(self.work.fragments, piece=pieces)
        return replace(self, work=replace(self.work, this_pass=self.this_pass.only({*wanted}), fragments=fragments))

    def given(self, at: Pixels) -> dict[str, Known]:
        """What the draw gives some pixels: name -> value, the varyings with all that they may be."""
        values = self.exactly_given(at)
        known = {name: Known.exactly(value) for name, value in values.items()}
        if self.visible is not None:
            varyings = [name for name in self._varyings if name in values]
            known |= {name: Known(values[name], self._spread(name, at, values)) for name in varyings}
        return known

    def exactly_given(self, at: Pixels) -> dict[str, Any]:
        """The same, each value as it is here; where no stage reads what comes of the mesh, the pixels alone."""
        of_mesh = {*self._varyings, *self.this_pass.draw.outputs}
        if any(of_mesh.intersection(stage.reads.values()) for stage in self.this_pass.stages):
            return draw_values(self.work, *at)
        return {PIXEL: pixel_numbers(*at)}

    @property
    def exactly(self) -> Work:
        """The work with each value as it is here: its stages read what was dumped of those before them."""
        read = {name: known.exact for name, known in self.read.items()}
        beside = {*self.this_pass.draw.outputs, *read}
        handed_on = {name: buffer for name, buffer in self.drawing.buffers.items() if name not in beside}
        return replace(self.work, buffers=read, handed_on=handed_on)

    def results(self, stage: Stage, inputs: Sequence[Any], at: Pixels) -> dict[str, Any]:
        """What a stage gives exactly, buffer -> value: what the oracle's gave where it ran and read the same."""
        kinds = {name: stage.outputs[own] for own, name in stage.writes.items()}
        alike = self._as_in_the_oracle.issuperset(stage.reads.values()) and set(kinds) <= set(self.oracle)
        if not (alike and self.work.fragments.where[at].all()):
            return stage.run(inputs)
        return {name: buffer_value(kind, self.oracle[name], *at) for name, kind in kinds.items()}

    @cached_property
    def _as_in_the_oracle(self) -> set[str]:
        """What the stages of a rectangle may read that holds what the oracle's do; nothing unless its stencil does.

        Nothing either of a draw, whose pixels may show other pieces, nor of rounds, which nobody keeps.
        """
        if self.this_pass.draw.vertex_stages or self.this_pass.fed_back:
            return set()
        there = {name: known.exact for name, known in self.read.items()} | dict(self.drawing.buffers)
        same = {name for name, buffer in there.items() if name in self.oracle and _same_bits(buffer, self.oracle[name])}
        if not same.issuperset(self.this_pass.draw.reads):
            return set()
        return {PIXEL, *same, *(set(self.work.uniforms) - set(there))}

    def running(self, stages: tuple[Stage, ...]) -> "DrawnPass":
        """The same with some of its stages; what they read of the others must have been dumped."""
        return replace(self, work=replace(self.work, this_pass=replace(self.this_pass, stages=stages)))

    def hands_bounds_on(self, stage: Stage, later: Stage) -> bool:
        """Whether one stage hands another what was not dumped, or what a compiler may take together with it."""
        shared = {*stage.writes.values()}.intersection(later.reads.values())
        return bool(shared) and (self.profile.contraction == "free" or not shared <= set(self.drawing.buffers))

    def outside(self, name: str, kind: Any, at: Pixels) -> Known:
        """What a stage reads that neither the draw nor a stage that runs here gives: a buffer or a uniform."""
        if name in self.read:
            return self.read[name].read(kind, at)
        if name not in self.work.uniforms:  # of a stage that was left out, see `running`
            return contracted(self.drawing.handed_on(name, kind, at), None, kind, self.profile)
        uniform = self.work.uniforms[name]
        if name in self.drawing.stored:
            return self.drawing.as_read(name, uniform).read(kind, at)
        return Known.exactly(uniform_value(kind, uniform))

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
        rounding = np.abs(own.astype(np.float64)).max(axis=1, keepdims=True) * INTERPOLATION
        return around(values[name], slack + rounding)


def _same_bits(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether two buffers hold the same, -0 apart from 0."""
    return a is b or (a.dtype == b.dtype and np.array_equal(bits(a), bits(b)))
