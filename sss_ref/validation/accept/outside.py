"""The pixels on which a pass draws nothing, on any right processor: there a buffer holds what it was cleared to."""

import numpy as np

from sss_ref.language.pipeline import Draw
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.rasterizer.visible import MUST, MUST_NOT


def nothing_drawn(case: Case, drawn: DrawnPass) -> np.ndarray:
    """Bool (H, W): where no fragment of a pass is, beyond doubt.

    Of a draw of the mesh where nothing must be, or where nothing need be and the dump says that nothing is. A rectangle
    that a stencil limits leaves out what the dump's stencil does, or what every right one does.
    """
    draw = drawn.this_pass.draw
    if draw.vertex_stages:
        return _beside_the_mesh(case, drawn)
    if not draw.stencil:
        return np.zeros(drawn.work.fragments.where.shape, bool)
    if draw.stencil in case.drawing.buffers:
        return _shows_nothing(case.drawing.buffers[draw.stencil])
    writers = [each for each in case.oracle.scene.method.passes if draw.stencil in each.draw.outputs]
    if not writers:  # stages write it, so their bounds say where it can only be 0
        return _shows_nothing(case.read(draw.stencil).high)
    return _beside_the_mesh(case, case.drawn(writers[0]))


def _beside_the_mesh(case: Case, drawn: DrawnPass) -> np.ndarray:
    draw, dumped = drawn.this_pass.draw, case.drawing.buffers
    masks = [_shows_nothing(dumped[name]) for name in (draw.triangle, draw.coverage) if name in dumped]
    empty = np.logical_and.reduce(masks) if masks else None
    if drawn.visible is None:
        nothing = _oracles_background(case, draw, drawn)
        return nothing if empty is None else nothing & empty
    covered = drawn.visible.covered
    return covered == MUST_NOT if empty is None else (covered != MUST) & empty


def _oracles_background(case: Case, draw: Draw, drawn: DrawnPass) -> np.ndarray:
    return _shows_nothing(case.oracle[draw.extent]) if draw.extent else ~drawn.work.fragments.where


def _shows_nothing(mask: np.ndarray) -> np.ndarray:
    """Bool (H, W) of a coverage, 0 or 1, or of triangle numbers, -1 for none."""
    return mask == 0 if mask.dtype == np.uint8 else mask < 0
