"""A processor that is correct by Vulkan's rules and otherwise does as it likes: each choice is drawn at random.

It walks a stage's tree on its own, one element per fragment, in float64 that holds float32; with `exact`, it computes
in float64 alone and chooses nothing.
"""

import operator
from functools import reduce

import numpy as np

from sss_ref.language import tree
from sss_ref.language.types import Vector, ivec2, mat3, mat4

SIGNS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "neg": operator.neg}
COMPARISONS = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
    "&": operator.and_,
    "|": operator.or_,
}
SLACK = 2.0**-8  # of a texel, in a position between texels


def each(function, *values):
    """By component."""
    vector = next((v for v in values if isinstance(v, Vector)), None)
    if vector is None:
        return function(*values)
    columns = [list(v) if isinstance(v, Vector) else [v] * vector.count for v in values]
    return type(vector)(*(function(*row) for row in zip(*columns, strict=True)))


def ulp(x):
    return np.spacing(np.abs(x).astype(np.float32)).astype(np.float64)


class Processor:
    def __init__(self, rng, exact=False):
        self.rng = rng
        self.exact = exact

    def run(self, stage, inputs):
        names = {name: each(self.widened, value) for name, value in inputs.items()}
        with np.errstate(all="ignore"):
            return {stage.writes[own]: value for own, value in self.body(stage.body, names).items()}

    @staticmethod
    def widened(value):
        floats = isinstance(value, np.ndarray | np.generic) and value.dtype == np.float32
        return value.astype(np.float64) if floats else value

    # What it may choose

    def chance(self, like):
        return self.rng.random(np.shape(like)) < 0.5

    def either(self, x, y):
        return np.where(self.chance(x), x, y)

    def rounded(self, x, ulps=0):
        """A float32 next to x; with `ulps`, any that is off by no more."""
        if self.exact:
            return x
        off = np.where((x == 0) | ~np.isfinite(x), 0, ulp(x))
        x = np.asarray(x + self.rng.uniform(-1, 1, np.shape(x)) * np.maximum(ulps - 1, 0) * off)
        near = x.astype(np.float32)
        way = np.where(near > x, -np.inf, np.inf).astype(np.float32)
        other = np.where(near == x, near, np.nextafter(near, way))
        return self.flushed(self.either(near, other).astype(np.float64))

    def flushed(self, x):
        return self.either(x, np.where(np.abs(x) < 2.0**-126, 0.0, x))

    def plus(self, *terms):
        """A sum in any order."""
        order = terms if self.exact else self.rng.permutation(len(terms))
        ordered = terms if self.exact else [terms[k] for k in order]
        return reduce(lambda a, b: self.rounded(a + b), ordered)

    def times(self, a, b):
        """A product, rounded or left for a fused addition."""
        return self.either(self.rounded(a * b), a * b)

    def dot(self, a, b):
        return self.plus(*(self.times(x, y) for x, y in zip(a, b, strict=True)))

    def sqrt(self, x):
        return self.rounded(np.sqrt(x), 4)

    def divided(self, a, b):
        return self.rounded(a / b, 2.5)

    def mix(self, a, b, t):
        first = self.plus(self.times(a, self.rounded(1 - t)), self.times(b, t))
        return self.either(first, self.plus(a, self.times(self.rounded(b - a), t)))

    def normalize(self, v):
        squares = self.dot(v, v)
        size, inverse, divides = self.sqrt(squares), self.rounded(1 / np.sqrt(squares), 2), self.chance(squares)

        def direction(x):
            return np.where(size > 0, np.where(divides, self.divided(x, size), self.rounded(x * inverse)), 0.0)

        return each(direction, v)

    def exponential(self, function, x):
        return np.maximum(self.rounded(function(x), 3 + 2 * np.minimum(np.abs(x), 150)), 0)  # in ULP it might be below

    def log2(self, x):
        near_one = self.rng.uniform(-1, 1, np.shape(x)) * 2.0**-22 if not self.exact else 0.0
        return np.where((x >= 0.5) & (x <= 2), self.rounded(np.log2(x) + near_one), self.rounded(np.log2(x), 3))

    def pow(self, x, y):
        if self.exact:
            return np.power(x, y)
        x, y = np.broadcast_arrays(x, y)
        return self.either(self.rounded(np.power(x, y)), self.exponential(np.exp2, self.rounded(y * self.log2(x))))

    def nearest_texel(self, count, uv):
        slack = 0.0 if self.exact else self.rng.uniform(-SLACK, SLACK, np.shape(uv.x)) * 0.99
        at = [np.floor(self.rounded(x * n) + slack) for x, n in zip(uv, count, strict=True)]
        return ivec2(*(np.clip(x, 0, n - 1).astype(int) for x, n in zip(at, count, strict=True)))

    # What it must do

    def body(self, body, names):
        names = dict(names)
        self_slack = 0.0 if self.exact else self.rng.uniform(-SLACK, SLACK) * 0.99
        for statement in body.statements:
            if isinstance(statement, tree.Loop):
                for index in range(int(self.value(statement.start, names)), int(self.value(statement.stop, names))):
                    names[statement.index] = index
                    for assign in statement.block:
                        names[assign.name] = self.value(assign.value, names, self_slack)
            else:
                names[statement.name] = self.value(statement.value, names, self_slack)
        return {name: self.value(value, names, self_slack) for name, value in body.result.values.items()}

    def value(self, expression, names, slack=0.0):
        match expression:
            case tree.Literal(value=value) | tree.Constant(value=value):
                return value
            case tree.Variable(name=name):
                return names[name]
            case tree.Member(vector=vector, letters=letters):
                return getattr(self.value(vector, names, slack), letters)
        values = [self.value(child, names, slack) for child in tree.children(expression)]
        match expression:
            case tree.Construct(type=kind):
                return kind(*values)
            case tree.Element():
                return each(self.widened, values[0][values[1]])
            case tree.Operation(operator=sign) if sign in COMPARISONS:
                return COMPARISONS[sign](*values)
            case tree.Operation(operator=sign, type=kind):
                return self.operation(sign, kind, values)
        return self.call(expression, values, slack)

    def operation(self, sign, kind, values):
        if kind in (int, ivec2) or sign == "neg":
            return each(SIGNS[sign], *values)
        if isinstance(values[0], mat3 | mat4):
            return type(values[1])(*(self.dot([float(m) for m in row], [*values[1]]) for row in values[0].rows))
        if sign == "/":
            return each(self.divided, *values)
        return each(lambda *pair: self.rounded(SIGNS[sign](*pair)), *values)

    def call(self, expression, values, slack):
        name = expression.callee.name
        own = {
            "dot": self.dot,
            "normalize": self.normalize,
            "nearest_texel": self.nearest_texel,
            "whole_part": lambda p: ivec2(*(np.floor(x + slack).astype(int) for x in p)),
            "fractional_part": lambda p: type(p)(*((x + slack) - np.floor(x + slack) for x in p)),
            "texel": lambda texture, at: each(self.widened, texture.fetch(at)),
            "size": lambda texture: ivec2(texture.data.shape[1], texture.data.shape[0]),
        }
        if name in own:
            return own[name](*values)
        scalar = {
            "mix": self.mix,
            "sqrt": self.sqrt,
            "pow": self.pow,
            "exp": lambda x: self.exponential(np.exp, x),
            "floor": np.floor,
            "min": lambda x, y: np.where(y < x, y, x),
            "max": lambda x, y: np.where(x < y, y, x),
            "select": np.where,
            "float32": float,
            "int32": lambda x: np.trunc(x).astype(int),
        }
        if name in scalar:
            return each(scalar[name], *values)
        parameters = dict(zip(expression.body.parameters, values, strict=True))
        return self.body(expression.body, parameters)["return"]
