"""A stage of your own in the place of one of ours: every interpreter then runs it, and no file of ours is touched."""

from collections.abc import Mapping
from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.names import TEXEL, Name
from sss_ref.language.pipeline import Method, Pass
from sss_ref.methods.inner_body import belongs_to_a_body
from sss_ref.methods.per_light import belongs_to_a_light


def with_stages(method: Method, own: Mapping[str, Stage]) -> Method:
    """The method with stages put in the place of those of these names."""
    return replace(method, passes=tuple(_with_stages(each, own) for each in method.passes)) if own else method


def _with_stages(this_pass: Pass, own: Mapping[str, Stage]) -> Pass:
    stages: list[Stage] = []
    for each in this_pass.stages:
        before = {name for stage in stages for name in stage.writes.values()}
        stages.append(bound_like(own[each.name], each, before) if each.name in own else each)
    return replace(this_pass, stages=tuple(stages))


def bound_like(stage: Stage, other: Stage, before: set[str]) -> Stage:
    """A stage bound as another one is; before: what the pass has written so far.

    Names that both have mean the same. Of the rest, what belongs to a light has the number that the other stage's names
    have, what belongs to a body is of the one that the other stage writes of, and what the irradiance map keeps to
    itself says so.
    """
    shared = {**other.reads, **other.writes}
    light = max(Name.of(name).light for name in shared.values())
    body = Name.of(next(iter(other.writes.values()))).body
    new = set(stage.writes) - set(shared)

    def rename(text: str) -> str:
        if text in shared:
            return shared[text]
        name = Name.of(text)
        if light and (text in new or belongs_to_a_light(text)):
            name = name.of_light(light)
        if body and (text in new or belongs_to_a_body(text)):
            name = name.of_body(body)
        inside = str(name.at(TEXEL))
        return inside if inside in before else str(name)

    return stage.renamed(rename)
