"""What is to be judged, and its passes as a right processor may have drawn them."""

from dataclasses import dataclass, field, replace

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.pipeline import Pass
from sss_ref.rendering.draw import Machine, draw, varying_columns
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer
from sss_ref.validation.accept.rasterizer.boxes import boxes_of
from sss_ref.validation.accept.rasterizer.visible import Visible, visible
from sss_ref.validation.accept.undumped import stand_ins


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
    _stand_ins: dict[str, KnownBuffer] = field(init=False, default_factory=dict)  # of this drawing, where known

    @property
    def of_oracle(self) -> "Case":
        """The same, had the oracle's buffers been drawn."""
        return replace(self, drawing=replace(self.drawing, buffers=self.oracle.buffers))

    def read(self, name: str) -> KnownBuffer:
        """What is known of a buffer that a shader reads: as it was dumped, or all that it may have held."""
        if name in self.drawing.buffers:
            return self.drawing.as_read(name, self.drawing.buffers[name])
        if name not in self._stand_ins:
            passes = self.oracle.scene.method.in_order()
            this_pass, later = next((each, later) for each, later in passes if name in each.outputs)
            wanted = (later & set(this_pass.outputs)) - set(self.drawing.buffers)
            self._stand_ins.update(stand_ins(self.oracle, self.drawn(this_pass), wanted))
        return self._stand_ins[name]

    def drawn(self, this_pass: Pass) -> DrawnPass:
        """A pass, with the triangles that were dumped, or those that every right processor shows."""
        scene, rasterized = self.oracle.scene, self.visible(this_pass)
        known = self._known(this_pass)
        exact = {name: each.exact for name, each in known.items()}
        if rasterized:
            boxes, (varyings, _) = rasterized.boxes, varying_columns(this_pass)
            size = boxes.viewport.width, boxes.viewport.height
            piece = rasterized.shown(self.drawing.buffers)
            fragments = Fragments(*size, boxes.primitives, piece, boxes.viewport.step, varyings)
        else:
            certain = {name: known[name].low for name in known if name == this_pass.draw.stencil}
            fragments = draw(scene, this_pass, exact | certain, self._machine).fragments
        work = Work(this_pass, fragments, scene.uniforms, exact, {}, {})
        return DrawnPass(work, known, rasterized, self.drawing, self.profile, self.oracle.buffers)

    def visible(self, this_pass: Pass) -> Visible | None:
        """What the rasterizer may show in a pass; a draw that reads no buffer is the same for all dumps, done once."""
        if not this_pass.draw.vertex_stages or self.profile.draws_exactly:
            return None
        if set(this_pass.draw.reads) & set(self.oracle.scene.method.values):
            return self._found(this_pass)
        if this_pass.name not in self._visible:
            self._visible[this_pass.name] = self._found(this_pass)
        return self._visible[this_pass.name]

    def _known(self, this_pass: Pass) -> dict[str, KnownBuffer]:
        """What is known of the buffers that a pass reads of those before it."""
        return {name: self.read(name) for name in sorted(this_pass.needs & set(self.oracle.scene.method.values))}

    def _found(self, this_pass: Pass) -> Visible:
        scene = self.oracle.scene
        boxes = boxes_of(scene, this_pass, self._known(this_pass), self.profile)
        return visible(boxes, this_pass.draw, scene.settings.irradiance_map.overlap, self.profile)

    @property
    def _machine(self) -> Machine:
        return Machine(subpixel_bits=self.profile.subpixel_bits, stops=False)
