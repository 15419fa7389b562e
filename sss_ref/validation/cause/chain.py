"""The stages of a pass that may all be wrong, because of what they gave only the last was dumped, run as one."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from sss_ref.language.pipeline import Pass
from sss_ref.language.stage import Stage
from sss_ref.validation.accept.drawn_pass import DrawnPass
from sss_ref.validation.accept.known import Pixels
from sss_ref.validation.accept.walk import walk


@dataclass(frozen=True)
class Chain:
    """Stages of a pass in order, up to the one that writes a buffer; what they read from outside by the pass's names.

    parameters: name -> type of what is read from outside.
    """

    stages: tuple[Stage, ...]
    buffer: str
    parameters: Mapping[str, Any]

    @property
    def reads(self) -> Mapping[str, str]:
        """What a stage calls names of its own are those of the pass."""
        return {name: name for name in self.parameters}

    @property
    def writes(self) -> Mapping[str, str]:
        """The buffer alone."""
        return {self.buffer: self.buffer}

    @property
    def before(self) -> tuple[Stage, ...]:
        """The stages before the last."""
        return self.stages[:-1]

    def with_stage(self, number: int, stage: Stage) -> "Chain":
        """The same with another stage in the place of one."""
        return replace(self, stages=(*self.stages[:number], stage, *self.stages[number + 1 :]))

    def run(self, inputs: Sequence[Any]) -> dict[str, Any]:
        """Run all stages: buffer -> value. inputs: one value per parameter, in order."""
        known = dict(zip(self.parameters, inputs, strict=True))
        for stage in self.stages:
            known |= stage.run([known[stage.reads[own]] for own in stage.parameters])
        return {self.buffer: known[self.buffer]}


def chain_of(drawn: DrawnPass, buffer: str, at: Pixels) -> tuple[Chain, list[Any]]:
    """The chain that ends in a buffer of a pass, and what it reads at some pixels, one value per parameter."""
    stages = suspected(drawn.this_pass, buffer, set(drawn.drawing.buffers))
    inside, kinds, values = set[str](), dict[str, Any](), dict[str, Any]()
    for run in (run for run in walk(drawn, at) if run.stage in stages):
        for own, known in run.read.items():
            name = run.stage.reads[own]
            if name not in inside:
                kinds[name], values[name] = run.stage.parameters[own], known.exact
        inside |= set(run.written) - set(drawn.drawing.buffers)
    return Chain(stages, buffer, kinds), list(values.values())


def suspected(this_pass: Pass, buffer: str, dumped: set[str]) -> tuple[Stage, ...]:
    """The stages of a pass one of which may be wrong if a buffer is: those whose results were not dumped, up to its."""
    found, unseen = list[Stage](), {buffer}
    for stage in reversed(this_pass.stages):
        written = set(stage.writes.values())
        if unseen & written:
            found.insert(0, stage)
            unseen = (unseen - written) | (set(stage.reads.values()) - dumped)
    return tuple(found)
