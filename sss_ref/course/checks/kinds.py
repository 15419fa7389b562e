"""What an exercise asks for: a number, a direction, an array; and how to say what came instead."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from sss_ref.language import vec3


@dataclass(frozen=True)
class Kind:
    """A kind of value.

    words: what it is. read: the value as this kind, None where it is of another one. numeric: whether it is numbers.
    """

    words: str
    read: Callable[[Any], Any]
    numeric: bool = True


def described(value: Any) -> str:
    """What a value is, in the words of a hint."""
    if value is None:
        return "None"
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and type {value.dtype}"
    if isinstance(value, (str, bytes)):
        return f"a text ({value[:20]!r})"
    if isinstance(value, (bool, np.bool_)):
        return str(value)
    if isinstance(value, (tuple, list, dict, set, frozenset)):
        return f"a {type(value).__name__} of {len(value)}"
    if isinstance(value, (int, float, np.number)) and not isinstance(value, np.complexfloating):
        return f"the number {value:g}"
    return "a function (not called, for want of brackets?)" if callable(value) else f"a {type(value).__name__}"


def _number(value: Any) -> float | None:
    array = _numbers(value)
    return float(array) if array is not None and array.shape == () else None


def _whole(value: Any) -> int | None:
    number = _number(value)
    return int(number) if number is not None and np.isfinite(number) and number == round(number) else None


def _yes_or_no(value: Any) -> bool | None:
    return bool(value) if isinstance(value, (bool, np.bool_)) else None


def _direction(value: Any) -> np.ndarray | None:
    array = _numbers([*value] if isinstance(value, vec3) else value)
    return array if array is not None and array.shape == (3,) else None


def _numbers(value: Any) -> np.ndarray | None:
    """Real numbers as float64, None for anything else; texts that look like numbers are none."""
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different length
        return None
    return array.astype(np.float64) if array.dtype.kind in "fiu" else None


def array_of(*shape: int) -> Kind:
    """Real numbers of a shape."""

    def read(value: Any) -> np.ndarray | None:
        array = _numbers(value) if isinstance(value, np.ndarray) else None
        return array if array is not None and array.shape == shape else None

    return Kind(f"an array of {' x '.join(map(str, shape))} real numbers", read)


NUMBER = Kind("a number", _number)
WHOLE = Kind("a whole number", _whole)
YES_OR_NO = Kind("True or False", _yes_or_no)
DIRECTION = Kind("a vec3", _direction)
