"""Who is to blame: a stage that is wrong, or one before it whose results nobody has seen."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sss_ref.language.pipeline import CLIP_POSITION, Method, Pass
from sss_ref.validation.accept.rebased import RASTERIZER


@dataclass(frozen=True)
class Writer:
    """A stage of either shader, or the rasterizer between them; place: PASS/STAGE."""

    place: str
    reads: frozenset[str]
    writes: frozenset[str]


def suspects(method: Method, pass_name: str, buffer: str, dumped: Collection[str]) -> tuple[str, ...]:
    """The stages one of which is wrong if `buffer` of a pass is, as PASS/STAGE in stage order: its own is the last.

    A stage is handed what was dumped, and that is right as far as it was judged. What was not dumped comes from the
    stage that writes it, which may be wrong itself, or have been handed something wrong in the same way.
    """
    found, unseen = [], frozenset({buffer})
    for writer in reversed([*_up_to(method, pass_name, buffer)]):
        if unseen & writer.writes:
            found.append(writer.place)
            unseen = (unseen - writer.writes) | writer.reads.difference(dumped)
    return tuple(reversed(dict.fromkeys(found)))


def narrowing(method: Method, pass_name: str, buffer: str, dumped: Collection[str]) -> tuple[str, ...]:
    """The buffers that were not dumped and from which `buffer` of a pass is made directly, in stage order.

    What no buffer keeps stands for what it is made from.
    """
    before = list(_up_to(method, pass_name, buffer))
    found, read = set[str](), frozenset({buffer})
    for writer in reversed(before):
        if read & writer.writes:
            unseen = writer.reads.difference(dumped)
            found |= unseen & set(method.outputs)
            read = (read - writer.writes) | (unseen - set(method.outputs))
    return tuple(name for name in method.outputs if name in found)


def _up_to(method: Method, pass_name: str, buffer: str) -> Iterator[Writer]:
    """Whatever writes something up to the stage that writes a buffer of a pass, in order."""
    for each in method.passes:
        for writer in _writers(each):
            yield writer
            if each.name == pass_name and buffer in writer.writes:
                return


def _writers(this_pass: Pass) -> Iterator[Writer]:
    """Whatever writes something in a pass, in order."""
    draw = this_pass.draw
    for vertex in draw.vertex_stages:
        yield _writer(this_pass, vertex.name, draw.reads, {CLIP_POSITION, *draw.varyings})
        yield _writer(this_pass, RASTERIZER, {CLIP_POSITION}, draw.outputs)
    for stage in this_pass.stages:
        reads = {*stage.reads.values()}
        yield _writer(this_pass, stage.name, reads | draw.covered_by(reads), stage.writes.values())


def _writer(this_pass: Pass, stage: str, reads: Collection[str], writes: Collection[str]) -> Writer:
    return Writer(f"{this_pass.name}/{stage}", frozenset(reads), frozenset(writes))
