"""What the stages of a shader read from outside, and how the shader declares it."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin

from sss_ref.interpret.shader.dialect import Dialect
from sss_ref.language.pipeline import PIXEL
from sss_ref.language.stage import Stage
from sss_ref.language.types import Array, Texture


@dataclass
class Reads:
    """textures: name -> type of a texel; here: the textures that are read at the pixel itself; uniforms: the rest."""

    textures: dict[str, Any] = field(default_factory=dict)
    here: dict[str, Any] = field(default_factory=dict)
    uniforms: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, stages: Iterable[Stage], inside: Collection[str], buffers: Collection[str]) -> "Reads":
        """What these stages read beside `inside`; `buffers` are what earlier passes have written."""
        reads = cls()
        pairs = {(stage.reads[own], kind) for stage in stages for own, kind in stage.parameters.items()}
        for name, kind in sorted((pair for pair in pairs if pair[0] not in inside), key=str):
            if get_origin(kind) is Texture:
                reads.textures[name] = get_args(kind)[0]
            elif name in buffers:
                reads.here[name] = reads.textures[name] = kind
            else:
                reads.uniforms[name] = kind
        return reads

    def all_textures(self, lengths: Mapping[str, int]) -> dict[str, Any]:
        """Name -> type of the textures; lengths: uniform array -> its length (of others: a texture)."""
        textures = {name: Texture[kind] for name, kind in self.textures.items()}  # type: ignore[valid-type]
        return textures | self._arrays(lengths)

    def values(self, lengths: Mapping[str, int]) -> dict[str, Any]:
        """Name -> type of the uniforms that are no textures."""
        arrays = self._arrays(lengths)
        return {name: kind for name, kind in self.uniforms.items() if name not in arrays}

    def _arrays(self, lengths: Mapping[str, int]) -> dict[str, Any]:
        """The uniform arrays that are textures."""
        return {n: kind for n, kind in self.uniforms.items() if get_origin(kind) is Array and n not in lengths}

    def fetches(self, dialect: Dialect) -> list[str]:
        """The lines that give the buffers' values at the pixel itself a name."""
        return [
            dialect.defined(kind, f"{name}_here", dialect.fetched(kind, dialect.name(name), PIXEL))
            for name, kind in self.here.items()
        ]

    def argument(self, name: str, kind: Any, dialect: Dialect) -> str:
        """What a stage is handed for a parameter of this type."""
        return dialect.name(f"{name}_here" if name in self.here and get_origin(kind) is not Texture else name)
