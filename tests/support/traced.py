"""What the tests of a stage's trace share: a stage with a loop, and what any stage reads at one pixel."""

from typing import NamedTuple

import numpy as np

from sss_ref.interpret.work import buffer_value, uniform_value
from sss_ref.language import Array, constant, function, pow, select, stage, vec2
from sss_ref.language.pipeline import PIXEL
from sss_ref.language.types import Vector, ivec2

THIRD = constant(1 / 3)


class Sum(NamedTuple):
    total: float
    flag: bool


@function
def twice(v: float) -> float:
    """V + v."""
    doubled = v + v
    return doubled


@stage(source="test")
def summed(start: float, offset: vec2, numbers: Array[float], count: int) -> Sum:
    """A loop with a call in it."""
    total = start
    for k in range(0, count):
        total = total + twice(numbers[k]) * offset.y
    scaled = select(total > 2.0, pow(total, 2.0), -total) * THIRD
    return Sum(scaled, total != 0.0)


def scalar(value):
    if isinstance(value, Vector):
        return type(value)(*map(scalar, value))
    return value[0] if isinstance(value, np.ndarray) else value


def inputs_at(stage_, inputs, row, column):
    """What a stage reads at one pixel, as scalars."""
    at = np.array([row]), np.array([column])
    for name, kind in stage_.parameters.items():
        if name == PIXEL:
            yield ivec2(np.int32(column), np.int32(row))
        elif name in inputs.buffers:
            yield scalar(buffer_value(kind, inputs.buffers[name], *at))
        else:
            yield uniform_value(kind, inputs.uniforms[name])
