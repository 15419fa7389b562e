"""Mistakes for readers to plant: wrong lines of a stage's shader, which a device shows beyond doubt."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

import numpy as np

from sss_ref.language.stage import Stage
from sss_ref.language.types import components
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.webgl.allowed import Allowed
from sss_ref.webgl.exams import Exam

MOST = 2  # of a stage
TRIED = 40  # of a stage, before it is left without
SEEN = 0.05  # of the pixels that are judged, at least, show it


@dataclass(frozen=True)
class WrongLine:
    """A mistake. about: in words. line: its number in the shader, from 1. text: the wrong line, in its place."""

    about: str
    line: int
    text: str


def wrong_lines(exam: Exam, uniforms: Mapping[str, Any], shader: Callable[[Stage], str]) -> list[WrongLine]:
    """Some mistakes in the stage of an exam, no two in one line. shader: what a stage is translated to."""
    if exam.of.rounds != 1 or not exam.where.any():
        return []
    inputs, right = exam.inputs(uniforms), shader(exam.stage).splitlines()
    found: dict[int, WrongLine] = {}
    for mutant in islice(_other_lines(exam.stage), TRIED):
        if len(found) < MOST and _is_seen(exam, mutant, inputs):
            each = _only_line(mutant, right, shader(replace(exam.stage, body=mutant.body)).splitlines())
            if each:
                found.setdefault(each.line, each)
    return list(found.values())


def _other_lines(stage: Stage) -> Iterator[Mutant]:
    """The mutants of a stage, each line's first ones before all others."""
    turns: dict[str, int] = {}
    ordered = []
    for number, each in enumerate(mutants(stage)):
        turns[each.line] = turns.get(each.line, 0) + 1
        ordered.append((turns[each.line], number, each))
    return (each for _, _, each in sorted(ordered, key=lambda one: one[:2]))


def _is_seen(exam: Exam, mutant: Mutant, inputs: list[Any]) -> bool:
    """Whether what a mutant gives lies twice as far off as is right, at enough pixels, and is a number there."""
    try:
        results = mutant(*inputs)
    except IndexError:  # it reads beside a texture, where a device may find anything
        return False
    wrong = np.zeros(np.count_nonzero(exam.where), bool)
    for name, value in results.items():
        if name not in exam.right:
            continue
        right = exam.right[name]
        for channel, part in enumerate(components(value)):
            wrong |= _far_off(right, channel, np.broadcast_to(part, wrong.shape), exam.where)
    return bool(wrong.mean() >= SEEN)


def _far_off(right: Allowed, channel: int, got: np.ndarray, where: np.ndarray) -> np.ndarray:
    ends = (right.low, right.middle, right.high)
    low, middle, high = (np.atleast_3d(end)[where][:, channel].astype(np.float64) for end in ends)
    number = got.astype(np.float64)
    with np.errstate(invalid="ignore"):
        far: np.ndarray = (number < 2 * low - middle) | (number > 2 * high - middle)
    return far & np.isfinite(number)


def _only_line(mutant: Mutant, right: list[str], wrong: list[str]) -> WrongLine | None:
    """The one line in which two texts differ; None where it is not one."""
    numbers = [k for k, (ours, theirs) in enumerate(zip(right, wrong, strict=False)) if ours != theirs]
    if len(right) != len(wrong) or len(numbers) != 1:
        return None
    return WrongLine(mutant.description, numbers[0] + 1, wrong[numbers[0]])
