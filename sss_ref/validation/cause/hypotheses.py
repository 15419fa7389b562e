"""What may be wrong with a stage: every explanation is tried on the very pixels, and those that fit are ranked.

Tried are: another number for each uniform of the stage, another stage in its place, the kernel turned round, every
mutant of its source, and what happens to a buffer on its way (rows flipped, channels swapped, sRGB, fewer bits); of a
draw, what its triangles may have come to (culling, depth test, half a pixel, fewer subpixel bits).
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.language import Stage
from sss_ref.language.types import Array, Texture, Vector, components, mat3, mat4
from sss_ref.scene_file.kernels import KERNELS
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.accept.rebased import RASTERIZER, Check
from sss_ref.validation.accept.walk import run_stage
from sss_ref.validation.cause.mishaps import mishaps
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.validation.cause.on_the_way import changes_on_the_way, within
from sss_ref.validation.clock import Limit

SAMPLE = 600  # pixels on which explanations are tried
TELLING = 8  # wrong pixels from which on explanations mean something
EVERY = 15  # of these the ones on which a mutant is tried first
NUMBERS, CLOSER = 9, 12  # tried on each side of the best one at a time, and how often
NEVER_WRONG = ("light_count",)  # uniforms that nobody sets by hand
ENOUGH = 0.98  # of these that an explanation must bring within reach


@dataclass(frozen=True)
class Hypothesis:
    """An explanation in words, and the share of the sampled pixels that it brings within reach."""

    text: str
    share: float


@dataclass(frozen=True)
class Sample:
    """A stage at some pixels of a buffer that it got wrong, half of them wrong ones.

    inputs: what the stage reads, one value for each parameter. got: (N, C). reach: float64 (N, C).
    """

    stage: Stage
    inputs: list[Any]
    name: str
    got: np.ndarray
    reach: np.ndarray

    def share(self, values: Any) -> float:
        """The share of pixels on which these values (N, C) are what was got."""
        with np.errstate(all="ignore"):
            apart = np.abs(np.asarray(values, np.float64) - self.got)
        return float((apart <= self.reach).all(axis=-1).mean())

    @property
    def given(self) -> dict[str, Any]:
        """The inputs by the stage's own names."""
        return dict(zip(self.stage.parameters, self.inputs, strict=True))

    def with_inputs(self, changed: Mapping[str, Any], stage: Stage | None = None) -> np.ndarray:
        """What the stage, or another one, gives when inputs, by its own names, are others."""
        given, stage = {**self.given, **changed}, stage or self.stage
        results = stage.run([given[own] for own in stage.parameters])
        return stacked(results[stage.writes[self.own_name]])

    def thinned(self) -> "Sample":
        """Fewer of the pixels."""
        return self._each(lambda array: array[::EVERY])

    def repeated(self, times: int) -> "Sample":
        """All pixels, so many times one after the other."""
        return self._each(lambda array: np.concatenate([array] * times))

    def _each(self, change: Callable[[np.ndarray], np.ndarray]) -> "Sample":
        inputs = [_of_pixels(change, value) for value in self.inputs]
        return replace(self, inputs=inputs, got=change(self.got), reach=change(self.reach))

    @property
    def own_name(self) -> str:
        """The stage's own name for the buffer."""
        return next(own for own, name in self.stage.writes.items() if name == self.name)


def hypotheses(check: Check, drawn: DrawnPass, others: Mapping[str, Stage], limit: Limit) -> list[Hypothesis]:
    """The explanations that fit, the best first; none for so few wrong pixels that nearly all would.

    others: all stages by name, to be tried in the place of this one. limit: the time for it; the cheap ones come first,
    and once one of them fits everywhere, no mistake in the source is looked for.
    """
    wrong = check.where & ~within(check, check.got, check.expected)
    if wrong.sum() < TELLING:
        return []
    found = [Hypothesis(text, share) for text, share in changes_on_the_way(check)]
    if check.stage == RASTERIZER and drawn.visible:
        drawings = limit.within("mishaps of the draw", mishaps(drawn.visible, check.buffer, check.got, wrong))
        found += [Hypothesis(*each) for each in drawings]
    sample = _sample(check, drawn)
    if sample is not None:
        tried = (*_other_stages(sample, others), *_kernels(sample), *_numbers(sample, limit))
        found += [Hypothesis(*each) for each in tried]
        if all(each.share < 1 for each in found):
            found += [Hypothesis(*each) for each in _mutants(sample, limit)]
    fitting = [each for each in found if each.share >= ENOUGH]
    return sorted(fitting, key=lambda each: -each.share)[:8]


Tried = Iterator[tuple[str, float]]


def _of_pixels(change: Callable[[np.ndarray], np.ndarray], value: Any) -> Any:
    """An input whose arrays of pixels are changed; what all pixels share stays as it is."""
    if isinstance(value, Vector):
        return type(value)(*(_of_pixels(change, part) for part in value))
    return change(value) if isinstance(value, np.ndarray) else value


