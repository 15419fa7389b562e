"""What the draw of the mesh may have done otherwise: its matrices, its viewport, its vertex stage, its state."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sss_ref.validation.accept.rebased import RASTERIZER
from sss_ref.validation.cause.cropped import cropped, undrawn
from sss_ref.validation.cause.hypothesis import MUTANT, SETTING, SOURCE, STATE, Charge, Hypothesis, any_of, fitting
from sss_ref.validation.cause.lying_off import lying_off
from sss_ref.validation.cause.mishaps import SAME_DEPTH, mishaps
from sss_ref.validation.cause.on_the_way import within
from sss_ref.validation.cause.puzzle import Puzzle
from sss_ref.validation.cause.redrawn import Redrawing, redrawings
from sss_ref.validation.cause.sample import Fit, fit_of
from sss_ref.validation.cause.vertex_stages import vertex_stages
from sss_ref.validation.verdict.outcomes import FAIL, outcome_map

LIKELY = 0.3  # of the wrong pixels and of the right ones that a draw explains before it is judged with all its snaps


def of_draws(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """What the draw of the mesh may have done otherwise: once a kind fits, those that tell less are not tried."""
    for kind in (_lying_off, _done_otherwise, _cut_off):
        found = [*kind(puzzle)]
        yield from found
        if fitting(found):
            return


def _done_otherwise(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """Other matrices, another state, and what may befall single triangles."""
    check, drawn, limit = puzzle.check, puzzle.drawn, puzzle.limit
    for charge, rank, draw in limit.within("draws", redrawings(_redrawing(puzzle))):
        holds = within(check, check.got, draw())
        if check.buffer == drawn.this_pass.draw.depth:
            holds |= np.abs(check.got.astype(np.float64) - draw()) <= SAME_DEPTH
        yield charge.fitting(puzzle.fit(holds), rank)
    if check.stage == RASTERIZER and drawn.visible:
        for text, same in limit.within("mishaps of the draw", mishaps(drawn.visible, check.buffer, check.got)):
            yield Charge(text, SETTING).fitting(puzzle.fit(same), STATE)


def _cut_off(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """What a test, a rectangle or blending makes of the picture as a whole."""
    for charge, holds in cropped(puzzle.case, puzzle.check, puzzle.limit):
        yield charge.fitting(puzzle.fit(holds), STATE)


def _redrawing(puzzle: Puzzle) -> Redrawing:
    return Redrawing(puzzle.case, puzzle.drawn.this_pass, puzzle.check.buffer)


def _lying_off(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """A picture that lies off by a part of a pixel, judged as one drawn so, wherever its corners snap."""
    check, todo = puzzle.check, _redrawing(puzzle)
    profile = replace(puzzle.case.profile, snap="any")
    for each in puzzle.limit.within("offsets of the draw", lying_off(todo, puzzle.limit)):
        if min(puzzle.fit(within(check, check.got, todo.draw(each.uniforms)))) >= LIKELY:
            again = todo.judged(each.uniforms, profile)
            both = check.where & again.where
            fit = fit_of((outcome_map(again) != FAIL)[both], puzzle.wrong[both])
            yield each.charge.fitting(fit, each.rank)


def of_vertices(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """Mistakes in the vertex stage, those that draw the same as one; or, without more, that nothing is drawn."""
    check, todo, alike = puzzle.check, _redrawing(puzzle), dict[bytes, tuple[Fit, list[str]]]()
    (vertex,) = todo.this_pass.draw.vertex_stages
    for charge, stage in puzzle.limit.within("mistakes in the vertex stage", vertex_stages(vertex)):
        drawn = todo.with_vertex(stage).draw()
        alike.setdefault(drawn.tobytes(), (puzzle.fit(within(check, check.got, drawn)), []))[1].append(charge.text)
    for fit, texts in alike.values():
        yield Charge(any_of(texts), SOURCE).fitting(fit, MUTANT)
    for charge, holds in undrawn(puzzle.case, check):
        yield charge.fitting(puzzle.fit(holds), MUTANT)
