"""The materials of a mesh file, as far as a colour goes: MTL files beside OBJ, and the materials of glTF."""

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

GLTF_DEFAULT = (1.0, 1.0, 1.0)  # glTF 2.0, baseColorFactor of a material that does not give one

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Material:
    """What a file says about the colour of some of its triangles."""

    name: str = ""
    color: Rgb | None = None  # linear RGB: Kd as it stands, or baseColorFactor; None where the file gives none
    textured: bool = False  # whether the file has a colour texture for it, which is not read


def material_of(visual: Any, exact: Mapping[tuple[str, bytes], Rgb] | None) -> Material:
    """The material of one part, from what trimesh made of it.

    exact: of a glTF file, what `gltf_colors` gives; None for every other format.
    """
    found = getattr(visual, "material", None)
    name = str(getattr(found, "name", None) or "")
    if exact is None:
        color = _rgb(getattr(found, "kwargs", {}).get("kd"))
        return Material(name, color, getattr(found, "image", None) is not None)
    rounded = getattr(found, "baseColorFactor", None)
    color = GLTF_DEFAULT if rounded is None else exact.get((name, np.asarray(rounded).tobytes()))
    return Material(name, color, getattr(found, "baseColorTexture", None) is not None)


def gltf_colors(path: Path) -> dict[tuple[str, bytes], Rgb] | None:
    """The colours of a glTF file as it has them, by name and by the 8 bits a channel that trimesh keeps of them.

    None for a file of another format.
    """
    if path.suffix.lower() not in (".gltf", ".glb"):
        return None
    from trimesh.visual.color import to_rgba

    colors = {}
    for material in _header(path.read_bytes()).get("materials", []):
        factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor")
        color = _rgb(factor)
        if color:
            rounded = to_rgba(np.array(factor, np.float64))
            colors[str(material.get("name") or ""), rounded.tobytes()] = color
    return colors


def _header(content: bytes) -> dict[str, Any]:
    """The JSON of a glTF file, or the first chunk of a GLB file, which trimesh has read before."""
    if content[:4] == b"glTF":
        (size,) = struct.unpack_from("<I", content, 12)
        content = content[20 : 20 + size]
    return json.loads(content)


def _rgb(value: Any) -> Rgb | None:
    """The first three of the numbers a file has, if they make a colour: finite and >= 0; else None."""
    try:
        red, green, blue = np.asarray(value, np.float64)[:3].tolist()
    except (TypeError, ValueError, IndexError):
        return None
    is_color = all(np.isfinite(np.float32(part)) and part >= 0 for part in (red, green, blue))
    return (red, green, blue) if is_color else None
