"""What may be wrong with a stage: every explanation is tried on the very pixels, and those that fit are ranked.

Tried are: another number for each uniform of the stage, another stage in its place, the kernel turned round, every
mutant of its source, and what happens to a buffer on its way (rows flipped, channels swapped, sRGB, fewer bits); of a
draw, what its triangles may have come to (culling, depth test, half a pixel, fewer subpixel bits).
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sss_ref.language import Stage
from sss_ref.language.names import Name
from sss_ref.language.types import Array, Texture, mat3, mat4, vec3
from sss_ref.scene_file.kernels import KERNELS
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.accept.rebased import RASTERIZER, Check
from sss_ref.validation.cause.beside import backgrounds
from sss_ref.validation.cause.dilation import dilations
from sss_ref.validation.cause.lying_off import lying_off
from sss_ref.validation.cause.mishaps import SAME_DEPTH, mishaps
from sss_ref.validation.cause.misreadings import misread
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.validation.cause.on_the_way import changes_on_the_way, within
from sss_ref.validation.cause.other_numbers import lengthened, other_numbers
from sss_ref.validation.cause.redrawn import Redrawing, other_matrices, redrawings
from sss_ref.validation.cause.sample import Fit, Sample, fit_of, sample_of
from sss_ref.validation.clock import Limit
from sss_ref.validation.verdict.outcomes import FAIL, outcome_map

TELLING = 8  # wrong pixels from which on explanations mean something
ENOUGH = 0.98  # of the wrong pixels that an explanation must bring within reach, and of the right ones to stay there
ALL = 0.999
LIKELY = 0.3  # the same of a draw that is then judged with all that it may snap to
MOST_ALIKE = 4  # mistakes that compute the same, said one by one
MOST_SAID = 8


STATE, NUMBER, STAGE, MUTANT = range(4)  # what is the simpler explanation comes first


@dataclass(frozen=True)
class Hypothesis:
    """An explanation in words.

    share: of the wrong pixels tried, those that it brings within reach. kept: of the right ones, those that stay so.
    rank: how simple it is, one of STATE, NUMBER, STAGE and MUTANT.
    """

    text: str
    share: float
    kept: float
    rank: int = STATE

    @property
    def order(self) -> tuple[bool, int, float]:
        """What explains all comes first, then what is simple, then what explains more."""
        return min(self.share, self.kept) < ALL, self.rank, -self.share - self.kept


def hypotheses(
    case: Case, check: Check, drawn: DrawnPass, others: Mapping[str, Stage], limit: Limit
) -> list[Hypothesis]:
    """The explanations that fit, the best first; none for so few wrong pixels that nearly all would.

    An explanation must bring the wrong pixels within reach and leave the right ones there. others: all stages by name,
    to be tried in the place of this one. limit: the time for it; the cheap ones come first, and once one fits, neither
    the draw nor a mistake in the source is looked for.
    """
    wrong = check.where & (outcome_map(check) == FAIL)
    if wrong.sum() < TELLING:
        return _fitting([Hypothesis(text, share, 1.0) for text, share in backgrounds(check, drawn)])
    found = [Hypothesis(text, *fit_of(holds[where], wrong[where])) for text, holds, where in changes_on_the_way(check)]
    found += [
        Hypothesis(text, *fit_of(holds[check.where], wrong[check.where])) for text, holds in dilations(case, check)
    ]
    sample = sample_of(check, drawn, wrong)
    if sample is not None:
        found += [Hypothesis(text, *fit, NUMBER) for text, fit in other_numbers(sample, limit)]
        kinds = (
            (NUMBER, _other_uniforms(sample, case)),
            (NUMBER, _other_buffers(sample, case)),
            (STAGE, _kernels(sample)),
            (STAGE, _misreadings(sample)),
            (STAGE, _other_stages(sample, others)),
        )
        for rank, tried in limit.within("kinds of other inputs and stages", kinds):
            found += [Hypothesis(text, *fit, rank) for text, fit in tried]
    if drawn.this_pass.draw.vertex_stages and not _fitting(found):
        found += _of_draws(case, check, drawn, wrong, limit)
    if sample is not None and not _fitting(found):
        found += [Hypothesis(text, *fit, MUTANT) for text, fit in _mutants(sample, limit)]
    return sorted(_fitting(found), key=lambda each: each.order)[:MOST_SAID]


def _fitting(found: list[Hypothesis]) -> list[Hypothesis]:
    return [each for each in found if min(each.share, each.kept) >= ENOUGH]


def _of_draws(case: Case, check: Check, drawn: DrawnPass, wrong: np.ndarray, limit: Limit) -> Iterator[Hypothesis]:
    """What the draw of the mesh may have done otherwise; what was measured makes other offsets needless."""
    todo = Redrawing(case, drawn.this_pass, check.buffer)
    measured = [*_lying_off(todo, check, wrong, limit)]
    yield from measured
    if _fitting(measured):
        return
    for text, draw in limit.within("draws", redrawings(todo)):
        holds = within(check, check.got, draw())
        if check.buffer == drawn.this_pass.draw.depth:
            holds |= np.abs(check.got.astype(np.float64) - draw()) <= SAME_DEPTH
        yield Hypothesis(text, *fit_of(holds[check.where], wrong[check.where]), NUMBER if " is " in text else STATE)
    if check.stage == RASTERIZER and drawn.visible:
        for text, same in limit.within("mishaps of the draw", mishaps(drawn.visible, check.buffer, check.got)):
            yield Hypothesis(text, *fit_of(same[check.where], wrong[check.where]))


def _lying_off(todo: Redrawing, check: Check, wrong: np.ndarray, limit: Limit) -> Iterator[Hypothesis]:
    """A picture that lies off by a part of a pixel, judged as one drawn so, wherever its corners snap."""
    profile = replace(todo.case.profile, snap="any")
    for each in limit.within("offsets of the draw", lying_off(todo, limit)):
        near = fit_of(within(check, check.got, todo.draw(each.uniforms))[check.where], wrong[check.where])
        if min(near) >= LIKELY:
            again = todo.judged(each.uniforms, profile)
            both = check.where & again.where
            holds = outcome_map(again) != FAIL
            yield Hypothesis(each.text, *fit_of(holds[both], wrong[both]), NUMBER if " is " in each.text else STATE)


Tried = Iterator[tuple[str, Fit]]


def _other_uniforms(sample: Sample, case: Case) -> Tried:
    """Other matrices, the uniform of another light, and a position that is a little longer."""
    uniforms = case.oracle.scene.uniforms
    for own, kind in sample.stage.parameters.items():
        name = sample.stage.reads[own]
        if kind in (mat3, mat4) and name in uniforms:
            for text, matrix in other_matrices(name, uniforms):
                yield text, sample.fit(sample.with_inputs({own: kind(matrix)}))
        elif name in uniforms and kind is vec3:
            base = Name.of(name).base
            for other in (other for other in uniforms if other != name and Name.of(other).base == base):
                yield f"{name} is {other}", sample.fit(sample.with_inputs({own: kind(*uniforms[other])}))
            yield from lengthened(sample, own, name)


def _other_buffers(sample: Sample, case: Case) -> Tried:
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
            yield f"it reads {names}", sample.fit(sample.with_inputs(given))


def _misreadings(sample: Sample) -> Tried:
    """The ways in which such a stage is often misread."""
    for text, value in misread(sample.stage, sample.own_name, sample.given):
        yield text, sample.fit(stacked(value))


def _other_stages(sample: Sample, others: Mapping[str, Stage]) -> Tried:
    """Another of our stages that writes the buffer from the same inputs."""
    there = set(sample.stage.parameters)
    for name, stage in others.items():
        if name != sample.stage.name and sample.own_name in stage.outputs and set(stage.parameters) <= there:
            yield f"it computes {name}", sample.fit(sample.with_inputs({}, stage))


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
            yield text, sample.fit(sample.with_inputs(arrays))


def _mutants(sample: Sample, limit: Limit) -> Tried:
    """Every mutant of the stage; a mistake that reads beside a texture is passed over.

    Those that compute the same are one explanation, which says several: no buffer can tell them apart.
    """
    few, alike = sample.thinned(), dict[bytes, list[Mutant]]()
    for mutant in limit.within("mistakes in the source", mutants(sample.stage)):
        values = _values_of(mutant, few)
        if values is not None and min(few.fit(values)) >= ENOUGH:
            alike.setdefault(values.tobytes(), []).append(mutant)
    for group in alike.values():
        whole = _values_of(group[0], sample)
        if whole is not None:
            yield _any_of(group), sample.fit(whole)


def _any_of(alike: list[Mutant]) -> str:
    """The mistakes that compute the same, in words."""
    told = ", or ".join(mutant.description for mutant in alike[:MOST_ALIKE])
    left = len(alike) - MOST_ALIKE
    return f"{told}, or one of {left} more that compute the same" if left > 0 else told


def _values_of(mutant: Mutant, sample: Sample) -> np.ndarray | None:
    """What a mutant writes; None where it reads beside a texture or array."""
    try:
        return stacked(mutant(*sample.inputs)[sample.name])
    except (IndexError, ValueError, TypeError):
        return None
