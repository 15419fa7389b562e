"""Every stage on its own: it gets what the other implementation had, and must give what that one made of it.

So an error shows where it is made and nowhere else. A texture is taken as dumped; so is a value that an earlier stage
of the same pass handed on, if it was dumped. What was not dumped is all that a right processor may have made of what
was; so is what lies between two rounds of a pass, which nobody dumps.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import chain
from typing import Any

import numpy as np

from sss_ref.dump.loss import EXACT, loss_of
from sss_ref.language.pipeline import Pass
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import KnownBuffer
from sss_ref.validation.accept.outside import nothing_drawn
from sss_ref.validation.accept.sparing import Sparing
from sss_ref.validation.accept.storage import depth_storage, moved
from sss_ref.validation.accept.walk import filled, untouched

EVERYWHERE = Sparing()
RASTERIZER = "rasterizer"  # the name under which what the draw itself writes is judged


@dataclass(frozen=True)
class Check:
    """A buffer that a stage wrote, beside what it should have written.

    where: bool (H, W), the pixels that are compared. expected, got: (H, W) or (H, W, C). reach: float64, of the same
    shape: how far a processor of the profile may be off. undecided: bool (H, W), where it may choose one of several
    texels or sides. covered: of the rasterizer, uint8 (H, W), whether a pixel must be covered (`MUST_NOT` to `MUST`).
    outside: of a stage, bool (H, W), the pixels on which nothing is drawn: there its background stands. fragments: of a
    stage, bool (H, W), the pixels on which it runs, compared or not. bounded: of a stage, uint8 (H, W), where its
    bounds were worked out (see `Sparing`): elsewhere the reach is what storage makes it; None: everywhere.
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
    outside: np.ndarray | None = None
    fragments: np.ndarray | None = None
    bounded: np.ndarray | None = None

    @property
    def comparable(self) -> np.ndarray:
        """Bool (H, W): the pixels that a whole judgement compares."""
        return self.where if self.fragments is None else self.fragments

    @property
    def where_bounded(self) -> "Check":
        """The check on the pixels of which bounds were worked out: all that differ, and a sample of the others."""
        return self if self.bounded is None else self.only_at(self.bounded != 0)

    def only_at(self, chosen: np.ndarray) -> "Check":
        """The check on some of its pixels, bool (H, W)."""
        outside = None if self.outside is None else self.outside & chosen
        fragments = self.comparable & chosen
        return replace(self, where=self.where & chosen, outside=outside, fragments=fragments)


def checks(case: Case, only: str | None = None, sparing: Sparing = EVERYWHERE) -> Iterator[Check]:
    """All buffers of a dump in stage order, or those of a single stage. sparing: as in `checks_of`."""
    for this_pass in case.oracle.scene.method.passes:
        if _written(this_pass, only) & set(case.drawing.buffers):
            yield from (check for check in checks_of(case, this_pass, sparing) if only in (None, check.stage))


def checks_of(case: Case, this_pass: Pass, sparing: Sparing = EVERYWHERE) -> Iterator[Check]:
    """All buffers of a dump that a pass wrote, in stage order.

    sparing: at which pixels bounds are worked out.
    """
    drawn = case.drawn(this_pass)
    for check in chain(_checks_of_draw(case, drawn), _checks_of_stages(case, drawn, sparing)):
        yield _as_stored(check, case)


def _written(this_pass: Pass, only: str | None) -> set[str]:
    """What a pass writes, or a single stage of it."""
    if only is None:
        return set(this_pass.values)
    named = {name for stage in this_pass.stages if stage.name == only for name in stage.writes.values()}
    return named | (set(this_pass.draw.outputs) if only == RASTERIZER else set())


def _as_stored(check: Check, case: Case) -> Check:
    """The check of what a texture kept."""
    is_depth = check.stage == RASTERIZER and check.got.dtype == np.float32
    default = depth_storage(case.profile) if is_depth else "float32"
    storage = case.drawing.stored.get(check.buffer, default)
    rounded = case.drawing.rounded.get(check.buffer, "float32")
    if loss_of(storage) == loss_of(rounded) == EXACT:
        return check
    return replace(check, reach=check.reach + moved(storage, rounded, check.expected, check.got))


def _checks_of_draw(case: Case, drawn: DrawnPass) -> Iterator[Check]:
    """What the rasterizer wrote: it may show any triangle that is visible on a right processor, as deep as it is."""
    oracle, dumped, visible = case.oracle, case.drawing.buffers, drawn.visible
    depth = drawn.this_pass.draw.depth
    before = case.drawing.before(depth, dumped[depth]) if depth in dumped else None
    reach = visible.reach(oracle.buffers, dumped, before) if visible else {}
    for name in (name for name in drawn.this_pass.draw.outputs if name in dumped):
        expected = oracle[name]
        near = reach.get(name, np.zeros(expected.shape))
        everywhere = np.ones(expected.shape, bool)
        check = Check(drawn.this_pass.name, RASTERIZER, name, everywhere, expected, dumped[name], near)
        yield replace(check, undecided=visible.several, covered=visible.covered) if visible else check


def _checks_of_stages(case: Case, drawn: DrawnPass, sparing: Sparing) -> Iterator[Check]:
    this_pass, dumped = drawn.this_pass, case.drawing.buffers
    where = drawn.work.fragments.where if drawn.visible else _same_triangle(case, drawn)
    writers = {name: stage.name for stage in this_pass.stages for name in stage.writes.values()}
    wanted = [name for name in writers if name in dumped or name in this_pass.fed_back]
    start = untouched(case.oracle, drawn, wanted)
    found = sparing.filled(drawn, where, start)
    outside = nothing_drawn(case, drawn)
    for name in (name for name in wanted if name in dumped):
        own = found[name]
        check = Check(this_pass.name, writers[name], name, where, own.exact, dumped[name], own.reach, own.doubt)
        check = replace(check, fragments=drawn.work.fragments.where, bounded=own.bounded)
        yield check if this_pass.is_register(name) else _with_background(check, outside, case.oracle.scene.clear(name))


def _with_background(check: Check, outside: np.ndarray, clear: Any) -> Check:
    """The check of a buffer that holds a number, or one for each channel, where nothing is drawn: exactly that."""
    expected, reach = check.expected.copy(), check.reach
    beside = outside if expected.ndim == 2 else outside[..., None]
    np.copyto(expected, clear, where=beside, casting="unsafe")
    np.copyto(reach, 0.0, where=beside)
    return replace(check, expected=expected, reach=reach, outside=outside)


def _same_triangle(case: Case, drawn: DrawnPass) -> np.ndarray:
    """The fragments on which both drew the same triangle; elsewhere the rasterizer is to be judged, not the stages."""
    where, draw, dumped = drawn.work.fragments.where, drawn.this_pass.draw, case.drawing.buffers
    if draw.vertex_stages:
        for name in (draw.triangle, draw.coverage):
            where = where & (case.oracle[name] == dumped[name]) if name in dumped else where
    return where


def last_round(case: Case, this_pass: Pass) -> DrawnPass:
    """A pass as it runs the last of its rounds."""
    drawn = case.drawn(this_pass)
    start, last = untouched(case.oracle, drawn, this_pass.fed_back), [drawn]

    def run(there: Mapping[str, KnownBuffer]) -> Mapping[str, KnownBuffer]:
        last.append(drawn.reading(there))
        return filled(last[-1], drawn.work.fragments.where, start) if start else {}

    this_pass.folded(drawn.read, run)
    return last[-1]
