"""Another number for a uniform: the one with which most comes within reach, if it can mean anything."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any

import numpy as np

from sss_ref.language.names import Name
from sss_ref.language.types import Array, Texture, components, mat3, mat4
from sss_ref.validation.cause.hypothesis import ENOUGH, FITTED, INPUT, NUMBER, Charge, Hypothesis
from sss_ref.validation.cause.sample import Fit, Sample
from sss_ref.validation.clock import Limit

NUMBERS, CLOSER = 9, 12  # tried on each side of the best one at a time, and how often
NEVER_WRONG = ("light_count",)  # uniforms that nobody sets by hand

TINY = float(np.finfo(np.float32).tiny)  # the smallest that is more than nothing

MEANING = {  # uniform -> the ends of what it can mean; others may be any number
    **dict.fromkeys(("ambient", "diffuse", "specular", "bias_abs", "bias_slope", "d_min"), (0.0, np.inf)),
    **dict.fromkeys(("x", "exponent", "wrap", "lookup_depth"), (0.0, np.inf)),
    **dict.fromkeys(("shininess", "light_texel_size", "pixel_scale", "kernel_scale"), (TINY, np.inf)),
    **dict.fromkeys(("camera_pixel_size", "mm_per_unit", "mm_per_offset"), (TINY, np.inf)),
    **dict.fromkeys(("light_intensity", "light_color", "translucency_scale"), (0.0, np.inf)),
    **dict.fromkeys(("mesh_color", "background"), (0.0, 1.0)),
    "lookup_inset": (0.5, 1.5),
    "normal_scale": (0.0, np.inf),  # a map with green pointing down has a name of its own
}
Number = tuple[np.float32, ...]  # the components of a uniform


def other_numbers(sample: Sample, limit: Limit) -> Iterator[Hypothesis]:
    """Another value of one uniform number, or of one after the other component of a uniform vector.

    Those that somebody writes by mistake come before those that fit best, and of these the ones with few digits.
    """
    few = sample.thinned()
    for own in limit.within("numbers", _own_numbers(sample)):
        parts = tuple(map(np.float32, components(sample.given[own])))
        simple = NUMBER if len(parts) == 1 else FITTED  # nobody turns a position round, or sets it to 0
        for rank, kind in ((simple, _simple(parts)), (FITTED, _closest(few, own, parts))):
            told = _first_that_fits(sample, few, own, (each for each in kind if each != parts))
            if told is not None:
                found, fit = told
                name = sample.stage.reads[own]
                text = f"{name} is {_listed(found)} instead of {_listed(parts)}"
                yield Charge(text, INPUT, (name,)).fitting(fit, rank)
                break


def _first_that_fits(sample: Sample, few: Sample, own: str, tried: Iterable[Number]) -> tuple[Number, Fit] | None:
    """The first of some values of a uniform that can mean anything and explains what is wrong."""
    low, high = MEANING.get(Name.of(own).base, (-np.inf, np.inf))
    for number in (each for each in tried if all(low <= part <= high for part in each)):
        if min(few.fit(_with_number(few, own, number, 0, number[0]))) >= ENOUGH:
            whole = sample.fit(_with_number(sample, own, number, 0, number[0]))
            if min(whole) >= ENOUGH:
                return number, whole
    return None


def _simple(parts: Number) -> Iterator[Number]:
    """Nothing, one, the other sign, twice and half as much."""
    yield (np.float32(0),) * len(parts)
    yield (np.float32(1),) * len(parts)
    for factor in (-1.0, 2.0, 0.5):
        yield tuple(np.float32(factor) * part for part in parts)


def _closest(few: Sample, own: str, parts: Number) -> Iterator[Number]:
    """The value of a uniform with which most comes within reach, component after component.

    First rounded to two, three and four digits, then as it is.
    """
    found = list(parts)
    for k, part in enumerate(parts):
        found[k] = np.float32(_fitted(partial(_misfits, few, own, tuple(found), k), part))
    for digits in (2, 3, 4):
        yield tuple(np.float32(f"{float(part):.{digits}g}") for part in found)
    yield tuple(found)


def _own_numbers(sample: Sample) -> Iterator[str]:
    """The stage's own names of its uniforms that are numbers or vectors of these, and that somebody may set wrong."""
    for own, value in sample.given.items():
        parts = [] if isinstance(value, Texture | Array | mat3 | mat4) else components(value)
        if own not in NEVER_WRONG and parts and all(isinstance(part, np.float32) for part in parts):
            yield own


def _listed(parts: Number) -> str:
    texts = [f"{float(part):.6g}" for part in parts]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def _with_number(sample: Sample, own: str, parts: tuple[Any, ...], k: int, number: Any) -> np.ndarray:
    """What the stage gives with one component of a uniform changed; number: float32, or one for each pixel."""
    changed = [*parts[:k], number, *parts[k + 1 :]]
    kind = sample.stage.parameters[own]
    return sample.with_inputs({own: changed[0] if len(changed) == 1 else kind(*changed)})


def _misfits(sample: Sample, own: str, parts: tuple[Any, ...], k: int, numbers: np.ndarray) -> np.ndarray:
    """How far off the stage is with each of these numbers in the place of a component, float64 (K,)."""
    return _apart(sample, numbers, lambda many, each: _with_number(many, own, parts, k, each))


def _apart(sample: Sample, numbers: np.ndarray, compute: Callable[[Sample, np.ndarray], np.ndarray]) -> np.ndarray:
    """How far off what is computed with each of some numbers is, float64 (K,); the stage is run just once."""
    many = sample.repeated(len(numbers))
    with np.errstate(all="ignore"):
        values = compute(many, np.repeat(numbers.astype(np.float32), len(sample.got)))
        apart = np.abs(values.astype(np.float64) - many.got) / (many.reach + 1e-30)
    return np.nan_to_num(apart, nan=1e30, posinf=1e30).reshape(len(numbers), -1).mean(axis=1)


def lengthened(sample: Sample, own: str, name: str) -> Iterator[tuple[Charge, Fit]]:
    """A uniform vector a little longer or shorter."""
    few, right = sample.thinned(), sample.given[own]

    def misfits(numbers: np.ndarray) -> np.ndarray:
        return _apart(few, numbers, lambda many, each: many.with_inputs({own: right * each}))

    factor = _fitted(misfits, np.float32(1))
    if factor > 0:
        charge = Charge(f"{name} is {factor:.6g} times as long", INPUT, (name,))
        yield charge, sample.fit(sample.with_inputs({own: right * np.float32(factor)}))


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