def _sample(check: Check, drawn: DrawnPass) -> Sample | None:
    """Half of the sample from the wrong pixels, half from all."""
    if check.stage not in {stage.name for stage in drawn.this_pass.stages}:
        return None
    rng = np.random.default_rng(0)
    wrong = np.argwhere(check.where & ~within(check, check.got, check.expected))
    compared = np.argwhere(check.where)
    chosen = [pixels[rng.integers(0, len(pixels), SAMPLE // 2)] for pixels in (wrong, compared)]
    rows, columns = np.concatenate(chosen).T
    at = (rows, columns)
    run = run_stage(drawn, at, check.buffer)
    got, reach = (np.atleast_3d(array)[at].astype(np.float64) for array in (check.got, check.reach))
    return Sample(run.stage, run.inputs, check.buffer, got, reach)


def _numbers(sample: Sample, limit: Limit) -> Tried:
    """Another value of one uniform number, or of one after the other component of a uniform vector."""
    few = sample.thinned()
    for own in limit.within("numbers", _own_numbers(sample)):
        parts = components(sample.given[own])
        found = list(parts)
        for k, part in enumerate(parts):
            found[k] = np.float32(_fitted(partial(_misfits, few, own, tuple(found), k), part))
        share = sample.share(_with_number(sample, own, tuple(found), 0, found[0]))
        yield f"{sample.stage.reads[own]} is {_listed(found)} instead of {_listed(parts)}", share


def _own_numbers(sample: Sample) -> Iterator[str]:
    """The stage's own names of its uniforms that are numbers or vectors of these, and that somebody may set wrong."""
    for own, value in sample.given.items():
        parts = [] if isinstance(value, Texture | Array | mat3 | mat4) else components(value)
        if own not in NEVER_WRONG and parts and all(isinstance(part, np.float32) for part in parts):
            yield own


def _listed(parts: list[Any]) -> str:
    texts = [f"{float(part):.6g}" for part in parts]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def _with_number(sample: Sample, own: str, parts: tuple[Any, ...], k: int, number: Any) -> np.ndarray:
    """What the stage gives with one component of a uniform changed; number: float32, or one for each pixel."""
    changed = [*parts[:k], number, *parts[k + 1 :]]
    kind = sample.stage.parameters[own]
    return sample.with_inputs({own: changed[0] if len(changed) == 1 else kind(*changed)})


def _misfits(sample: Sample, own: str, parts: tuple[Any, ...], k: int, numbers: np.ndarray) -> np.ndarray:
    """How far off the stage is with each of these numbers in the place of a component, float64 (K,); run just once."""
    many = sample.repeated(len(numbers))
    with np.errstate(all="ignore"):
        values = _with_number(many, own, parts, k, np.repeat(numbers.astype(np.float32), len(sample.got)))
        apart = np.abs(values.astype(np.float64) - many.got) / (many.reach + 1e-30)
    return np.nan_to_num(apart, nan=1e30, posinf=1e30).reshape(len(numbers), -1).mean(axis=1)


def _fitted(misfits: Callable[[np.ndarray], np.ndarray], value: np.float32) -> float:
    """The number with which most comes within reach: searched in steps that grow, then ever closer to the best."""
    scale = abs(float(value)) or 1.0
    steps = [0.0, *(sign * scale * 10.0**power for power in np.arange(-5, 1.01, 0.125) for sign in (-1, 1))]
    candidates = np.sort(float(value) + np.array(steps))
    for _ in range(1 + CLOSER):
        errors = misfits(candidates)
        best = int(errors.argmin())
        around = candidates[max(best - 1, 0)], candidates[best], candidates[min(best + 1, len(candidates) - 1)]
        found = float(candidates[best])
        candidates = np.concatenate([np.linspace(*around[:2], NUMBERS), np.linspace(*around[1:], NUMBERS)[1:]])
    return found


def _other_stages(sample: Sample, others: Mapping[str, Stage]) -> Tried:
    """Another of our stages that writes the buffer from the same inputs."""
    there = set(sample.stage.parameters)
    for name, stage in others.items():
        if name != sample.stage.name and sample.own_name in stage.outputs and set(stage.parameters) <= there:
            yield f"it computes {name}", sample.share(sample.with_inputs({}, stage))


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
            yield text, sample.share(sample.with_inputs(arrays))


def _mutants(sample: Sample, limit: Limit) -> Tried:
    """Every mutant of the stage; a mistake that reads beside a texture is passed over."""
    few = sample.thinned()
    for mutant in limit.within("mistakes in the source", mutants(sample.stage)):
        if _share_of(mutant, few) >= ENOUGH:
            yield mutant.description, _share_of(mutant, sample)


def _share_of(mutant: Mutant, sample: Sample) -> float:
    try:
        return sample.share(stacked(mutant(*sample.inputs)[sample.name]))
    except (IndexError, ValueError, TypeError):
        return 0.0
