"""From the record of a witness to the witness, judged with this installation's stages."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, get_origin

import numpy as np

from sss_ref.dump.loss import LOSSES, Loss
from sss_ref.errors import DumpError
from sss_ref.errors.wording import nearest, told
from sss_ref.interpret.intervals.value_sets import Texels
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Vector, components
from sss_ref.numerics.interval import Interval
from sss_ref.rules import RULES_VERSION
from sss_ref.scene_file.quantities import MEMORY_LIMIT
from sss_ref.validation.profile_file import profile_in
from sss_ref.validation.witness.bits_text import element_of, elements_in, ends_in, is_many, value_of
from sss_ref.validation.witness.element_runs import Index, blocks_in, shape_of_block
from sss_ref.validation.witness.situation import Situation, unbound
from sss_ref.validation.witness.stage_lookup import StageTold
from sss_ref.validation.witness.witness import DrawnValue, Witness
from sss_ref.validation.witness.witness_record import PLAIN, ElementsRecord, Read, Storage, WitnessRecord

REMEDY = "write it anew with validate --witness"


def recalled(record: WitnessRecord, where: str, others: Mapping[str, Stage] | None = None) -> Witness:
    """The witness of a record. where: its file, for messages. others: the user's stages, by name.

    Raises DumpError for a stage that is not there, and for what does not fit the one that is.
    """
    stage = stage_of(record, where, others or {})
    if record.output not in stage.outputs:
        raise DumpError(told(f"{where}: output", f"one of {', '.join(stage.outputs)}", record.output, REMEDY))
    exact, bounds = _inputs(record, stage, where)
    kind = stage.outputs[record.output]
    got = components(_parsed(f"{where}: got", lambda: value_of(kind, record.got)))
    drawn = DrawnValue(
        record.in_pass,
        record.buffer,
        record.at,
        _storage(f"{where}: stored", record.stored),
        _storage(f"{where}: rounded", record.rounded),
        record.device,
    )
    profile = profile_in(record.profile, f"{where}: profile")
    return Witness(Situation(stage, exact, bounds), record.output, np.array(got).astype(dtype_of(kind)), drawn, profile)


def stage_of(record: WitnessRecord, where: str, others: Mapping[str, Stage]) -> Stage:
    """The stage that a record is of, by its own names. Raises DumpError."""
    told_stage = StageTold(**dict(record.stage))
    stage = told_stage.found(others)
    if stage is None:
        known = "a stage of this version, or of the scene that is given"
        raise DumpError(told(f"{where}: stage", known, told_stage.name, "give the scene whose own stage it is"))
    return unbound(stage)


def _inputs(record: WitnessRecord, stage: Stage, where: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """What the stage reads, exactly and with all that it may be."""
    for name in set(record.reads) ^ set(stage.parameters):
        expected = ", ".join(stage.parameters)
        raise DumpError(told(f"{where}: reads", expected, f"{name} missing or beside them", REMEDY))
    inputs = {
        own: _parsed(f"{where}: reads.{own}", partial(_input, kind, record.reads[own], record.reads))
        for own, kind in stage.parameters.items()
    }
    return {own: exact for own, (exact, _) in inputs.items()}, {own: bounds for own, (_, bounds) in inputs.items()}


def _parsed(where: str, parse: Callable[[], Any]) -> Any:
    """What a part of the record holds. Raises DumpError where it is none."""
    try:
        return parse()
    except ValueError:
        raise DumpError(told(where, "bits of a value of its type", "others", REMEDY)) from None


def _input(kind: Any, given: Read, reads: Mapping[str, Read]) -> tuple[Any, Any]:
    """An input, exactly and with all that it may be."""
    if isinstance(given, ElementsRecord):
        return _elements(kind, given, _places(given.at, reads))
    if is_many(kind):
        raise ValueError("no elements")
    if isinstance(given, str):
        value = value_of(kind, given)
        return value, value
    low, high = (ends_in(kind, text) for text in (given.low, given.high))
    parts = [Interval(np.array([a]), np.array([b])) for a, b in zip(low, high, strict=True)]
    vector = isinstance(kind, type) and issubclass(kind, Vector)
    return value_of(kind, given.value), kind(*parts) if vector else parts[0]


def _places(at: str, reads: Mapping[str, Read]) -> str:
    """The places that are meant, which may be those of another parameter."""
    other = reads.get(at)
    return other.at if isinstance(other, ElementsRecord) else at


def _elements(kind: Any, given: ElementsRecord, at: str) -> tuple[Any, Any]:
    """A texture or an array that holds the elements that were read, and 0 elsewhere."""
    if not is_many(kind):
        raise ValueError("no single value")
    blocks = blocks_in(at)
    exact = get_origin(kind)(_filled(kind, given, blocks, given.bits))
    if isinstance(exact, Array) or not (given.low or given.high or given.span):
        return exact, exact
    low, high = (_filled(kind, given, blocks, text or given.bits) for text in (given.low, given.high))
    return exact, Texels(low, high, given.span)


def _filled(kind: Any, given: ElementsRecord, blocks: Sequence[Index], text: str) -> np.ndarray:
    """The elements as they lie in the whole."""
    element = element_of(kind)
    shape = (*reversed(given.size), *((CHANNELS[element],) if CHANNELS[element] > 1 else ()))
    if math.prod(shape) * dtype_of(element).itemsize > MEMORY_LIMIT:
        raise ValueError("too large")
    data = np.zeros(shape, dtype_of(element))  # pages that nobody writes take no memory
    elements, done = elements_in(kind, text), 0
    for block in blocks:
        part, count = data[block], math.prod(shape_of_block(block))
        if part.shape[: len(given.size)] != shape_of_block(block):
            raise ValueError("outside")
        part[...] = elements[done : done + count].reshape(part.shape)
        done += count
    if done != len(elements):
        raise ValueError("too many")
    return data


def _storage(where: str, given: Storage) -> str | Loss:
    if isinstance(given, dict):
        try:
            return Loss(**given)
        except TypeError:
            raise DumpError(told(where, "keys of a storage", ", ".join(given), REMEDY)) from None
    if given not in LOSSES and given != PLAIN:
        raise DumpError(told(where, f"{PLAIN} or one of {', '.join(LOSSES)}", given, nearest(given, LOSSES)))
    return given


@dataclass(frozen=True)
class Standing:
    """Whether what judges a witness is what wrote it. other: what is not, in words; empty if all is."""

    other: str

    @classmethod
    def of(cls, record: WitnessRecord, stage: Stage) -> "Standing":
        """Of a record and the stage that is here."""
        source = StageTold.of(stage).source
        if record.rules != RULES_VERSION:
            return cls(f"written by rules version {record.rules}, here it is {RULES_VERSION}")
        same = source == record.stage.source
        return cls("" if same else f"stage {stage.name} is {source} here, was {record.stage.source}")
