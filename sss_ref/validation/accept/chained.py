"""The whole at once: intervals flow from stage to stage, and nothing of the dump goes in.

Where a stage passes with what was drawn before it but its buffer lies outside these bounds, it has inherited an error.
The bounds grow from stage to stage, so this is reported and decides nothing.
"""

from collections.abc import Collection, Mapping
from typing import Any, get_origin

import numpy as np

from sss_ref.interpret.arrays import draw_values, in_chunks, stage_input
from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.interpret.work import Work
from sss_ref.language import Texture
from sss_ref.language.layout import CHANNELS, dtype_of, shape_of
from sss_ref.language.pipeline import Pass
from sss_ref.language.stage import Stage
from sss_ref.language.types import components
from sss_ref.numerics.interval import Interval
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import accepted
from sss_ref.validation.accept.drawn import Drawn, Pixels, Rebased, Seen, spread_varyings

Bounds = dict[str, tuple[np.ndarray, np.ndarray]]  # buffer -> the least and the largest it may hold


def chained(oracle: Result, profile: Profile, on_demand: Collection[str] = (), seen: Seen | None = None) -> Bounds:
    """What every buffer of a scene may hold, drawn by a processor of the profile; the rasterizer's are the oracle's.

    on_demand: names beside the method's outputs. seen: what rasterizers may show, as far as it is known; added to.
    """
    rendering, method = Rebased(oracle, oracle.buffers, profile, seen), oracle.scene.method
    wanted = {*method.outputs, *on_demand}
    bounds: Bounds = {}
    for one in method.only(wanted).passes:
        start = {name: _start(oracle, name, kind, oracle.scene.size(one)) for name, kind in one.values.items()}
        bounds |= {name: (value, value) for name, value in start.items() if name in wanted}
        _run_rounds(rendering.drawn(one), one, bounds, profile)
    return bounds


def _start(oracle: Result, name: str, kind: Any, size: tuple[int, int]) -> np.ndarray:
    """What stays in a buffer where no stage runs: what the oracle has there, or 0 in a register, where nobody looks."""
    return oracle[name] if name in oracle.buffers else np.zeros(shape_of(kind, *size), dtype_of(kind))


def _run_rounds(pass_drawn: Drawn, one: Pass, bounds: Bounds, profile: Profile) -> None:
    """Run a pass as often as it has rounds; `bounds` gets what it writes."""
    wanted = [name for name in one.values if name in bounds]

    def run(read: Mapping[str, tuple[np.ndarray, np.ndarray]]) -> Bounds:
        outputs = {name: (bounds[name][0].copy(), bounds[name][1].copy()) for name in wanted}
        for at in in_chunks(pass_drawn.work.fragments.where):
            _run(pass_drawn, at, dict(read), outputs, profile)
        return outputs

    bounds |= one.folded(bounds, run)


def _run(pass_drawn: Drawn, at: Pixels, bounds: Bounds, outputs: Bounds, profile: Profile) -> None:
    """Run the stages of a pass on intervals at some pixels."""
    work = pass_drawn.work
    values = draw_values(work, *at)
    spread = spread_varyings(pass_drawn, at, values)
    for stage in work.this_pass.stages:
        given = {own: _given(work, stage, own, values, spread, bounds, at) for own in stage.parameters}
        for name, (value, _) in accepted(stage, given, profile, len(at[0])).items():
            spread[name] = value
            if name in outputs:
                for end, array in zip(("low", "high"), outputs[name], strict=True):
                    parts = [getattr(part, end) for part in components(value)]
                    array[at] = parts[0] if array.ndim == 2 else np.stack(parts, axis=-1)


def _given(
    work: Work,
    stage: Stage,
    own: str,
    values: Mapping[str, Any],
    spread: Mapping[str, Any],
    bounds: Bounds,
    at: Pixels,
) -> Any:
    """What a stage reads: a texture or a value between its bounds, or what is known exactly."""
    name, kind = stage.reads[own], stage.parameters[own]
    if name in spread:
        return spread[name]
    if name in bounds and name not in values:
        low, high = bounds[name]
        if get_origin(kind) is Texture:
            return Texels(low, high)
        ends = [end[at] != 0 if kind is bool else end[at] for end in (low, high)]
        parts = [Interval(*(end if end.ndim == 1 else end[:, k] for end in ends)) for k in range(CHANNELS[kind])]
        return kind(*parts) if len(parts) > 1 else parts[0]
    return stage_input(work, values, name, kind, at)
