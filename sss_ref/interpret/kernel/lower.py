"""From a stage's typed tree to lines of scalar Python, which assembly.py translates for LLVM.

Vectors become one variable per component and functions are written out where they are called. Each operation stays
one float32 operation in the order written, so the lines give the bits that array code gives. What depends on uniforms
alone is marked, for it need not be computed anew for every fragment.
"""

from collections.abc import Mapping
from typing import Any, get_args, get_origin

from sss_ref.interpret.kernel.lines import Memory, Scalar, StageLines, Value
from sss_ref.language import tree
from sss_ref.language.types import Array, Texture, Vector, ivec2, mat3, mat4
from sss_ref.numerics.scalar import SCALARS

TEMPLATES = {
    "sqrt": "np.sqrt({0})",
    "floor": "np.floor({0})",
    "min": "chosen({1} < {0}, {1}, {0})",  # rule A1
    "max": "chosen({0} < {1}, {1}, {0})",
    "select": "chosen({0}, {1}, {2})",
    "float32": "np.float32({0})",
    "int32": "np.int32({0})",
}
USED_TWICE = ("min", "max")  # arguments of these stand twice in the template
FETCH = {float: "texel_float({0}, {1})", int: "texel_int({0}, {1})", bool: "(texel_byte({0}, {1}) != 0)"}
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=", "&", "|")


def suffixes(kind: Any) -> list[str]:
    """How the components of a type are named: _x, _y ..., _00, _01 ... of a matrix, or nothing for a scalar."""
    if kind in (mat3, mat4):
        size = range(3 if kind is mat3 else 4)
        return [f"_{row}{column}" for row in size for column in size]
    vector = isinstance(kind, type) and issubclass(kind, Vector)
    return [f"_{letter}" for letter in "xyzw"[: kind.count]] if vector else [""]


def scalar_kind(kind: Any) -> type:
    """What a component of a type is: float, int or bool."""
    if kind is bool:
        return bool
    return int if kind in (int, ivec2) else float


