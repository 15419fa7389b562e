"""Values of the language as the bits of their numbers, for files: text that gives back every bit.

A number is eight hexadecimal digits: a float32, or an int32 in two's complement; a truth value is 0 or 1. The end of an
interval of floats is sixteen: a float64. Matrices go row by row. The elements of textures and arrays, of which there
are many, are base 64 of the same four bytes a number, the least significant first, and of one byte a truth value.
"""

import base64
import binascii
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.language.layout import CHANNELS
from sss_ref.language.types import Array, Texture, Vector, components, ivec2, mat3, mat4

WHOLE = (int, bool, ivec2)
SIDES = {mat3: 3, mat4: 4}


def bits_of(kind: Any, value: Any) -> str:
    """A value of a type, no texture or array, as hexadecimal digits, eight a number."""
    numbers = np.ravel(value.rows) if kind in SIDES else components(value)
    return _bytes_of(numbers, _number(kind, ">")).hex(" ", 4)


def value_of(kind: Any, text: str) -> Any:
    """The value, as scalars of the array interpreter. Raises ValueError for other digits, or too few."""
    count = SIDES[kind] ** 2 if kind in SIDES else CHANNELS[kind]
    numbers = _numbers(bytes.fromhex(text), _number(kind, ">"), count)
    if kind in SIDES:
        return kind(numbers.reshape(SIDES[kind], -1))
    parts = [bool(part) if kind is bool else int(part) if kind in WHOLE else part for part in numbers]
    return kind(*parts) if isinstance(kind, type) and issubclass(kind, Vector) else parts[0]


def ends_of(kind: Any, ends: Any) -> str:
    """One end each of the intervals of a value's components."""
    return _bytes_of(ends, _end(kind)).hex(" ", _end(kind).itemsize)


def ends_in(kind: Any, text: str) -> np.ndarray:
    """The ends, one a component. Raises ValueError as `value_of` does."""
    return _numbers(bytes.fromhex(text), _end(kind), CHANNELS[kind])


def elements_text(kind: Any, elements: np.ndarray) -> str:
    """Elements (N,) or (N, C) of a texture or array of a type."""
    return base64.b64encode(_bytes_of(elements, _stored(kind))).decode("ascii")


def elements_in(kind: Any, text: str) -> np.ndarray:
    """The elements (N, C). Raises ValueError as `value_of` does."""
    try:
        data = base64.b64decode(text, validate=True)
    except binascii.Error:
        raise ValueError("no base 64") from None
    channels, size = CHANNELS[element_of(kind)], _stored(kind).itemsize
    return _numbers(data, _stored(kind), len(data) // size // channels * channels).reshape(-1, channels)


def element_of(kind: Any) -> Any:
    """The type of an element of a texture or array."""
    return get_args(kind)[0]


def is_many(kind: Any) -> bool:
    """Whether a type holds elements, of which a stage reads some."""
    return get_origin(kind) in (Texture, Array)


def _number(kind: Any, order: str) -> np.dtype:
    return np.dtype(f"{order}{'i' if kind in WHOLE else 'f'}4")


def _stored(kind: Any) -> np.dtype:
    """How the numbers of a texture or array are stored."""
    return np.dtype("u1") if element_of(kind) is bool else _number(element_of(kind), "<")


def _end(kind: Any) -> np.dtype:
    return np.dtype(">i4" if kind in WHOLE else ">f8")


def _bytes_of(numbers: Any, dtype: np.dtype) -> bytes:
    return np.asarray(numbers).astype(dtype).tobytes()


def _numbers(data: bytes, dtype: np.dtype, count: int) -> np.ndarray:
    """The numbers in some bytes, in the order of the machine."""
    if len(data) != count * dtype.itemsize:
        raise ValueError(f"{count} numbers of {dtype.itemsize} bytes, in {len(data)}")
    return np.frombuffer(data, dtype).astype(dtype.newbyteorder("="))
