"""What a WGSL shader says it is given: read from its text, so that a user's shader is served like ours, by names."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sss_ref.errors import ShaderError
from sss_ref.errors.wording import told
from sss_ref.interpret.shader import WGSL
from sss_ref.interpret.shader.constants import Places, places

BINDING = re.compile(r"@group\((\d+)\)\s*@binding\((\d+)\)\s*var(<uniform>)?\s+(\w+)\s*:\s*([\w<>]+)\s*;")
ATTRIBUTE = re.compile(r"@location\((\d+)\)\s*(\w+)\s*:\s*[\w<>]+")
FIELD = re.compile(r"(\w+)\s*:\s*([\w<>]+)\s*,?\s*")
SHORT = re.compile(r"^((?:vec|mat)\w+)([fi])$")  # vec3f is vec3<f32>
COMMENT = re.compile(r"//[^\n]*")
SAMPLES = {"f32": "unfilterable-float", "i32": "sint", "u32": "uint"}  # type of a texel -> how WebGPU calls it
KINDS = {name: kind for kind, name in WGSL.types.items()} | {"u32": bool}  # a truth value is a number there


@dataclass(frozen=True)
class Texture2D:
    """A texture that a shader reads: its binding, its name, and the type of its texels."""

    binding: int
    name: str
    texel: str


@dataclass(frozen=True)
class Constants:
    """A shader's constants: their binding, the type of each by name, and where it lies."""

    binding: int
    kinds: Mapping[str, Any]
    places: Places


@dataclass(frozen=True)
class Resources:
    """All that a shader reads, which is in one group."""

    group: int
    textures: tuple[Texture2D, ...]
    constants: Constants | None


def resources_of(text: str, where: str) -> Resources:
    """What a shader declares; raises ShaderError, naming `where`, for what is neither texture nor number."""
    plain = COMMENT.sub("", text)
    found = BINDING.findall(plain)
    textures = tuple(
        Texture2D(int(binding), name, _texel(kind, name, where))
        for _, binding, uniform, name, kind in found
        if not uniform
    )
    constants = [_constants(plain, int(binding), kind, where) for _, binding, uniform, _, kind in found if uniform]
    groups = {int(group) for group, *_ in found}
    if len(groups) > 1 or len(constants) > 1:
        came = f"{len(groups)} and {len(constants)}"
        raise ShaderError(told(where, "one group, with one struct of uniforms", came, "bind all as our shaders do"))
    return Resources(groups.pop() if groups else 0, textures, constants[0] if constants else None)


def attributes_of(text: str, names: Mapping[str, Any]) -> dict[str, int]:
    """Attribute of a vertex -> location, of those among `names` that a vertex shader takes."""
    entry = COMMENT.sub("", text).partition("@vertex")[2].partition("->")[0]
    return {name: int(location) for location, name in ATTRIBUTE.findall(entry) if name in names}


def _texel(kind: str, name: str, where: str) -> str:
    texel = kind.removeprefix("texture_2d<").removesuffix(">")
    if texel not in SAMPLES:
        raise ShaderError(told(where, f"{name} to be a texture_2d of f32, i32 or u32", kind, "declare it so"))
    return texel


def _constants(text: str, binding: int, struct: str, where: str) -> Constants:
    inside = re.search(rf"struct\s+{re.escape(struct)}\s*{{([^}}]*)}}", text)
    kinds = {}
    for name, kind in FIELD.findall(inside[1]) if inside else []:
        plain = SHORT.sub(lambda short: f"{short[1]}<{short[2]}32>", kind)
        if plain not in KINDS:
            raise ShaderError(told(where, f"{name} to be of type {', '.join(KINDS)}", kind, "declare it so"))
        kinds[name] = KINDS[plain]
    if not kinds:
        raise ShaderError(told(where, f"a struct {struct} with the uniforms", "none", "define it in this file"))
    return Constants(binding, kinds, places(kinds, {}))
