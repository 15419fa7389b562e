"""Mistakes for readers to plant: wrong lines of a stage's shader, which a device shows beyond doubt."""

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count, islice
from typing import Any

import numpy as np

from sss_ref.language.pipeline import CLIP_POSITION
from sss_ref.language.stage import Stage
from sss_ref.language.types import components
from sss_ref.raster.clip import W
from sss_ref.validation.accept.known import stacked
from sss_ref.validation.cause.mutants import Mutant, mutants
from sss_ref.webgl.allowed import Allowed
from sss_ref.webgl.exams import Exam

MOST = 2  # of a stage
TRIED = 40  # of a stage, before it is left without
SEEN = 0.05  # of the pixels that are judged, at least, show it
OF_VERTICES, FAR_OFF = 0.5, 0.05  # at least so many vertices lie off by so much of what all of them reach over


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
    inputs = exam.inputs(uniforms)
    return _chosen(exam.stage, shader, lambda results: _is_seen(exam, results), inputs)


def wrong_vertex_lines(
    stage: Stage, inputs: Sequence[Any], shown: Collection[str], shader: Callable[[Stage], str]
) -> list[WrongLine]:
    """The same of a vertex stage. inputs: what it reads for every vertex. shown: the varyings that are judged."""
    right = _of_vertices(stage.run(inputs), shown)
    return _chosen(stage, shader, lambda results: _moves(right, _of_vertices(results, shown)), inputs)


def _chosen(
    stage: Stage, shader: Callable[[Stage], str], is_seen: Callable[[Mapping[str, Any]], bool], inputs: Sequence[Any]
) -> list[WrongLine]:
    """The first mutants that are seen, each in another line."""
    right = shader(stage).splitlines()
    found: dict[int, WrongLine] = {}
    for mutant in islice(_other_lines(stage), TRIED):
        if len(found) < MOST and is_seen(_results(mutant, inputs)):
            each = _only_line(mutant, right, shader(replace(stage, body=mutant.body)).splitlines())
            if each:
                found.setdefault(each.line, each)
    return list(found.values())


def _results(mutant: Mutant, inputs: Sequence[Any]) -> Mapping[str, Any]:
    """What a mutant gives; nothing where it reads beside a texture, where a device may find anything."""
    try:
        return mutant(*inputs)
    except IndexError:
        return {}


def _other_lines(stage: Stage) -> Iterator[Mutant]:
    """The mutants of a stage, each line's first ones before all others."""
    turns: defaultdict[str, Iterator[int]] = defaultdict(count)
    return iter(sorted(mutants(stage), key=lambda each: next(turns[each.line])))


def _is_seen(exam: Exam, results: Mapping[str, Any]) -> bool:
    """Whether results lie twice as far off as is right, at enough pixels, and are numbers there."""
    wrong = np.zeros(np.count_nonzero(exam.where), bool)
    for name in results.keys() & exam.right.keys():
        for channel, part in enumerate(components(results[name])):
            wrong |= _far_off(exam.right[name], channel, np.broadcast_to(part, wrong.shape), exam.where)
    return bool(wrong.mean() >= SEEN)


def _of_vertices(results: Mapping[str, Any], shown: Collection[str]) -> list[np.ndarray]:
    """Where vertices lie in the window, and what is interpolated between them, float64 (V, C) each."""
    values = {name: stacked(value).astype(np.float64) for name, value in results.items()}
    with np.errstate(all="ignore"):
        window = [clip[:, :W] / clip[:, W:] for name, clip in values.items() if name == CLIP_POSITION]
    return window + [values[name] for name in sorted(shown) if name in values]


def _moves(right: list[np.ndarray], wrong: list[np.ndarray]) -> bool:
    """Whether most vertices lie elsewhere, or hand on other values, by much of what all reach over."""
    return any(map(_is_elsewhere, right, wrong))


def _is_elsewhere(right: np.ndarray, wrong: np.ndarray) -> bool:
    with np.errstate(invalid="ignore"):
        off = np.abs(wrong - right) > FAR_OFF * np.ptp(right, axis=0)
    elsewhere = off.any(axis=1) & np.isfinite(wrong).all(axis=1)
    return bool(elsewhere.mean() >= OF_VERTICES)


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
