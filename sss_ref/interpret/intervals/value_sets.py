"""Values of the language as sets: fetches that may hit several texels, results of several cases joined.

A value is an Interval, a vector of them, `Texels`, or a uniform array or matrix, which is known exactly.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import product
from typing import Any

import numpy as np

from sss_ref.language.types import Vector, components, vec2, vec3, vec4
from sss_ref.numerics.interval import INFINITY, Interval, each_end, hull

CANDIDATES = 3  # texels side by side on an axis that a fetch may choose among; beyond, it may give anything
INT32 = np.iinfo(np.int32)


@dataclass(frozen=True, eq=False)
class Texels:
    """A buffer read at any texel, each known to lie between two values; arrays as in `Texture`.

    span: the length of its range, where its texels are bytes; 0 of any others.
    """

    low: np.ndarray
    high: np.ndarray
    span: float = 0.0


def componentwise(operation: Callable[..., Interval], *values: Any) -> Any:
    """An operation on scalars, component by component where a vector is among the values."""
    vector = next((value for value in values if isinstance(value, Vector)), None)
    if vector is None:
        return operation(*values)
    columns = [list(value) if isinstance(value, Vector) else [value] * vector.count for value in values]
    return type(vector)(*(operation(*row) for row in zip(*columns, strict=True)))


def computable(array: Any) -> Any:
    """Numbers in the type that intervals compute with; a buffer's uint8 is a truth value."""
    array = np.asarray(array)
    if array.dtype in (np.uint8, np.bool_):
        return array != 0
    return array.astype(np.float64 if array.dtype.kind == "f" else np.int64)


def fetched(low: np.ndarray, high: np.ndarray, index: Sequence[Interval]) -> tuple[Any, Any]:
    """What arrays hold at an index that may be several, and where that is more than one value.

    low, high: what each element lies between; one axis more than the index has holds a vector's components. An index
    that may lie outside, or be one of more than CANDIDATES on an axis, may give anything.
    """
    value, inside = _stored(low, high, index)
    wide = reduce(np.logical_or, [at.undecided for at in inside])
    if not np.any(wide):
        return value, np.False_
    several = _one_of_several(low, high, [picked(at, wide) for at in inside])
    differs = np.zeros(np.shape(wide), bool)
    differs[wide] = reduce(np.logical_or, [component.undecided for component in components(several)])
    return componentwise(lambda a, b: _put(a, wide, hull(picked(a, wide), b)), value, several), differs


def _stored(low: np.ndarray, high: np.ndarray, index: Sequence[Interval]) -> tuple[Any, Sequence[Interval]]:
    """What arrays hold at the first of all indices, or anything where one lies outside; and the indices inside."""
    counted = list(zip(index, low.shape[: len(index)], strict=True))
    outside = reduce(np.logical_or, [(at.low < 0) | (at.high >= count) for at, count in counted])
    if not np.any(outside):
        return _gathered(low, high, [at.low for at in index]), index
    inside = [each_end(lambda end, last=count - 1: np.clip(end, 0, last), at) for at, count in counted]
    value = _gathered(low, high, [at.low for at in inside])
    return componentwise(lambda a: anything_where(outside, a), value), inside


def _one_of_several(low: np.ndarray, high: np.ndarray, index: Sequence[Interval]) -> Any:
    """The hull of all elements that the index may mean."""
    widths = [at.high - at.low for at in index]
    turns = product(*(range(min(int(width.max()), CANDIDATES - 1) + 1) for width in widths))
    candidates = ([np.minimum(at.low + step, at.high) for at, step in zip(index, turn, strict=True)] for turn in turns)
    found = componentwise(hull, *(_gathered(low, high, candidate) for candidate in candidates))
    too_many = reduce(np.logical_or, [width >= CANDIDATES for width in widths])
    return componentwise(lambda a: anything_where(too_many, a), found)


def anything_where(undefined: Any, a: Interval) -> Interval:
    """Any value of its type where it is undefined."""
    if not np.any(undefined):
        return a
    least, most = {"f": (-INFINITY, INFINITY), "b": (False, True)}.get(a.low.dtype.kind, (INT32.min, INT32.max))
    return Interval(np.where(undefined, least, a.low), np.where(undefined, most, a.high))


def picked(value: Any, where: Any) -> Any:
    """A value at some of the fragments; what all fragments share stays as it is."""
    if isinstance(value, Vector):
        return componentwise(lambda a: picked(a, where), value)
    if not isinstance(value, Interval):
        return value
    return each_end(lambda end: end[where] if np.ndim(end) else end, value)


def joined(a: Any, where: Any, b: Any) -> tuple[Any, Any]:
    """The hull of a with b, which holds only the fragments `where`; and where the two lie apart."""
    before = picked(a, where) if np.ndim(where) else a
    apart = reduce(
        np.logical_or,
        [(x.high < y.low) | (y.high < x.low) for x, y in zip(components(before), components(b), strict=True)],
    )
    both = componentwise(hull, before, b)
    if np.ndim(where) == 0:
        return both, apart
    spread = np.zeros(np.shape(where), bool)
    spread[where] = apart
    return componentwise(lambda x, y: _put(x, where, y), a, both), spread


def _gathered(low: np.ndarray, high: np.ndarray, index: Sequence[Any]) -> Any:
    """The elements at an index, which lies inside."""
    place = reduce(lambda flat, axis: flat * low.shape[axis] + index[axis], range(1, len(index)), index[0])
    channels = low.shape[len(index) :]
    lower = low.reshape(-1, *channels).take(place, axis=0)
    upper = lower if low is high else high.reshape(-1, *channels).take(place, axis=0)
    if not channels:
        return each_end(computable, Interval(lower, upper))
    vector = {2: vec2, 3: vec3, 4: vec4}[channels[0]]
    ends = Interval(lower, upper)
    return vector(*(each_end(lambda end, k=k: computable(end[..., k]), ends) for k in range(channels[0])))


def _put(a: Interval, where: np.ndarray, b: Interval) -> Interval:
    low, high = (np.broadcast_to(end, where.shape).copy() for end in (a.low, a.high))
    low[where], high[where] = b.low, b.high
    return Interval(low, high)
