"""The language's operators and primitives on intervals, for one kind of processor.

What a processor may compute in another way than it is written is taken whole: dot, normalize, mix, a bilinear blend,
matrix times vector.
"""

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import numpy as np

from sss_ref.interpret.intervals.profile import Profile
from sss_ref.interpret.intervals.value_sets import Texels, componentwise, fetched
from sss_ref.language.builtins import dot, mix, normalize
from sss_ref.language.sampling import bilinear_blend, nearest_texel, sample_bilinear, sample_repeated
from sss_ref.language.types import Vector, ivec2, mat3, mat4
from sss_ref.numerics import interval
from sss_ref.numerics.bounded import Bounded
from sss_ref.numerics.directed import downward, nearest, upward
from sss_ref.numerics.interval import Interval, each_end, negated, point

INT32 = np.iinfo(np.int32)
OnScalars = Callable[..., Interval]

COMPARISONS: dict[str, OnScalars] = {
    "<": interval.less,
    "<=": interval.less_equal,
    ">": lambda a, b: interval.less(b, a),
    ">=": lambda a, b: interval.less_equal(b, a),
    "==": interval.equal,
    "!=": lambda a, b: interval.opposite(interval.equal(a, b)),
}
LOGIC: dict[str, OnScalars] = {
    "&": lambda a, b: each_end(np.logical_and, a, b),
    "|": lambda a, b: each_end(np.logical_or, a, b),
}
INTEGER: dict[str, OnScalars] = {
    "min": lambda a, b: each_end(np.minimum, a, b),
    "max": lambda a, b: each_end(np.maximum, a, b),
    "+": lambda a, b: each_end(np.add, a, b),
    "-": lambda a, b: each_end(np.add, a, negated(b)),
    "*": interval.product,
}
EXACT: dict[str, OnScalars] = {
    "neg": negated,
    "min": interval.minimum,
    "max": interval.maximum,
    "floor": lambda x: each_end(np.floor, x),
    "float32": lambda i: each_end(nearest, i),
    "int32": lambda x: each_end(truncated, x),
}


FILTERS = (sample_bilinear, sample_repeated)  # the functions that a sampler does, of which the first value is a texture


class Operations:
    """What operators, primitives and functions taken whole give on a processor of this profile."""

    def __init__(self, profile: Profile) -> None:
        self.arithmetic = arithmetic = profile.arithmetic
        self.position_slack = profile.position_slack
        self.nearest_slack = profile.nearest_slack
        self.filter_slack = profile.filter_slack
        self.rounding: dict[str, OnScalars] = {
            "+": arithmetic.add,
            "-": lambda a, b: arithmetic.add(a, negated(b)),
            "*": arithmetic.multiply,
            "/": arithmetic.divide,
            "sqrt": arithmetic.sqrt,
            "pow": arithmetic.pow,
            "exp": arithmetic.exp,
            "exp2": arithmetic.exp2,
            "log2": arithmetic.log2,
        }
        self.whole: dict[Any, Callable[..., Any]] = {nearest_texel: self.nearest_texel}
        if isinstance(arithmetic, Bounded):
            self.whole |= _rewritten(arithmetic)

    def on_scalars(self, name: str, kind: Any) -> OnScalars:
        """An operator or primitive on scalars, for a result of this type."""
        tables = (INTEGER, EXACT) if kind in (int, ivec2) else (self.rounding, EXACT)
        return next(table[name] for table in tables if name in table)

    def read(self, a: Interval) -> Interval:
        """What memory holds, as far as the processor tells small numbers from 0."""
        return self.arithmetic.representable(a) if np.asarray(a.low).dtype == np.float64 else a

    def fetched(self, low: np.ndarray, high: np.ndarray, index: Sequence[Interval]) -> tuple[Any, Any]:
        """What a texture or an array holds at an index; as `value_sets.fetched` has it."""
        return fetched(low, high, index)

    def transformed(self, matrix: mat3 | mat4, v: Vector) -> Vector:
        """Matrix times vector, each row a scalar product."""
        rows = [[point(np.float64(element)) for element in row] for row in matrix.rows]
        if isinstance(self.arithmetic, Bounded):
            return type(v)(*(self.arithmetic.dot(row, [*v]) for row in rows))
        products = [[self.arithmetic.multiply(m, x) for m, x in zip(row, v, strict=True)] for row in rows]
        return type(v)(*(reduce(self.arithmetic.add, terms) for terms in products))

    def filtered(self, texture: Texels, blended: Any) -> Any:
        """What a sampler may make of a blend of texels."""
        slack = self.filter_slack(texture.span)
        if not slack:
            return blended
        return componentwise(lambda a: Interval(downward(a.low - slack), upward(a.high + slack)), blended)

    def nearest_texel(self, map_size: ivec2, uv: Vector) -> ivec2:
        """As in the language, where the product may end up on either side of a texel's edge that is near."""
        return ivec2(*(self._texel(count, at) for count, at in zip(map_size, uv, strict=True)))

    def _texel(self, count: Interval, at: Interval) -> Interval:
        """The texels among `count` on an axis that a texture coordinate may fall on."""
        position = slackened(self.arithmetic.multiply(at, each_end(nearest, count)), self.nearest_slack)
        return each_end(lambda end: np.clip(np.floor(end), 0, count.low - 1).astype(np.int64), position)


def _rewritten(arithmetic: Bounded) -> dict[Any, Callable[..., Any]]:
    """The functions that a processor may compute in another way than the language does."""
    return {
        dot: lambda a, b: arithmetic.dot([*a], [*b]),
        normalize: lambda v: type(v)(*arithmetic.normalize([*v])),
        mix: lambda a, b, t: componentwise(arithmetic.mix, a, b, t),
        bilinear_blend: lambda *corners_t: _bilinear(arithmetic, *corners_t),
    }


def _bilinear(arithmetic: Bounded, *corners_and_weights: Any) -> Any:
    """The blend of four neighbours, lower left first, then to the right, then above."""
    *corners, t = corners_and_weights
    return componentwise(lambda a, b, c, d: arithmetic.bilinear((a, b), (c, d), (t.x, t.y)), *corners)


def slackened(a: Interval, slack: float) -> Interval:
    """The values and all that lie no further from them than the slack."""
    return Interval(a.low - slack, a.high + slack) if slack else a


def truncated(x: Any) -> np.ndarray:
    """GLSL int(x), bounded by what 32 bits hold."""
    whole: np.ndarray = np.clip(np.trunc(x), INT32.min, INT32.max)
    return whole.astype(np.int64)
