"""The whole at once: intervals flow from stage to stage, and nothing of the dump goes in.

Where a stage passes with what was drawn before it but its buffer lies outside these bounds, it has inherited an error.
The bounds grow from stage to stage, so this is reported and decides nothing. Textures keep what the dump's do.
"""

from collections.abc import Collection, Iterable
from dataclasses import replace

import numpy as np

from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer
from sss_ref.validation.accept.rebased import RASTERIZER, Check
from sss_ref.validation.accept.walk import in_rounds, untouched

NOTHING = Drawing({})


def chained(case: Case, names: Collection[str]) -> dict[str, KnownBuffer]:
    """What these buffers, and those they are made of, may hold, drawn by a processor of the profile.

    The rasterizer's are the oracle's.
    """
    known: dict[str, KnownBuffer] = {}
    passes = case.oracle.scene.method.only(set(names)).passes
    wanted = {*names, *(name for each in passes for name in {*each.needs, *each.fed_back})}
    for this_pass in passes:
        drawn = replace(case.of_oracle.drawn(this_pass), drawing=NOTHING)
        known |= untouched(case.oracle, drawn, [name for name in this_pass.values if name in wanted])
        start = {name: known[name] for stage in this_pass.stages for name in stage.writes.values() if name in wanted}
        written = in_rounds(drawn, {**drawn.read, **known}, drawn.work.fragments.where, start)
        known |= {name: case.drawing.kept(name, buffer) for name, buffer in written.items()}
    return known


def within_bounds(case: Case, compared: Iterable[Check]) -> dict[str, int | None]:
    """How many compared pixels of each buffer lie within the chained bounds; None of what the rasterizer writes.

    Bounds hold the oracle, so a buffer that has its bits needs none, and no pass runs that no other buffer needs.
    """
    judged = {check.buffer: check for check in compared}
    of_stages = {name: check for name, check in judged.items() if check.stage != RASTERIZER}
    bounds = chained(case, [name for name, check in of_stages.items() if not _is_the_oracle(case, check)])
    counts = {name: int(check.where.sum()) for name, check in of_stages.items()}
    counts |= {name: _within(case, check, bounds[name]) for name, check in of_stages.items() if name in bounds}
    return {name: counts.get(name) for name in judged}


def _is_the_oracle(case: Case, check: Check) -> bool:
    """Whether the dump holds at all compared pixels what the oracle does, and numbers."""
    if check.buffer not in case.oracle.buffers:
        return False
    ours = case.oracle[check.buffer]
    if np.array_equal(ours, check.got):
        return True
    return bool(np.array_equal(*(np.atleast_3d(buffer)[check.where] for buffer in (ours, check.got))))


def _within(case: Case, check: Check, bounds: KnownBuffer) -> int:
    """How many compared pixels lie within the bounds of a buffer."""
    low, high = (np.atleast_3d(end)[check.where].astype(np.float64) for end in (bounds.low, bounds.high))
    got = case.drawing.before(check.buffer, np.atleast_3d(check.got)[check.where])
    return int(((got.high >= low) & (got.low <= high)).all(axis=1).sum())
