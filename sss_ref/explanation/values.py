"""Values and intervals as text: decimal digits that give back the float32, and its bit pattern."""

from typing import Any

import numpy as np

from sss_ref.interpret.trace import Bounds
from sss_ref.language.types import Array, Texture, components, mat3, mat4


def shown(value: Any) -> str:
    """A value of the language: numbers, true or false, (x, y, z); of textures and arrays how large they are."""
    if isinstance(value, Texture):
        height, width = value.data.shape[:2]
        return f"{width} x {height} texels"
    if isinstance(value, Array):
        return f"{len(value.data)} elements"
    if isinstance(value, mat3 | mat4):
        return f"{len(value.rows)} x {len(value.rows)} matrix"
    parts = [_number(part) for part in components(value)]
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"


def bits(value: Any) -> str:
    """The bit patterns of a value's floats, in hexadecimal; nothing for what has none."""
    if isinstance(value, Texture | Array | mat3 | mat4):
        return ""
    floats = [part for part in components(value) if isinstance(part, float | np.floating)]
    return " ".join(f"{int(np.float32(part).view(np.uint32)):08x}" for part in floats)


def between(bounds: Bounds) -> str:
    """All values between two, both included: [low, high], of vectors for each component; "exact" if there is one."""
    ends = list(zip(*map(components, bounds), strict=True))
    if all(low == high for low, high in ends):
        return "exact"
    parts = [_interval(low, high) for low, high in ends]
    return parts[0] if len(parts) == 1 else f"({', '.join(parts)})"


def _interval(low: Any, high: Any) -> str:
    """All numbers between two, both included."""
    if low == high:
        return _number(low)
    if isinstance(low, bool | np.bool_):
        return "false or true"
    return "anything" if np.isinf([low, high]).all() else f"[{_number(low)}, {_number(high)}]"


def _number(part: Any) -> str:
    if isinstance(part, bool | np.bool_):
        return "true" if part else "false"
    if isinstance(part, float | np.floating):
        return str(np.float32(part)).removesuffix(".0")
    return str(int(part))
