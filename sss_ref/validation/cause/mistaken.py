"""Stages with a mistake in them: one of our other stages, a common misreading, or a place of the source changed."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import wraps
from typing import Any

from sss_ref.language.stage import Stage
from sss_ref.validation.cause.hypothesis import SOURCE, Charge
from sss_ref.validation.cause.misreadings import MISREADINGS, Given, Misreading
from sss_ref.validation.cause.mutants import mutants


def stages_instead(stage: Stage, others: Mapping[str, Stage]) -> Iterator[tuple[Charge, Stage]]:
    """Other stages of ours that write the same from the same inputs, in words."""
    for name, other in others.items():
        alike = set(other.outputs) == set(stage.outputs) and set(other.parameters) <= set(stage.parameters)
        if name != stage.name and alike:
            reads = {own: stage.reads[own] for own in other.parameters}
            charge = Charge(f"it computes {name}, not {stage.name}", SOURCE)
            yield charge, replace(other, reads=reads, writes=stage.writes)


def stages_misread(stage: Stage) -> Iterator[tuple[Charge, Stage]]:
    """A stage as it is often misread, in words."""
    for each in (each for each in MISREADINGS if each.output in stage.outputs):
        yield Charge(f"{stage.name}: {each.text}", each.blames), computing(stage, _misread(stage, each))


def stages_mutated(stage: Stage) -> Iterator[tuple[Charge, Stage]]:
    """A stage with one place of its source changed, in words."""
    for mutant in mutants(stage):
        yield Charge(f"{stage.name}: {mutant.description}", SOURCE), stage.with_body(mutant.body)


def computing(stage: Stage, compute: Callable[..., Any]) -> Stage:
    """A stage that computes something else, in the order of its outputs."""
    return replace(stage, python=wraps(stage.python)(compute), variant=("", stage.variant[1]))


def _misread(stage: Stage, misreading: Misreading) -> Callable[..., Any]:
    def right(given: Given) -> Any:
        return stage(*(given[own] for own in stage.parameters))

    def compute(*inputs: Any) -> Any:
        given = dict(zip(stage.parameters, inputs, strict=True))
        results = dict(zip(stage.writes, right(given), strict=True))
        return tuple((results | {misreading.output: misreading.compute(right, given)}).values())

    return compute
