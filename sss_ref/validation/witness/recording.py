"""From a witness to its record."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from sss_ref.dump.loss import EXACT, Loss, loss_of
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.language.types import components
from sss_ref.rules import RULES_VERSION
from sss_ref.validation.profile_file import tables_of
from sss_ref.validation.witness.bits_text import bits_of, elements_text, ends_of, is_many
from sss_ref.validation.witness.element_runs import Index, Place, blocks_of, blocks_text
from sss_ref.validation.witness.situation import Situation
from sss_ref.validation.witness.stage_lookup import StageTold
from sss_ref.validation.witness.widening import widening
from sss_ref.validation.witness.witness import Witness, as_value
from sss_ref.validation.witness.witness_record import (
    FORMAT,
    PLAIN,
    ElementsRecord,
    Read,
    StageRecord,
    ValueRecord,
    WitnessRecord,
)


def recorded(witness: Witness) -> WitnessRecord:
    """The record that `recalled` makes the same witness of."""
    drawn, situation, kind = witness.drawn, witness.situation, witness.kind
    values = {"got": witness.got, "expected": witness.expected}
    ends = dict(zip(("low", "high"), witness.allowed, strict=True))
    return WitnessRecord(
        format=FORMAT,
        rules=RULES_VERSION,
        stage=StageRecord(**asdict(StageTold.of(situation.stage))),
        output=witness.output,
        buffer=drawn.buffer,
        in_pass=drawn.pass_name,
        at=drawn.at,
        device=drawn.device,
        profile=tables_of(witness.profile),
        stored=_storage(drawn.stored),
        rounded=_storage(drawn.rounded),
        reads=_reads(situation, situation.reads(witness.profile)),
        why=tuple(widening(witness)),
        **{name: bits_of(kind, as_value(kind, array)) for name, array in (values | ends).items()},
    )


def _storage(storage: str | Loss) -> str | dict[str, float]:
    """A storage; those that lose nothing are one."""
    if loss_of(storage) == EXACT:
        return PLAIN
    if isinstance(storage, str):
        return storage
    default = asdict(EXACT)
    return {key: value for key, value in asdict(storage).items() if value != default[key]}


def _reads(situation: Situation, elements: Mapping[str, Iterable[Place]]) -> dict[str, Read]:
    reads: dict[str, Read] = {}
    known: dict[str, str] = {}  # places -> the first parameter that is read there
    for own, kind in situation.stage.parameters.items():
        exact, bounds = situation.exact[own], situation.bounds[own]
        if is_many(kind):
            blocks = blocks_of(elements[own])
            at = blocks_text(blocks)
            reads[own] = _elements(kind, exact, bounds, blocks, known.setdefault(at, at))
            known[at] = known[at] if known[at] != at else own
        else:
            reads[own] = _single(kind, exact, bounds)
    return reads


def _single(kind: Any, exact: Any, bounds: Any) -> str | ValueRecord:
    """A value, with its ends where it may be another."""
    text = bits_of(kind, exact)
    if bounds is exact:
        return text
    low, high = (_ends(kind, bounds, end) for end in ("low", "high"))
    return ValueRecord(value=text, low=low, high=high)


def _ends(kind: Any, bounds: Any, end: str) -> str:
    """One end of each component's interval."""
    return ends_of(kind, [np.ravel(getattr(part, end))[0] for part in components(bounds)])


def _elements(kind: Any, exact: Any, bounds: Any, blocks: Sequence[Index], at: str) -> ElementsRecord:
    """What may be read of a texture or an array; at: where, in words."""
    known = bounds if isinstance(bounds, Texels) else Texels(exact.data, exact.data)
    size = tuple(reversed(exact.data.shape[: exact.index_axes]))
    texts = {
        name: elements_text(kind, _listed(data, blocks))
        for name, data in (("bits", exact.data), ("low", known.low), ("high", known.high))
    }
    if texts["bits"] == texts["low"] == texts["high"]:
        texts = {"bits": texts["bits"]}
    return ElementsRecord(size=size, at=at, span=known.span, **texts)


def _listed(data: np.ndarray, blocks: Sequence[Index]) -> np.ndarray:
    """The numbers of all blocks, one after the other."""
    return np.concatenate([np.ravel(data[block]) for block in blocks] or [np.ravel(data)[:0]])
