"""What the stages give for what was drawn before them: a right stage is known by that, whatever it was given."""

from collections.abc import Mapping

import numpy as np

from sss_ref.capture.expected import Pixels, Reading, Sought
from sss_ref.capture.resemblance import Columns
from sss_ref.interpret.arrays import draw_values, run_stages
from sss_ref.interpret.work import Work, buffer_value
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import components
from sss_ref.rendering.draw import Buffers, Machine, Sketch, draw
from sss_ref.rendering.result import Result


class Rerun:
    """The passes of a rendering, to be run again on buffers that somebody else drew."""

    def __init__(self, oracle: Result, wanted: Mapping[str, Sought]) -> None:
        self.oracle, self.wanted = oracle, wanted
        passes = oracle.scene.method.passes
        self.passes = [one for one in passes if not one.on_demand and not one.feedback]
        self.sketches: dict[str, Sketch] = {}

    def readings(self, placed: Buffers) -> dict[str, Reading]:
        """Buffer -> what its stage makes of the buffers that are placed, where it reads any; those of ours besides."""
        found: dict[str, Reading] = {}
        for each in self.passes:
            if {*each.reads, *each.values} & set(placed):
                found |= self._of_pass(each, placed)
        return {name: reading for name, reading in found.items() if name not in placed}

    def _of_pass(self, this_pass: Pass, placed: Buffers) -> dict[str, Reading]:
        written = [name for name in this_pass.values if name in self.wanted]
        pixels = {id(self.wanted[name].pixels): self.wanted[name].pixels for name in written}
        return {
            name: Reading(Columns.of(values, self.wanted[name].readings[0].expected.drawn))
            for some in pixels.values()
            for name, values in self._values(this_pass, placed, some).items()
            if name in self.wanted and self.wanted[name].pixels is some
        }

    def _values(self, this_pass: Pass, placed: Buffers, pixels: Pixels) -> dict[str, np.ndarray]:
        """What the stages of a pass give at the pixels, each of them handed what is placed of those before it."""
        scene, sketch = self.oracle.scene, self._sketch(this_pass)
        at = pixels.rows, pixels.columns
        if not sketch.fragments.where[at].all():
            return {}
        work = Work(this_pass, sketch.fragments, scene.uniforms, {**self.oracle.buffers, **placed}, {}, {})
        kinds = this_pass.values
        found: dict[str, np.ndarray] = {}
        with np.errstate(all="ignore"):
            values = draw_values(work, *at)
            for _, _, results in run_stages(work, *at, values):
                found |= {name: _stacked(value, len(at[0])) for name, value in results.items()}
                values |= {name: buffer_value(kinds[name], placed[name], *at) for name in results if name in placed}
        return found

    def _sketch(self, this_pass: Pass) -> Sketch:
        if this_pass.name not in self.sketches:
            self.sketches[this_pass.name] = draw(self.oracle.scene, this_pass, self.oracle.buffers, Machine())
        return self.sketches[this_pass.name]


def _stacked(value: object, count: int) -> np.ndarray:
    """A value of the language at so many pixels: float64 (P, C), NaN as 0."""
    columns = [np.broadcast_to(np.asarray(part, np.float64), count) for part in components(value)]
    return np.nan_to_num(np.stack(columns, axis=-1))
