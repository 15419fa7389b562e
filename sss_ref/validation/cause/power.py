"""What a run would see: the smallest error in each number, and the share of mistakes in the source, by stage.

Worked out on the oracle alone, so it is told of a run that passes as well: a stage is given a wrong number, or one
mistake, on some of the pixels judged, and what it then writes is held against the same reach. Where a pixel leaves it,
the run would see the error of a processor that otherwise computes as the oracle does.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from sss_ref.language.types import Array, Texture, Vector, components, mat3, mat4
from sss_ref.numerics.random_numbers import one_of_each_run
from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.accept.walk import StageRun, walk
from sss_ref.validation.cause.misreadings import misread
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.validation.cause.other_numbers import NEVER_WRONG
from sss_ref.validation.verdict.outcomes import distance

SAMPLE = 1500  # pixels of a pass on which errors are tried
MUTANTS = 12  # of a stage at most
SMALLEST, HALVINGS = -9.0, 7  # decades below 1 to search, and how often they are halved


@dataclass(frozen=True)
class Sensitivity:
    """The least change of a number that is seen, as a share of it; None: not even its double is.

    Of a number that is 0 the change itself, and None if not even 1 is seen.
    """

    name: str
    change: float | None
    relative: bool

    def __str__(self) -> str:
        """As part of a list."""
        if self.change is None:
            return f"{self.name} not even {'doubled' if self.relative else '1'}"
        return f"{self.name} {'' if self.relative else '0 to '}{self.change:.1g}"


@dataclass(frozen=True)
class Power:
    """One stage. mistakes: how many of the mistakes tried change a bit. seen, unseen: which of these are.

    hidden: ways in which such a stage is often misread that change nothing here: another picture would show them.
    """

    stage: str
    numbers: tuple[Sensitivity, ...]
    mistakes: int
    seen: int
    unseen: tuple[str, ...]
    hidden: tuple[str, ...] = ()

    def __str__(self) -> str:
        """As a line."""
        return f"{self.stage}: {', '.join(map(str, self.numbers))}"


@dataclass(frozen=True)
class Trial:
    """A stage on some pixels, with what it writes and how far that may be off.

    expected, reach: judged buffer -> (N, C).
    """

    run: StageRun
    expected: Mapping[str, np.ndarray]
    reach: Mapping[str, np.ndarray]

    def sees(self, written: Mapping[str, Any]) -> bool:
        """Whether any of this, buffer -> value, is out of reach."""
        return any(self._outside(name, written[name]) for name in self.expected if name in written)

    def _outside(self, name: str, value: Any) -> bool:
        return bool((~(distance(stacked(value), self.expected[name]) <= self.reach[name])).any())

    def changes(self, written: Mapping[str, Any]) -> bool:
        """Whether this differs at all."""
        return any(
            not np.array_equal(np.broadcast_to(stacked(written[name]), base.shape), base, equal_nan=True)
            for name, base in self.expected.items()
            if name in written
        )


def power(case: Case, judged: Mapping[str, np.ndarray]) -> Iterator[Power]:
    """What would be seen of each stage whose buffers are judged.

    judged: buffer -> its compared pixels, bool (H, W).
    """
    oracle = case.oracle
    handed_on = replace(case.drawing, buffers={name: oracle[name] for name in judged if name in oracle.buffers})
    for this_pass in oracle.scene.method.passes:
        own = [name for name in this_pass.outputs if name in judged and name not in this_pass.draw.outputs]
        if own and not this_pass.fed_back and judged[own[0]].any():
            drawn = replace(case.of_oracle.drawn(this_pass), drawing=handed_on)
            yield from map(_power_of, _trials(drawn, own, judged[own[0]]))


def _trials(drawn: DrawnPass, own: Sequence[str], where: np.ndarray) -> Iterator[Trial]:
    """Every stage of a pass that writes one of these buffers, on a sample of the pixels of a mask, bool (H, W)."""
    pixels = np.argwhere(where)
    some = pixels[one_of_each_run(len(pixels), min(SAMPLE, len(pixels)))]
    chosen = np.concatenate([some, _outermost(pixels)])
    for run in walk(drawn, (chosen[:, 0], chosen[:, 1])):
        expected, reach = {}, {}
        for name in (name for name in run.written if name in own):
            expected[name], reach[name] = run.written[name].columns, run.written[name].reach
            held = drawn.drawing.before(name, expected[name])
            reach[name] += np.maximum(held.high - expected[name], expected[name] - held.low)
        if expected:
            yield Trial(run, expected, reach)


def _outermost(pixels: np.ndarray) -> np.ndarray:
    """Of pixels (N, 2) those in their first and last row and column: there a stage reads beyond a picture's edge."""
    return pixels[((pixels == pixels.min(axis=0)) | (pixels == pixels.max(axis=0))).any(axis=1)]


