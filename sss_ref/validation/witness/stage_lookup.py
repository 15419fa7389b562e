"""Which stage a witness is of: told in a few words, and found again in this installation."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sss_ref.errors import StageError
from sss_ref.interpret.shader import stage_source
from sss_ref.language.parallel_rays import Rays
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture, ivec2, mat3, mat4, vec2, vec3, vec4
from sss_ref.language.typing_rules import type_name
from sss_ref.methods.stages import all_stages

RAYS = (
    Rays("light_position", "light_direction", "_directional"),
    Rays("camera_position", "camera_direction", "_orthographic"),
)
ELEMENTS = (float, int, bool, vec2, vec3, vec4)
KINDS = {type_name(kind): kind for kind in (*ELEMENTS, ivec2, mat3, mat4)} | {
    type_name(many): many
    for kind in ELEMENTS
    for many in (Texture[kind], Array[kind])  # type: ignore[valid-type]
}


@dataclass(frozen=True)
class StageTold:
    """name: of its Python function. kinds: own name -> type, where that is another than its source has.

    rays: the suffixes of those that are parallel. source: a hash of all that it computes.
    """

    name: str
    kinds: Mapping[str, str]
    rays: tuple[str, ...]
    source: str

    @classmethod
    def of(cls, stage: Stage) -> "StageTold":
        """Of a stage, ours or the user's."""
        rays = tuple(rays.suffix for rays in RAYS if rays.suffix in stage.variant[0])
        ours = all_stages().get(stage.python.__name__)
        own = _kinds(ours) if ours else {}
        kinds = {name: type_name(kind) for name, kind in _kinds(stage).items() if own.get(name, kind) != kind}
        return cls(stage.python.__name__, kinds, rays, source_hash(stage))

    def found(self, others: Mapping[str, Stage]) -> Stage | None:
        """The stage of this name, made as that one was; None where there is none. others: the user's, by name."""
        stage = {**all_stages(), **{each.python.__name__: each for each in others.values()}}.get(self.name)
        try:
            return stage and self._made(stage)
        except (StageError, KeyError):  # another stage of the same name
            return None

    def _made(self, stage: Stage) -> Stage:
        retyped = stage.retyped(**{name: KINDS[kind] for name, kind in self.kinds.items()}) if self.kinds else stage
        for rays in (rays for rays in RAYS if rays.suffix in self.rays):
            retyped = rays.of(retyped)
        return retyped


def source_hash(stage: Stage) -> str:
    """Sixteen hexadecimal digits of what a stage computes, functions and constants included; no comment counts."""
    lines = stage_source(stage, {}).splitlines()
    code = "\n".join(line for line in lines if not line.lstrip().startswith("//"))
    return hashlib.sha256(code.encode()).hexdigest()[:16]


def _kinds(stage: Stage) -> dict[str, Any]:
    """The types of all that it reads and writes, by its own names."""
    return {**stage.parameters, **stage.outputs}
