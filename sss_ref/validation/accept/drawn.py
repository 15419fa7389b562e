"""A pass as a right processor may have drawn it, ready for its stages to be run at single pixels."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.pipeline import Pass
from sss_ref.language.types import components
from sss_ref.numerics.ieee import Ieee
from sss_ref.rendering.draw import Machine, draw, varying_columns
from sss_ref.rendering.result import Result
from sss_ref.validation.accept.acceptance import INTERPOLATION, around
from sss_ref.validation.accept.rasterizer.boxes import boxes_of
from sss_ref.validation.accept.rasterizer.interpolation import interpolation_slack
from sss_ref.validation.accept.rasterizer.visible import Visible, visible

Buffers = Mapping[str, np.ndarray]
Seen = dict[str, Visible]  # pass -> what its rasterizer may show
Pixels = tuple[np.ndarray, np.ndarray]  # rows, columns


@dataclass(frozen=True)
class Drawn:
    """A pass, ready to be run at single pixels. visible: what its rasterizer may show; None where that is fixed."""

    work: Work
    visible: Visible | None = None


class Rebased:
    """A rendering that stands where a dump does: with its buffers, and the oracle's where it has none."""

    def __init__(self, oracle: Result, dumped: Buffers, profile: Profile, seen: Seen | None = None) -> None:
        self.scene, self.machine = oracle.scene, Machine(subpixel_bits=profile.subpixel_bits, stops=False)
        self.buffers = {**oracle.buffers, **dumped}
        self.dumped, self.profile = dumped, profile
        self.seen = {} if seen is None else seen

    def drawn(self, one: Pass) -> Drawn:
        """A pass, with the triangles that were dumped, or those that every right processor shows."""
        seen = self.visible(one)
        if seen:
            boxes, (varyings, _) = seen.boxes, varying_columns(one)
            size = boxes.viewport.width, boxes.viewport.height
            fragments = Fragments(*size, boxes.primitives, seen.shown(self.dumped), boxes.viewport.step, varyings)
        else:
            fragments = draw(self.scene, one, self.buffers, self.machine).fragments
        return Drawn(Work(one, fragments, self.scene.uniforms, self.buffers, {}, {}), seen)

    def visible(self, one: Pass) -> Visible | None:
        """What the rasterizer may show in a pass; a draw that reads no buffer is the same for all dumps, done once."""
        if not one.draw.vertex_stages or isinstance(self.profile.arithmetic, Ieee):
            return None
        if one.name not in self.seen or set(one.draw.reads) & set(self.buffers):
            boxes = boxes_of(self.scene, one, self.buffers, self.profile)
            self.seen[one.name] = visible(boxes, one.draw, self.scene.settings.irradiance_map.overlap, self.profile)
        return self.seen[one.name]


def spread_varyings(pass_drawn: Drawn, at: Pixels, values: Mapping[str, Any]) -> dict[str, Any]:
    """The varyings with all that other vertex stages and snaps may give, and the rounding of their interpolation."""
    if pass_drawn.visible is None:
        return {}
    fragments, spread = pass_drawn.work.fragments, {}
    assert fragments.piece is not None
    for name, first in fragments.varyings.items():
        own = stacked(values[name])
        columns = slice(first, first + own.shape[1])
        slack = interpolation_slack(pass_drawn.visible.boxes, fragments.piece[at], at[1], at[0], own, columns)
        rounding = np.abs(own.astype(np.float64)).max(axis=-1, keepdims=True) * INTERPOLATION
        spread[name] = around(values[name], slack + rounding)
    return spread


def stacked(value: Any) -> np.ndarray:
    """The components of a value side by side: (N, C), or (1, C) for a uniform."""
    return np.stack([np.atleast_1d(part) for part in components(value)], axis=-1)
