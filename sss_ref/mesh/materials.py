"""The materials of a mesh file, as far as a colour goes."""

from dataclasses import dataclass
from typing import Any

import numpy as np

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Material:
    """What a file says about the colour of some of its triangles."""

    name: str = ""
    color: Rgb | None = None  # linear RGB: Kd as it stands, or baseColorFactor; None where the file gives none
    textured: bool = False  # whether the file has a colour texture for it, which is not read


def material_of(visual: Any) -> Material:
    """The material of one part, from what trimesh made of it."""
    found = getattr(visual, "material", None)
    name = str(getattr(found, "name", None) or "")
    color = _rgb(getattr(found, "kwargs", {}).get("kd"))
    return Material(name, color, getattr(found, "image", None) is not None)


def _rgb(value: Any) -> Rgb | None:
    """The first three of the numbers a file has, if they make a colour: finite and >= 0; else None."""
    try:
        red, green, blue = np.asarray(value, np.float64)[:3].tolist()
    except (TypeError, ValueError, IndexError):
        return None
    is_color = all(np.isfinite(np.float32(part)) and part >= 0 for part in (red, green, blue))
    return (red, green, blue) if is_color else None
