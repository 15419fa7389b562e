"""Rendering only part of the way: which buffers there are up to a pass, a stage or a buffer."""

from sss_ref.errors import SceneError
from sss_ref.language.pipeline import Method


def buffers_until(method: Method, end: str) -> list[str]:
    """The buffers of a method in order, up to the last one that `end` writes.

    end: the name of a pass, a stage or a buffer; where two have the same name, the pass counts before the stage.
    Raises SceneError for any other name.
    """
    lasts = {name: name for name in method.outputs}
    stages = [stage for one in method.passes for stage in one.stages]
    lasts |= {stage.name: name for stage in stages for name in stage.writes.values() if name in method.outputs}
    lasts |= {one.name: list(one.outputs)[-1] for one in method.passes}
    if end not in lasts:
        raise SceneError(f"until: expected a pass, a stage or a buffer ({', '.join(lasts)}), got {end!r}")
    names = list(method.outputs)
    return names[: names.index(lasts[end]) + 1]
