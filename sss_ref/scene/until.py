"""Which buffers come out: those that are asked for by name, or all up to a pass, a stage or a buffer."""

from collections.abc import Iterable

from sss_ref.errors import SceneError
from sss_ref.language.pipeline import Method


def buffers_kept(method: Method, keep: str | Iterable[str]) -> set[str]:
    """The buffers of a method that some names stand for.

    keep: a name or several, of buffers and of groups. "all" is what the method writes unless told otherwise, "final"
    the image. What "all" leaves out is there on demand: "taps", the single taps of the blur, tap_00, tap_01 and so on;
    "registers", what a pass computes on the way and no target holds, such as texel_thickness in the irradiance map,
    partial_lit_1 of one light among several, exact_lit before a target of eight bits rounds it.
    Raises SceneError for a name that the method does not have.
    """
    named = [keep] if isinstance(keep, str) else list(keep)
    groups = {"all": list(method.outputs), "final": ["image"], **method.on_demand}
    known = {name: [name] for name in method.values} | groups
    for wrong in (name for name in named if name not in known):
        listed = ", ".join([*method.outputs, *method.on_demand])
        raise SceneError(f'keep: expected "all", "final" or names of buffers ({listed}), got {wrong!r}')
    return {buffer for name in named for buffer in known[name]}


def buffers_until(method: Method, end: str) -> list[str]:
    """The buffers of a method in order, up to the last one that `end` writes.

    end: the name of a pass, a stage or a buffer; where two have the same name, the pass counts before the stage.
    Raises SceneError for any other name.
    """
    lasts = {name: name for name in method.outputs}
    stages = [stage for each in method.passes for stage in each.stages]
    lasts |= {stage.name: name for stage in stages for name in stage.writes.values() if name in method.outputs}
    lasts |= {each.name: list(each.outputs)[-1] for each in method.passes}
    if end not in lasts:
        raise SceneError(f"until: expected a pass, a stage or a buffer ({', '.join(lasts)}), got {end!r}")
    names = list(method.outputs)
    return names[: names.index(lasts[end]) + 1]