class Lowering:
    """Lowers bodies into `lines`; a fresh one for each body, which sees its own names only."""

    def __init__(self, lines: StageLines, names: Mapping[str, Value], prefix: str = "") -> None:
        self.lines = lines
        self.names: dict[str, Value] = dict(names)
        self.prefix = prefix

    def run(self, body: tree.Body) -> dict[str, list[Scalar]]:
        """Write the statements of a body; the scalars of each value it returns."""
        for statement in body.statements:
            if isinstance(statement, tree.Loop):
                self.loop(statement)
            else:
                self.names[statement.name] = self.named(statement.name, statement.value)
        return {name: self.scalars(value) for name, value in body.result.values.items()}

    def named(self, name: str, expression: tree.Expression) -> list[Scalar]:
        """The components of an expression, each under a name."""
        pairs = zip(self.scalars(expression), suffixes(expression.type), strict=True)
        return [self.lines.atom(self.prefix + name + suffix, value) for value, suffix in pairs]

    def loop(self, statement: tree.Loop) -> None:
        """A loop, in the form that its surroundings give it: what it accumulates has new names afterwards."""
        start, stop = (self.lines.atom("bound", self.scalar(end)) for end in (statement.start, statement.stop))
        sums = [assign.name for assign in statement.block if assign.name in self.names]
        before = [value for name in sums for value in self.scalars_of(name)]
        loop = self.lines.loop(self.prefix + statement.index, start, stop)
        inner = Lowering(loop.lines, self.names, self.prefix)
        inner.names[statement.index] = [loop.index]
        inside = iter(loop.accumulators(before))
        for name in sums:
            inner.names[name] = [next(inside) for _ in self.scalars_of(name)]
        for assign in statement.block:
            inner.names[assign.name] = inner.named(assign.name, assign.value)
        after = iter(loop.close([value for name in sums for value in inner.scalars_of(name)]))
        for name in sums:
            self.names[name] = [next(after) for _ in self.scalars_of(name)]

    def scalars_of(self, name: str) -> list[Scalar]:
        """The components that a name stands for."""
        value = self.names[name]
        assert isinstance(value, list)
        return value

    def scalar(self, expression: tree.Expression) -> Scalar:
        """The one component of an expression."""
        (value,) = self.scalars(expression)
        return value

    def value(self, expression: tree.Expression) -> Value:
        """What an argument stands for: a texture or array as it is, else its components."""
        if isinstance(expression, tree.Variable):
            return self.names[expression.name]
        return self.scalars(expression)

    def scalars(self, expression: tree.Expression) -> list[Scalar]:
        """The components of an expression."""
        match expression:
            case tree.Literal(value=value) | tree.Constant(value=value):
                return [self.lines.literal(value)]
            case tree.Variable(name=name):
                return self.scalars_of(name)
            case tree.Member(vector=vector, letters=letters):
                inside = self.scalars(vector)
                return [inside["xyzw".index(letter)] for letter in letters]
            case tree.Construct(parts=parts):
                return [scalar for part in parts for scalar in self.scalars(part)]
            case tree.Operation():
                return self.operation(expression)
            case tree.Element():
                return self.element(expression)
            case tree.Call():
                return self.call(expression)

    def operation(self, expression: tree.Operation) -> list[Scalar]:
        """An operation, component by component; on whole numbers it stays one of 32 bits."""
        first = expression.operands[0]
        kind = bool if expression.operator in COMPARISONS else scalar_kind(expression.type)
        if expression.operator == "neg":
            return [self.lines.join(wrapped("(-{0})", kind), kind, value) for value in self.scalars(first)]
        if first.type in (mat3, mat4):
            return self.product(expression)
        template = wrapped(f"({{0}} {expression.operator} {{1}})", kind)
        left, right = (self.scalars(operand) for operand in expression.operands)
        count = max(len(left), len(right))
        left, right = (side * count if len(side) == 1 else side for side in (left, right))
        # A scalar beside a vector is used once per component: name it.
        if count > 1:
            left, right = self.spread(left), self.spread(right)
        return [self.lines.join(template, kind, a, b) for a, b in zip(left, right, strict=True)]

    def spread(self, values: list[Scalar]) -> list[Scalar]:
        """Name a scalar that stands for every component; leave a vector's components as they are."""
        same = all(value is values[0] for value in values)
        return [self.lines.atom(self.prefix + "shared", values[0])] * len(values) if same else values

    def product(self, expression: tree.Operation) -> list[Scalar]:
        """Matrix * vector, row by row (rule A3)."""
        matrix, vector = (self.scalars(operand) for operand in expression.operands)
        vector = [self.lines.atom(self.prefix + "operand", value) for value in vector]
        size = len(vector)
        sums = []
        for row in range(size):
            terms = [self.lines.join("{0} * {1}", float, matrix[row * size + k], vector[k]) for k in range(size)]
            total = terms[0]
            for term in terms[1:]:
                total = self.lines.join("({0} + {1})", float, total, term)
            sums.append(total)
        return sums

    def element(self, expression: tree.Element) -> list[Scalar]:
        """One element of a uniform array."""
        memory = self.names[expression.array.name]
        assert isinstance(memory, Memory)
        return self.load(memory, self.lines.atom(self.prefix + "element", self.scalar(expression.index)))

    def load(self, memory: Memory, index: Scalar) -> list[Scalar]:
        """The components of the value with this number in a texture or array."""
        (kind,) = get_args(memory.kind)
        count = len(suffixes(kind))
        fetch = FETCH[scalar_kind(kind)]
        if count == 1:
            return [self.lines.join(fetch, scalar_kind(kind), memory.address, index)]
        width, name = self.lines.literal(count), self.prefix + "place"
        places = [self.lines.place(name, "{0} * {1}", index, width)]
        places += [self.lines.place(name, "{0} + {1}", places[0], self.lines.literal(k)) for k in range(1, count)]
        return [self.lines.join(fetch, scalar_kind(kind), memory.address, place) for place in places]

    def call(self, expression: tree.Call) -> list[Scalar]:
        """A primitive by its template; a function of the language written out in place."""
        name = expression.callee.name
        values = [self.value(argument) for argument in expression.arguments]
        if name in ("texel", "size"):
            return self.texture(name, values)
        if expression.body is None:
            columns = [value for value in values if isinstance(value, list)]
            return self.primitive(name, columns, scalar_kind(expression.type))
        prefix = self.lines.shared.fresh(name) + "_"
        inner = {
            parameter: value if isinstance(value, Memory) else self.arguments(prefix + parameter, value, kind)
            for (parameter, kind), value in zip(expression.body.parameters.items(), values, strict=True)
        }
        return Lowering(self.lines, inner, prefix).run(expression.body)["return"]

    def arguments(self, name: str, values: list[Scalar], kind: Any) -> list[Scalar]:
        """The components of an argument, each a name or a literal."""
        pairs = zip(values, suffixes(kind), strict=True)
        return [self.lines.atom(name + suffix, value) for value, suffix in pairs]

    def primitive(self, name: str, arguments: list[list[Scalar]], kind: type) -> list[Scalar]:
        """A primitive, component by component; a scalar beside a vector serves every component."""
        count = max(len(argument) for argument in arguments)
        columns = [self.spread(argument * count) if len(argument) < count else argument for argument in arguments]
        rows = list(zip(*columns, strict=True))
        if name in SCALARS:
            return [self.lines.elementary(name, row) for row in rows]
        if name in USED_TWICE:
            rows = [tuple(self.lines.atom(self.prefix + name, value) for value in row) for row in rows]
        return [self.lines.join(TEMPLATES[name], kind, *row) for row in rows]

    def texture(self, name: str, values: list[Value]) -> list[Scalar]:
        """The size of a texture, or one of its texels."""
        memory = values[0]
        assert isinstance(memory, Memory) and get_origin(memory.kind) in (Texture, Array)
        if name == "size":
            return list(memory.size)
        at = values[1]
        assert isinstance(at, list)
        column, row = at
        index = self.lines.join("np.int32(np.int32({0} * {1}) + {2})", int, row, memory.size[0], column)
        return self.load(memory, self.lines.texel(self.prefix + "texel", index))


def wrapped(template: str, kind: type) -> str:
    """The template of an operation, brought back to 32 bits where it is one of whole numbers."""
    return f"np.int32({template})" if kind is int else template
