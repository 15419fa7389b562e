"""Where each constant of a shader lies in the one buffer that holds them all, and that buffer's bytes.

One set of rules for all languages: std140 of OpenGL and Vulkan (OpenGL 4.6 section 7.6.2.2). Those of WGSL's uniforms
("Alignment and Size") say the same of what we have, and HLSL lets a constant lie wherever it does not reach beyond its
row of 16 bytes ("Packing Rules for Constant Variables"), so there each says where it lies. Lines of a matrix and
elements of an array have a row each, and nothing shares the last of them.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.language.types import Array, ivec2, mat3, mat4, vec2, vec3, vec4

ROW = 16  # bytes
SIZES = {float: 4, int: 4, bool: 4, vec2: 8, ivec2: 8, vec3: 12, vec4: 16}
ALIGNED = {**SIZES, vec3: ROW}
LINES = {mat3: 3, mat4: 4}
WHOLE = (int, bool, ivec2)


@dataclass(frozen=True)
class Places:
    """Name -> where a constant begins, and the size of the buffer, a multiple of 16; both in bytes."""

    offsets: Mapping[str, int]
    size: int


def places(kinds: Mapping[str, Any], lengths: Mapping[str, int]) -> Places:
    """Where constants of these types lie, in this order; lengths: of those that are arrays."""
    offsets, end = {}, 0
    for name, kind in kinds.items():
        rows = lengths[name] if get_origin(kind) is Array else LINES.get(kind, 0)
        offsets[name] = _next(end, ROW if rows else ALIGNED[kind])
        end = offsets[name] + (ROW * rows if rows else SIZES[kind])
    return Places(offsets, _next(end, ROW))


def packed(values: Mapping[str, Any], kinds: Mapping[str, Any], where: Places) -> bytes:
    """The bytes of a buffer, with matrices column by column, and integers and truth values in four bytes each.

    values: name -> number, vector (N,), array (N,) or (N, C), or matrix M[row][column].
    """
    data = bytearray(where.size)
    for name, kind in kinds.items():
        for number, line in enumerate(_lines(np.asarray(values[name]), kind)):
            begin = where.offsets[name] + ROW * number
            data[begin : begin + len(line)] = line
    return bytes(data)


def _lines(value: np.ndarray, kind: Any) -> list[bytes]:
    """What has a row of its own, or begins in one."""
    array = get_origin(kind) is Array
    element = get_args(kind)[0] if array else kind
    numbers = value.T if kind in LINES else value
    stored = np.ascontiguousarray(numbers, "<i4" if element in WHOLE else "<f4")
    return [line.tobytes() for line in (stored if array or kind in LINES else [stored])]


def _next(offset: int, step: int) -> int:
    """The next multiple of a step."""
    return -(-offset // step) * step
