"""A stage of your own in the place of one of ours: every interpreter then runs it, and no file of ours is touched."""

from collections.abc import Mapping
from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.pipeline import Method, Pass
from sss_ref.methods.per_light import BUFFERS, UNIFORMS
from sss_ref.passes.buffers import TEXEL


def with_stages(method: Method, own: Mapping[str, Stage]) -> Method:
    """The method with stages put in the place of those of these names."""
    return replace(method, passes=tuple(_with_stages(one, own) for one in method.passes)) if own else method


def _with_stages(one: Pass, own: Mapping[str, Stage]) -> Pass:
    stages: list[Stage] = []
    for each in one.stages:
        before = {name for stage in stages for name in stage.writes.values()}
        stages.append(bound_like(own[each.name], each, before) if each.name in own else each)
    return replace(one, stages=tuple(stages))


def bound_like(stage: Stage, other: Stage, before: set[str]) -> Stage:
    """A stage bound as another one is; before: what the pass has written so far.

    Names that both have mean the same. Of the rest, what belongs to a light has the number that the other stage's names
    have, and what the irradiance map keeps to itself has its prefix.
    """
    shared = {**other.reads, **other.writes}
    numbers = {name.removeprefix(TEXEL).removeprefix(own) for own, name in shared.items() if own in name}
    number = max((each for each in numbers if each[1:].isdigit()), default="")
    new = set(stage.writes) - set(shared)

    def rename(name: str) -> str:
        if name in shared:
            return shared[name]
        numbered = name + number if name in new or name in (*UNIFORMS, *BUFFERS) else name
        return TEXEL + numbered if TEXEL + numbered in before else numbered

    return stage.renamed(rename)
