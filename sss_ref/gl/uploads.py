"""What shaders read and write: buffers and uniform arrays as textures, row 0 at the bottom."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from sss_ref.interpret.shader import ARRAY_WIDTH, GLSL, Dialect, array_lengths
from sss_ref.language.layout import CHANNELS, dtype_of, shape_of
from sss_ref.language.types import vec3

if TYPE_CHECKING:
    from moderngl import Context, Texture

FORMATS = {"f": "f4", "i": "i4", "u": "u1"}  # kind of number -> moderngl's name: R32F, R32I and R8UI and their like


def filled(context: "Context", kind: Any, size: tuple[int, int], background: Any) -> "Texture":
    """A texture for a buffer of a type, to draw into, which holds the background everywhere.

    Three channels are stored as four: no OpenGL must be able to draw into three.
    """
    width, height = size
    data = np.empty(shape_of(kind, width, height), dtype_of(kind))
    data[...] = background
    return uploaded(context, np.concatenate([data, data[..., :1]], axis=-1) if kind is vec3 else data)


def uploaded(context: "Context", data: np.ndarray) -> "Texture":
    """A texture of an array (H, W) or (H, W, C), float32, int32 or uint8, read without any filter."""
    channels = 1 if data.ndim == 2 else data.shape[2]
    size, dtype = (data.shape[1], data.shape[0]), FORMATS[data.dtype.kind]
    texture = context.texture(size, channels, np.ascontiguousarray(data).tobytes(), alignment=1, dtype=dtype)
    texture.filter = (context.NEAREST, context.NEAREST)
    return texture


def texture_data(uniforms: Mapping[str, Any], dialect: Dialect = GLSL) -> dict[str, np.ndarray]:
    """What the uniforms that are textures hold, (H, W) or (H, W, C): pictures, and arrays too long for a shader."""
    arrays = {name: np.asarray(value) for name, value in uniforms.items() if np.ndim(value)}
    pictures = {name: value for name, value in arrays.items() if value.ndim == 3}
    longer = arrays.keys() - pictures.keys() - array_lengths(uniforms, dialect).keys()
    return pictures | {name: _rows(value) for name, value in arrays.items() if name in longer}


def _rows(values: np.ndarray) -> np.ndarray:
    """A uniform array (N,) or (N, C) as the dialect's `element` reads it: row after row, filled up with 0."""
    rows = -(-len(values) // ARRAY_WIDTH)
    data = np.zeros((rows * ARRAY_WIDTH, *values.shape[1:]), values.dtype)
    data[: len(values)] = values
    return data.reshape(rows, ARRAY_WIDTH, *values.shape[1:])


def downloaded(texture: "Texture", kind: Any) -> np.ndarray:
    """The buffer of a type that a texture holds: (H, W), or (H, W, C) for vectors."""
    data = np.frombuffer(texture.read(alignment=1), dtype_of(kind))
    data = data.reshape(texture.height, texture.width, texture.components)
    return (data[..., 0] if CHANNELS[kind] == 1 else data[..., : CHANNELS[kind]]).copy()
