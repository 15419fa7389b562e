"""What may be wrong with the stages before the one that is wrong, as far as nobody has seen what they gave."""

from collections.abc import Callable, Iterator

import numpy as np

from sss_ref.language import Stage
from sss_ref.validation.cause.chain import Chain
from sss_ref.validation.cause.hypothesis import ENOUGH, MUTANT, NUMBER, SOURCE, STAGE, Charge, Hypothesis, any_of
from sss_ref.validation.cause.mistaken import stages_instead, stages_misread, stages_mutated
from sss_ref.validation.cause.of_stages import Tried, other_buffers, other_uniforms
from sss_ref.validation.cause.other_numbers import other_numbers
from sss_ref.validation.cause.puzzle import Puzzle
from sss_ref.validation.cause.sample import Fit, Sample
from sss_ref.validation.clock import Limit

Mistakes = Callable[[Stage], Iterator[tuple[Charge, Stage]]]


def of_suspects(row: Sample, puzzle: Puzzle) -> Iterator[Hypothesis]:
    """What may be wrong with the stages before, whose results were not dumped, or with what all of them read."""
    yield from other_numbers(row, puzzle.limit)
    kinds = (
        (NUMBER, other_uniforms(row, puzzle.case)),
        (NUMBER, other_buffers(row, puzzle.case)),
        (STAGE, _before(row, stages_misread)),
        (STAGE, _before(row, lambda stage: stages_instead(stage, puzzle.others))),
    )
    for rank, tried in puzzle.limit.within("kinds of mistakes in stages before", kinds):
        yield from (charge.fitting(fit, rank) for charge, fit in tried)


def mutated_suspects(row: Sample, limit: Limit) -> Iterator[Hypothesis]:
    """Mistakes in the source of the stages before the last; those that compute the same are one explanation."""
    few, alike = row.thinned(), dict[bytes, tuple[Fit, list[str]]]()
    for charge, chain in limit.within("mistakes in the source of stages before", _chains(row, stages_mutated)):
        values = _carried(few, chain)
        if values is None or min(few.fit(values)) < ENOUGH:
            continue
        whole = _carried(row, chain)
        if whole is not None:
            alike.setdefault(whole.tobytes(), (row.fit(whole), []))[1].append(charge.text)
    for fit, texts in alike.values():
        yield Charge(any_of(texts), SOURCE).fitting(fit, MUTANT)


def _before(row: Sample, mistakes: Mistakes) -> Tried:
    """Mistakes in the stages of a chain before its last."""
    for charge, chain in _chains(row, mistakes):
        values = _carried(row, chain)
        if values is not None:
            yield charge, row.fit(values)


def _chains(row: Sample, mistakes: Mistakes) -> Iterator[tuple[Charge, Chain]]:
    assert isinstance(row.stage, Chain)
    for number, stage in enumerate(row.stage.before):
        for charge, wrong in mistakes(stage):
            yield charge, row.stage.with_stage(number, wrong)


def _carried(sample: Sample, chain: Chain) -> np.ndarray | None:
    """What a chain gives; None where it reads beside a texture or array, or what it has not."""
    try:
        return sample.with_inputs({}, chain)
    except (IndexError, KeyError, ValueError, TypeError):
        return None
