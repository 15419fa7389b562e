"""Stages as compiled kernels, run on strips: packs of fragments that lie side by side in rows of memory.

Every stage is compiled once, as loops over the fragments of a strip (source.py, lower.py), and its machine code is kept
between processes. A pass is the list of its stages' calls (planned.py); a strip goes through all of them before the
next one does, so that what a stage hands on is still in the processor's cache.
"""

from collections.abc import Mapping
from concurrent.futures import Executor
from typing import Any

import numpy as np

from sss_ref.interpret.finite import is_finite
from sss_ref.interpret.kernel.border import carried_over, is_dilation
from sss_ref.interpret.kernel.fragment_rows import put_words
from sss_ref.interpret.kernel.modules import address_of
from sss_ref.interpret.kernel.planned import StagePlan, cleared, planned
from sss_ref.interpret.kernel.program import INDEX, STRIP, Program, run_rows
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.layout import FLOAT32
from sss_ref.language.pipeline import CLIP_POSITION, Pass

BAND = 32  # rows of pixels a task


def run_vertices(
    this_pass: Pass,
    mesh: Mapping[str, np.ndarray],
    uniforms: Mapping[str, Any],
    varyings: Mapping[str, int],
    columns: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Run the vertex stage of a pass: clip positions float32 (V, 4) and the wanted varyings, float32 (V, columns).

    mesh: vertex attribute -> float32 (V, C). uniforms: with the textures that the stage reads, as in `Work`.
    varyings: name -> first column.
    """
    (stage,) = this_pass.draw.vertex_stages
    count = len(mesh["position"])
    clip_position, attributes = np.empty((count, 4), FLOAT32), np.empty((count, columns), FLOAT32)
    plan = StagePlan(uniforms, mesh, {})
    plan.stage(stage)
    kinds = {stage.writes[own]: kind for own, kind in stage.outputs.items()}
    plan.put(stage.writes[CLIP_POSITION], clip_position, kinds[stage.writes[CLIP_POSITION]])
    for name, first in varyings.items():
        tables = [plan.program.address(attributes), columns, first, len(plan.values[name])]
        plan.program.add(address_of(put_words), [INDEX, *plan.values[name]], tables=tables)
    run_rows(np.ones((1, count), np.bool_), 0, plan.program.calls, Program().calls, scratch(plan.program))
    return clip_position, attributes


def run_fragments(work: Work, pool: Executor | None) -> bool:
    """Run the stages of a pass on all its fragments and fill its outputs, by bands of rows over the pool.

    Gives whether all outputs are finite.
    """
    dilates = is_dilation(work.this_pass)
    filling, clearing = planned(work), Program() if dilates else cleared(work)
    calls, clears = filling.calls, clearing.calls

    def band(first_row: int) -> bool:
        rows = slice(first_row, min(first_row + BAND, work.fragments.height))
        where = carried_over(work, rows) if dilates else covered(work.fragments, rows)
        run_rows(where, first_row, calls, clears, scratch(filling))
        return is_finite(work, rows)

    return all([*(pool.map if pool else map)(band, range(0, work.fragments.height, BAND))])


def covered(fragments: Fragments, rows: slice) -> np.ndarray:
    """Bool (R, W): which pixels of some rows hold a fragment."""
    if fragments.piece is not None:
        return np.asarray(fragments.piece[rows] >= 0)
    if fragments.stencil is not None:
        return np.asarray(fragments.stencil[rows] != 0)
    return np.ones((rows.stop - rows.start, fragments.width), np.bool_)


def scratch(program: Program) -> np.ndarray:
    """Memory for the rows of a strip."""
    return np.empty(program.used * STRIP, FLOAT32)
