"""What may be wrong with a stage: every explanation is tried on the very pixels, and those that fit are ranked.

Tried are: another number for each uniform of the stage, another stage in its place, the kernel turned round, every
mutant of its source, and what happens to a buffer on its way (rows flipped, channels swapped, sRGB, fewer bits); the
same of the stages before it that nobody has seen the results of; of a draw, what its vertex stage and its triangles may
have come to (matrices, culling, depth test, a part of a pixel, fewer subpixel bits).
"""

from collections.abc import Iterable, Iterator
from itertools import chain

from sss_ref.validation.cause.beside import backgrounds
from sss_ref.validation.cause.dilation import dilations
from sss_ref.validation.cause.hypothesis import SETTING, STATE, TELLING, Charge, Hypothesis, fitting
from sss_ref.validation.cause.of_draws import of_draws, of_vertices
from sss_ref.validation.cause.of_stages import mutated, of_stages
from sss_ref.validation.cause.of_suspects import mutated_suspects, of_suspects
from sss_ref.validation.cause.on_the_way import changes_on_the_way
from sss_ref.validation.cause.puzzle import Puzzle
from sss_ref.validation.cause.sample import chain_sample_of, fit_of, sample_of

MOST_SAID = 8


def hypotheses(puzzle: Puzzle) -> list[Hypothesis]:
    """The explanations that fit, the best first; none for so few wrong pixels that nearly all would.

    An explanation must bring the wrong pixels within reach and leave the right ones there. The cheap ones come first,
    and once one fits, what is less simple is not looked for: the stages before, the draw, a mistake in the source.
    """
    if puzzle.wrong.sum() < TELLING:
        beside = backgrounds(puzzle.check, puzzle.drawn)
        return fitting(Charge(text, SETTING).fitting((share, 1.0), STATE) for text, share in beside)
    for tried in _in_turn(puzzle):
        found = fitting(tried)
        if found:
            return sorted(found, key=lambda each: each.order)[:MOST_SAID]
    return []


def _in_turn(puzzle: Puzzle) -> Iterator[Iterable[Hypothesis]]:
    """Kinds of explanations, the simple ones first."""
    check, drawn, is_draw = puzzle.check, puzzle.drawn, bool(puzzle.drawn.this_pass.draw.vertex_stages)
    sample = sample_of(check, drawn, puzzle.wrong)
    yield chain(_of_buffers(puzzle), of_stages(sample, puzzle) if sample else ())
    row = chain_sample_of(check, drawn, puzzle.wrong)
    if row:
        yield of_suspects(row, puzzle)
    if is_draw:
        yield of_draws(puzzle)
    if sample:
        yield mutated(sample, puzzle.limit)
    if is_draw:
        yield of_vertices(puzzle)
    if row:
        yield mutated_suspects(row, puzzle.limit)


def _of_buffers(puzzle: Puzzle) -> Iterator[Hypothesis]:
    """What may have happened to the buffer on its way, and to the maps that it is made from."""
    for charge, holds, where in changes_on_the_way(puzzle.check):
        yield charge.fitting(fit_of(holds[where], puzzle.wrong[where]), STATE)
    for charge, holds in dilations(puzzle.case, puzzle.check):
        yield charge.fitting(puzzle.fit(holds), STATE)
