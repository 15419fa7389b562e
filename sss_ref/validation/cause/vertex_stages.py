"""How the vertex stage of a draw is often misread, in the words that a report says of it."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from sss_ref.language import vec2, vec3, vec4
from sss_ref.language.pipeline import CLIP_POSITION
from sss_ref.language.stage import Stage
from sss_ref.validation.cause.hypothesis import SOURCE, Charge
from sss_ref.validation.cause.mistaken import computing, stages_mutated

Given = Mapping[str, Any]  # parameter of the stage -> value
ONE = np.float32(1)
POSITION, NORMAL, UV = "fragment_position", "fragment_normal", "fragment_uv"  # its outputs, by its own names


def _undivided(clip: Any, given: Given) -> Any:
    return vec4(clip.x, clip.y, clip.z, ONE)


def _divided(clip: Any, given: Given) -> Any:
    return vec4(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w, ONE)


def _downwards(clip: Any, given: Given) -> Any:
    return vec4(clip.x, -clip.y, clip.z, clip.w)


def _moved(normal: Any, given: Given) -> Any:
    model = given["normal"]
    return (given["world_from_model"] * vec4(model.x, model.y, model.z, ONE)).xyz


def _turned_by_the_model(normal: Any, given: Given) -> Any:
    model = given["normal"]
    return (given["world_from_model"] * vec4(model.x, model.y, model.z, np.float32(0))).xyz


def _unmoved(position: Any, given: Given) -> Any:
    model = given["position"]
    return (given["world_from_model"] * vec4(model.x, model.y, model.z, np.float32(0))).xyz


def _from_the_position(normal: Any, given: Given) -> Any:
    at = given["position"]
    return vec3(at.x, at.y, at.z)


def _from_the_top(uv: Any, given: Given) -> Any:
    return vec2(uv.x, ONE - uv.y)


MISREAD: tuple[tuple[str, str, Callable[[Any, Given], Any]], ...] = (  # in words, an output, what it is instead
    ("clip_position is not divided by w: its w is 1", CLIP_POSITION, _undivided),
    ("clip_position is divided by w in the shader, so nothing is in perspective between", CLIP_POSITION, _divided),
    ("clip_position.y is negated, as for y down", CLIP_POSITION, _downwards),
    ("the normal is turned by world_from_model, not by its inverse transpose", NORMAL, _turned_by_the_model),
    ("the normal is moved like a point: its w is 1, not 0", NORMAL, _moved),
    ("the position is turned and not moved: its w is 0, not 1", POSITION, _unmoved),
    ("the normal is the position, as on a sphere", NORMAL, _from_the_position),
    ("v counts from the top: 1 - uv.y", UV, _from_the_top),
)


def vertex_stages(right: Stage) -> Iterator[tuple[Charge, Stage]]:
    """A vertex stage as it is often misread, then with one place of its source changed, in words."""
    for text, output, change in MISREAD:
        if output in right.outputs:
            charge = Charge(f"{right.name}: {text}", SOURCE)
            yield charge, computing(right, _misread(right, output, change))
    yield from stages_mutated(right)


def _misread(right: Stage, output: str, change: Callable[[Any, Given], Any]) -> Callable[..., Any]:
    def compute(*inputs: Any) -> Any:
        given = dict(zip(right.parameters, inputs, strict=True))
        results = dict(zip(right.writes, right(*inputs), strict=True))
        with np.errstate(all="ignore"):
            return tuple((results | {output: change(results[output], given)}).values())

    return compute
