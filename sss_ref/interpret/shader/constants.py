"""Where each constant of a shader lies in the one buffer that holds them all, and that buffer's bytes.

Three sets of rules: std140 of OpenGL and Vulkan; the uniform address space of WGSL, which says the same of what we
have; and the constant buffers of Direct3D (OpenGL 4.6 section 7.6.2.2; WGSL "Alignment and Size"; HLSL "Packing Rules
for Constant Variables"). All have rows of 16 bytes, in which lines of matrices and elements of arrays begin.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.language.types import Array, ivec2, mat3, mat4, vec2, vec3, vec4

ROW = 16  # bytes
SIZES = {float: 4, int: 4, bool: 4, vec2: 8, ivec2: 8, vec3: 12, vec4: 16}
LINES = {mat3: (3, vec3), mat4: (4, vec4)}  # of a matrix: how many, and the type of one


@dataclass(frozen=True)
class Places:
    """Name -> where a constant begins, and the size of the buffer, a multiple of 16; both in bytes."""

    offsets: Mapping[str, int]
    size: int


def places(kinds: Mapping[str, Any], lengths: Mapping[str, int], direct3d: bool = False) -> Places:
    """Where constants of these types lie, in this order.

    lengths: of those that are arrays. direct3d: by its rules, where a vector begins wherever it does not reach beyond
    its row, and what follows an array or a matrix may lie in the rest of its last row.
    """
    offsets, end = {}, 0
    for name, kind in kinds.items():
        count, line = _lines(kind, lengths.get(name))
        if count:
            begin, size = _next(end, ROW), ROW * (count - 1) + (SIZES[line] if direct3d else ROW)
        else:
            begin, size = _begin(end, line, direct3d), SIZES[line]
        offsets[name], end = begin, begin + size
    return Places(offsets, _next(end, ROW))


def packed(values: Mapping[str, Any], kinds: Mapping[str, Any], where: Places, direct3d: bool = False) -> bytes:
    """The bytes of a buffer; values: name -> number, vector (N,), array (N,) or (N, C), or matrix M[row][column].

    A matrix is stored column by column; for Direct3D, where our shaders call it row_major, row by row.
    """
    data = bytearray(where.size)
    for name, kind in kinds.items():
        value = np.asarray(values[name])
        lines = (value if direct3d else value.T) if kind in LINES else value
        many = kind in LINES or get_origin(kind) is Array
        for number, line in enumerate(lines if many else [lines]):
            stored = _bytes(line, get_args(kind)[0] if get_origin(kind) is Array else kind)
            begin = where.offsets[name] + ROW * number
            data[begin : begin + len(stored)] = stored
    return bytes(data)


def _bytes(value: np.ndarray, kind: Any) -> bytes:
    """One line of a constant; integers and truth values take four bytes as numbers do."""
    whole = kind in (int, bool, ivec2)
    return np.ascontiguousarray(value, "<i4" if whole else "<f4").tobytes()


def _lines(kind: Any, length: int | None) -> tuple[int, Any]:
    """How many rows a constant has of its own, 0 for what may share one; and the type of what is in a row."""
    if get_origin(kind) is Array:
        return length or 0, get_args(kind)[0]
    return LINES.get(kind, (0, kind))


def _begin(end: int, kind: Any, direct3d: bool) -> int:
    """Where a number or vector begins after what ends here."""
    if direct3d:
        return end if end % ROW + SIZES[kind] <= ROW else _next(end, ROW)
    return _next(end, ROW if kind is vec3 else SIZES[kind])


def _next(offset: int, step: int) -> int:
    """The next multiple of a step."""
    return -(-offset // step) * step
