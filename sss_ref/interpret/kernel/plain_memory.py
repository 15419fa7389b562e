"""What kernels call to touch memory, in Python: what assembly.py and row_memory.py have compilers do instead.

By this they run where numba's compiler is off. A pointer is an array here, an address a number as there.
"""

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np

FUNCTIONS: list[Callable[..., None]] = []


class PlainFunction:
    """A function of rows; its address is its number among FUNCTIONS."""

    def __init__(self, function: Callable[..., None]) -> None:
        self.address = len(FUNCTIONS)
        FUNCTIONS.append(function)


def call(
    address: int,
    scratch: np.ndarray,
    count: int,
    rows: np.ndarray,
    first_row: int,
    uniforms: np.ndarray,
    first_uniform: int,
    tables: np.ndarray,
    first_table: int,
) -> None:
    """Call the function of rows at an address; rows, uniforms and tables: arrays, each from an element on."""
    FUNCTIONS[address](scratch, count, rows[first_row:], uniforms[first_uniform:], tables[first_table:])


def read_float(memory: np.ndarray, index: Any) -> Any:
    """A float32 of the scratch or of the uniforms."""
    return memory[index]


def read_int(memory: np.ndarray, index: Any) -> Any:
    """The bits of a float32 there as int32."""
    return memory.view(np.int32)[index]


def reread_float(row: int, memory: np.ndarray, index: Any) -> Any:
    """A float32 of a row that is written."""
    return memory[index]


def reread_int(row: int, memory: np.ndarray, index: Any) -> Any:
    """An int32 of a row that is written."""
    return memory.view(np.int32)[index]


def write_float(row: int, memory: np.ndarray, index: Any, value: Any) -> None:
    """Write a float32 into a row."""
    memory[index] = value


def write_int(row: int, memory: np.ndarray, index: Any, value: Any) -> None:
    """Write an int32 into a row."""
    memory.view(np.int32)[index] = value


def texel_float(address: int, index: Any) -> Any:
    """A float32 of a texture or array."""
    return np.float32(ctypes.c_float.from_address(int(address) + 4 * int(index)).value)


def texel_int(address: int, index: Any) -> Any:
    """An int32 of a texture or array."""
    return np.int32(ctypes.c_int32.from_address(int(address) + 4 * int(index)).value)


def texel_byte(address: int, index: Any) -> Any:
    """A byte of a texture or array."""
    return np.uint8(ctypes.c_uint8.from_address(int(address) + int(index)).value)


def put_float(address: int, index: Any, value: Any) -> None:
    """Write a float32 into a buffer."""
    ctypes.c_float.from_address(int(address) + 4 * int(index)).value = float(value)


def put_word(address: int, index: Any, value: Any) -> None:
    """Write 32 bits into a buffer."""
    ctypes.c_int32.from_address(int(address) + 4 * int(index)).value = int(value)


def put_byte(address: int, index: Any, value: Any) -> None:
    """Write a byte into a buffer."""
    ctypes.c_uint8.from_address(int(address) + int(index)).value = int(value)


def chosen(condition: Any, if_true: Any, if_false: Any) -> Any:
    """The language's only choice."""
    return if_true if condition else if_false