def _power_of(trial: Trial) -> Power:
    """All tries of one stage."""
    stage, misreadings = trial.run.stage, list(_as_misread(trial))
    mutated = ((each.description, _with_mistake(each, trial.run.inputs)) for each in _some(list(mutants(stage))))
    tried = [(text, written) for text, written in (*mutated, *misreadings) if written and trial.changes(written)]
    unseen = tuple(text for text, written in tried if not trial.sees(written))
    hidden = tuple(text for text, written in misreadings if not trial.changes(written))
    return Power(stage.name, tuple(_numbers(trial)), len(tried), len(tried) - len(unseen), unseen, hidden)


def _as_misread(trial: Trial) -> Iterator[tuple[str, dict[str, Any]]]:
    """What the stage writes as it is often misread: in words, and buffer -> value."""
    stage = trial.run.stage
    given = dict(zip(stage.parameters, trial.run.inputs, strict=True))
    for own, name in stage.writes.items():
        if name in trial.expected:
            yield from ((charge.text, {name: value}) for charge, value in misread(stage, own, given))


def _some(all_mutants: list[Mutant]) -> list[Mutant]:
    """A sample, the same every time."""
    chosen = one_of_each_run(len(all_mutants), min(MUTANTS, len(all_mutants)))
    return [all_mutants[index] for index in chosen.tolist()]


def _with_mistake(mutant: Mutant, inputs: list[Any]) -> dict[str, Any] | None:
    """What a mutant writes; None where it reads beside a texture or array."""
    try:
        return mutant(*inputs)
    except (IndexError, ValueError, TypeError):
        return None


def _numbers(trial: Trial) -> Iterator[Sensitivity]:
    """The least change of every uniform that holds numbers; of a vector or an array as a whole."""
    stage = trial.run.stage
    for position, (own, value) in enumerate(zip(stage.parameters, trial.run.inputs, strict=True)):
        if _is_number(value) and own not in NEVER_WRONG:
            relative = _size(value) > 0
            sees = partial(_sees_change, trial, position, relative)
            yield Sensitivity(stage.reads[own], _least(sees), relative)


def _is_number(value: Any) -> bool:
    """Whether this is a uniform of floats that somebody may have set wrong."""
    if isinstance(value, Array):
        return value.data.dtype.kind == "f"
    return not isinstance(value, Texture | mat3 | mat4) and all(isinstance(p, np.float32) for p in components(value))


def _size(value: Any) -> float:
    parts = value.data if isinstance(value, Array) else np.array(components(value))
    return float(np.abs(parts).max())


def _sees_change(trial: Trial, position: int, relative: bool, change: float) -> bool:
    """Whether an error of this size in one input would be seen."""
    inputs = list(trial.run.inputs)
    inputs[position] = _changed(inputs[position], change, relative)
    return trial.sees(trial.run.stage.run(inputs))


def _changed(value: Any, change: float, relative: bool) -> Any:
    """A number, or every number of a vector or array, with a relative or an absolute error."""

    def put(number: Any) -> Any:
        return (number * (1 + change) if relative else number + change).astype(np.float32)

    if isinstance(value, Array):
        return Array(put(value.data.astype(np.float64)))
    parts = [put(np.float64(part)) for part in components(value)]
    return type(value)(*parts) if isinstance(value, Vector) else parts[0]


def _least(sees: Callable[[float], bool]) -> float | None:
    """The least change that is seen, to a few per cent; None if 1 is not."""
    if not sees(1.0):
        return None
    low, high = SMALLEST, 0.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if sees(10.0**middle) else (middle, high)
    return 10.0**high
