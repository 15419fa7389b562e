"""What may be wrong with the stage itself: another matrix, another buffer, another stage, a place of its source."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from sss_ref.interpret.work import buffer_value
from sss_ref.language import Stage
from sss_ref.language.names import Name
from sss_ref.language.types import Array, Texture, mat3, mat4, vec3
from sss_ref.passes.buffers import BUFFERS
from sss_ref.scene_file.kernels import KERNELS
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.cause.hypothesis import (
    ENOUGH,
    INPUT,
    MUTANT,
    NUMBER,
    SOURCE,
    STAGE,
    Charge,
    Hypothesis,
    any_of,
)
from sss_ref.validation.cause.misreadings import misread
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.validation.cause.other_numbers import lengthened, other_numbers
from sss_ref.validation.cause.puzzle import Puzzle
from sss_ref.validation.cause.redrawn import other_matrices
from sss_ref.validation.cause.sample import Fit, Sample
from sss_ref.validation.clock import Limit

Tried = Iterator[tuple[Charge, Fit]]


def of_stages(sample: Sample, puzzle: Puzzle) -> Iterator[Hypothesis]:
    """Other numbers and other inputs of a stage, and other stages in its place."""
    yield from other_numbers(sample, puzzle.limit)
    kinds = (
        (NUMBER, other_uniforms(sample, puzzle.case)),
        (NUMBER, other_buffers(sample, puzzle.case)),
        (NUMBER, _other_values(sample, puzzle)),
        (STAGE, _kernels(sample)),
        (STAGE, _misreadings(sample)),
        (STAGE, _other_stages(sample, puzzle.others)),
    )
    for rank, tried in puzzle.limit.within("kinds of other inputs and stages", kinds):
        yield from (charge.fitting(fit, rank) for charge, fit in tried)


def other_uniforms(sample: Sample, case: Case) -> Tried:
    """Other matrices, the uniform of another light, and a position that is a little longer."""
    uniforms = case.oracle.scene.uniforms
    for own, kind in sample.stage.parameters.items():
        name = sample.stage.reads[own]
        if kind in (mat3, mat4) and name in uniforms:
            for text, matrix in other_matrices(name, uniforms):
                yield Charge(text, INPUT, (name,)), sample.fit(sample.with_inputs({own: kind(matrix)}))
        elif name in uniforms and kind is vec3:
            base = Name.of(name).base
            for other in (other for other in uniforms if other != name and Name.of(other).base == base):
                charge = Charge(f"{name} is {other}", INPUT, (name,))
                yield charge, sample.fit(sample.with_inputs({own: kind(*uniforms[other])}))
            yield from lengthened(sample, own, name)


def other_buffers(sample: Sample, case: Case) -> Tried:
    """The textures of another light."""
    there_are = {**case.oracle.buffers, **case.drawing.buffers}
    textures = {own: name for own, name in sample.stage.reads.items() if isinstance(sample.given[own], Texture)}
    numbers = {Name.of(name).light for name in there_are} - {0}
    for number in sorted(numbers):
        there = {own: str(Name.of(name).of_light(number)) for own, name in textures.items()}
        changed = {own: other for own, other in there.items() if other in there_are and other != textures[own]}
        if changed:
            given: dict[str, Any] = {own: Texture(there_are[other]) for own, other in changed.items()}
            names = " and ".join(f"{other} for {textures[own]}" for own, other in changed.items())
            charge = Charge(f"it reads {names}", INPUT, tuple(textures[own] for own in changed))
            yield charge, sample.fit(sample.with_inputs(given))


def _other_values(sample: Sample, puzzle: Puzzle) -> Tried:
    """Another value of the pass, of the same type and unit, in the place of one: a point for the point below it."""
    there_are = {**puzzle.case.oracle.buffers, **puzzle.case.drawing.buffers}
    outputs = puzzle.drawn.this_pass.outputs
    kinds = {name: (kind, BUFFERS[Name.of(name).base].unit) for name, kind in outputs.items() if name in there_are}
    for own, kind in sample.stage.parameters.items():
        name = sample.stage.reads[own]
        for other in (each for each in kinds if name in kinds and each != name and kinds[each] == kinds[name]):
            value = buffer_value(kind, there_are[other], *sample.at)
            charge = Charge(f"it reads {other} for {name}", SOURCE, (name,))
            yield charge, sample.fit(sample.with_inputs({own: value}))


def _misreadings(sample: Sample) -> Tried:
    """The ways in which such a stage is often misread."""
    for charge, value in misread(_own(sample), sample.own_name, sample.given):
        yield charge, sample.fit(stacked(value))


def _other_stages(sample: Sample, others: Mapping[str, Stage]) -> Tried:
    """Another of our stages that writes the buffer from the same inputs."""
    there = set(sample.stage.parameters)
    for name, stage in others.items():
        if name != _own(sample).name and sample.own_name in stage.outputs and set(stage.parameters) <= there:
            yield Charge(f"it computes {name}", SOURCE), sample.fit(sample.with_inputs({}, stage))


def _kernels(sample: Sample) -> Tried:
    """The taps of a kernel turned round."""
    given = sample.given
    if isinstance(given.get("tap_offset"), Array):
        offset, weight = given["tap_offset"].data, given["tap_weight"].data
        turned: dict[str, dict[str, np.ndarray]] = {
            "x and y of the taps are swapped": {"tap_offset": offset[:, ::-1]},
            "the taps are mirrored in x": {"tap_offset": offset * np.array([-1, 1], np.float32)},
            "the taps are mirrored in y": {"tap_offset": offset * np.array([1, -1], np.float32)},
            "the taps are mirrored in x and y": {"tap_offset": -offset},
            "the weights' red and blue are swapped": {"tap_weight": weight[:, ::-1]},
            "the weights belong to the taps in reverse order": {"tap_weight": weight[::-1]},
            "the weights are divided by their sum": {"tap_weight": weight / weight.sum(axis=0)},
        }
        for name, rows in KERNELS.items():
            table = np.array(rows, np.float32)
            turned[f"the kernel is {name}"] = {"tap_offset": table[:, :2], "tap_weight": table[:, 2:]}
        for text, changed in turned.items():
            arrays: dict[str, Any] = {name: Array(np.ascontiguousarray(data)) for name, data in changed.items()}
            names = tuple(sample.stage.reads[name] for name in arrays)
            yield Charge(text, INPUT, names), sample.fit(sample.with_inputs(arrays))


def mutated(sample: Sample, limit: Limit) -> Iterator[Hypothesis]:
    """Every mutant of the stage; a mistake that reads beside a texture is passed over.

    Those that compute the same are one explanation, which says several: no buffer can tell them apart.
    """
    few, alike = sample.thinned(), dict[bytes, tuple[Fit, list[str]]]()
    for mutant in limit.within("mistakes in the source", mutants(_own(sample))):
        values = _values_of(mutant, few)
        if values is None or min(few.fit(values)) < ENOUGH:
            continue
        whole = _values_of(mutant, sample)
        if whole is not None:
            alike.setdefault(whole.tobytes(), (sample.fit(whole), []))[1].append(mutant.description)
    for fit, texts in alike.values():
        yield Charge(any_of(texts), SOURCE).fitting(fit, MUTANT)


def _values_of(mutant: Mutant, sample: Sample) -> np.ndarray | None:
    """What a mutant writes; None where it reads beside a texture or array."""
    try:
        return stacked(mutant(*sample.inputs)[sample.name])
    except (IndexError, ValueError, TypeError):
        return None


def _own(sample: Sample) -> Stage:
    """The stage of a sample that has just one."""
    assert isinstance(sample.stage, Stage)
    return sample.stage
