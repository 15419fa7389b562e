"""How values of the language lie in a buffer: channels, element type, shape."""

from typing import Any

import numpy as np

from sss_ref.language.types import ivec2, vec2, vec3, vec4

WRITTEN = (float, vec2, vec3, int, bool)  # of these types are the buffers that stages write
CHANNELS = {float: 1, int: 1, bool: 1, vec2: 2, ivec2: 2, vec3: 3, vec4: 4}
FLOAT32 = np.dtype("<f4")
DTYPES: dict[Any, np.dtype] = {int: np.dtype("<i4"), bool: np.dtype("u1")}  # of all other types: float32


def dtype_of(kind: Any) -> np.dtype:
    """The element type of a buffer that holds values of a type."""
    return DTYPES.get(kind, FLOAT32)


def shape_of(kind: Any, width: int, height: int) -> tuple[int, ...]:
    """The shape of a buffer that holds values of a type: (H, W), or (H, W, C) for vectors."""
    return (height, width) if CHANNELS[kind] == 1 else (height, width, CHANNELS[kind])
