"""From a stage's typed tree to straight-line scalar Python, the form that numba compiles.

Vectors become one variable per component and functions are written out where they are called. Whatever depends on
uniforms alone is moved before the loop over pixels. Each operation stays one float32 operation in the order written,
so the lines give the bits that array code gives.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, get_args, get_origin

from sss_ref.language import tree
from sss_ref.language.types import Array, Texture, Vector, mat3, mat4

INDENT = "    "
TEMPLATES = {
    "sqrt": "np.sqrt({0})",
    "floor": "np.floor({0})",
    "min": "min({0}, {1})",  # Python's own, compiled or not, is rule A1's y < x ? y : x
    "max": "max({0}, {1})",
    "pow": "pow_scalar({0}, {1})",
    "exp": "exp_scalar({0})",
    "exp2": "exp2_scalar({0})",
    "log2": "log2_scalar({0})",
    "select": "({1} if {0} else {2})",
    "float32": "np.float32({0})",
    "int32": "np.int64({0})",
}


@dataclass(frozen=True)
class Scalar:
    """One component as an expression. uniform: the same for all fragments; atomic: a name or a literal."""

    text: str
    uniform: bool
    atomic: bool


@dataclass(frozen=True)
class Memory:
    """A texture or uniform array, by the name of its ndarray."""

    name: str
    kind: Any


Value = list[Scalar] | Memory


@dataclass
class Lines:
    """The program being written: `before` the loop over pixels, and `inside` it."""

    before: list[str] = field(default_factory=list)
    inside: list[str] = field(default_factory=list)
    literals: dict[str, str] = field(default_factory=dict)
    depth: int = 0
    _taken: set[str] = field(default_factory=set)

    def fresh(self, name: str) -> str:
        """A variable name not used so far: the name itself if it is free."""
        chosen, number = name, 2
        while chosen in self._taken:
            chosen, number = f"{name}_{number}", number + 1
        self._taken.add(chosen)
        return chosen

    def add(self, line: str) -> None:
        """Write a line inside the loop, at the present depth."""
        self.inside.append(INDENT * self.depth + line)

    def bind(self, name: str, value: Scalar) -> Scalar:
        """Give an expression a name, before the loop if it is uniform."""
        variable = self.fresh(name)
        if value.uniform:
            self.before.append(f"{variable} = {value.text}")
        else:
            self.add(f"{variable} = {value.text}")
        return Scalar(variable, value.uniform, atomic=True)

    def atom(self, name: str, value: Scalar) -> Scalar:
        """The expression itself if it is a name or a literal, else a name for it."""
        return value if value.atomic else self.bind(name, value)

    def literal(self, value: float | int | bool) -> Scalar:
        """A literal; floats become float32 constants of the module, since a bare one computes in float64."""
        if not isinstance(value, float):
            return Scalar(repr(value), True, True)
        name = "F_" + repr(value).replace("-", "m").replace(".", "_").replace("+", "")
        self.literals[name] = f"np.float32({value!r})"
        return Scalar(name, True, True)

    def join(self, template: str, *parts: Scalar) -> Scalar:
        """An expression made of others; uniform parts of a varying whole are computed before the loop."""
        uniform = all(part.uniform for part in parts)
        if not uniform:
            parts = tuple(self.atom("uniform", part) if part.uniform else part for part in parts)
        return Scalar(template.format(*(part.text for part in parts)), uniform, False)


def suffixes(kind: Any) -> list[str]:
    """How the components of a type are named: _x, _y ..., or nothing for a scalar."""
    vector = isinstance(kind, type) and issubclass(kind, Vector)
    return [f"_{letter}" for letter in "xyzw"[: kind.count]] if vector else [""]


def channels(kind: Any) -> list[str]:
    """What follows the index of a value in an ndarray, for each component; nothing for a scalar."""
    count = len(suffixes(kind))
    return [""] if count == 1 else [f", {channel}" for channel in range(count)]


class Lowering:
    """Lowers bodies into `lines`; a fresh one for each body, which sees its own names only."""

    def __init__(self, lines: Lines, names: Mapping[str, Value], prefix: str = "") -> None:
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
        """A loop: what it accumulates becomes variables that are assigned again."""
        lines = self.lines
        start, stop = self.scalar(statement.start), self.scalar(statement.stop)
        sums = [assign.name for assign in statement.block if assign.name in self.names]
        for name in sums:
            self.names[name] = [self.variable(name, value) for value in self.scalars_of(name)]
        index = lines.fresh(statement.index)
        lines.add(f"for {index} in range({start.text}, {stop.text}):")
        lines.depth += 1
        self.names[statement.index] = [Scalar(index, uniform=False, atomic=True)]
        for assign in statement.block:
            if assign.name in sums:
                targets = ", ".join(value.text for value in self.scalars_of(assign.name))
                lines.add(f"{targets} = {', '.join(value.text for value in self.scalars(assign.value))}")
            else:
                self.names[assign.name] = self.named(assign.name, assign.value)
        lines.depth -= 1

    def variable(self, name: str, value: Scalar) -> Scalar:
        """A variable inside the pixel loop that starts with this value."""
        return self.lines.bind(f"{self.prefix}{name}", Scalar(value.text, uniform=False, atomic=False))

    def scalars_of(self, name: str) -> list[Scalar]:
        """The components that a name stands for."""
        value = self.names[name]
        assert isinstance(value, list)
        return value

    def scalar(self, expression: tree.Expression) -> Scalar:
        """The one component of a scalar expression."""
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
            case tree.Literal(value=value):
                return [self.lines.literal(value)]
            case tree.Constant(value=value):
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
        """An operation, component by component."""
        first = expression.operands[0]
        if expression.operator == "neg":
            return [self.lines.join("(-{0})", value) for value in self.scalars(first)]
        if first.type in (mat3, mat4):
            return self.product(expression)
        template = f"({{0}} {expression.operator} {{1}})"
        left, right = (self.scalars(operand) for operand in expression.operands)
        count = max(len(left), len(right))
        left, right = (side * count if len(side) == 1 else side for side in (left, right))
        # A scalar beside a vector is used once per component: name it.
        if count > 1:
            left, right = self.spread(left), self.spread(right)
        return [self.lines.join(template, a, b) for a, b in zip(left, right, strict=True)]

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
            terms = [self.lines.join("{0} * {1}", matrix[row * size + k], vector[k]) for k in range(size)]
            total = terms[0]
            for term in terms[1:]:
                total = self.lines.join("({0} + {1})", total, term)
            sums.append(total)
        return sums

    def element(self, expression: tree.Element) -> list[Scalar]:
        """One element of a uniform array."""
        memory, index = self.names[expression.array.name], self.scalar(expression.index)
        assert isinstance(memory, Memory)
        return self.load(memory, "{0}", index)

    def load(self, memory: Memory, index: str, *parts: Scalar) -> list[Scalar]:
        """The components stored at an index of an ndarray."""
        (kind,) = get_args(memory.kind)
        if kind is bool:
            return [self.lines.join(f"({memory.name}[{index}] != 0)", *parts)]
        return [self.lines.join(f"{memory.name}[{index}{channel}]", *parts) for channel in channels(kind)]

    def call(self, expression: tree.Call) -> list[Scalar]:
        """A primitive by its template; a function of the language written out in place."""
        name = expression.callee.name
        values = [self.value(argument) for argument in expression.arguments]
        if name in ("texel", "size"):
            return self.texture(name, values)
        if expression.body is None:
            return self.primitive(name, [value for value in values if isinstance(value, list)])
        prefix = self.lines.fresh(name) + "_"
        inner = {
            parameter: value if isinstance(value, Memory) else self.arguments(prefix + parameter, value, kind)
            for (parameter, kind), value in zip(expression.body.parameters.items(), values, strict=True)
        }
        return Lowering(self.lines, inner, prefix).run(expression.body)["return"]

    def arguments(self, name: str, values: list[Scalar], kind: Any) -> list[Scalar]:
        """The components of an argument, each a name or a literal."""
        pairs = zip(values, suffixes(kind), strict=True)
        return [self.lines.atom(name + suffix, value) for value, suffix in pairs]

    def primitive(self, name: str, arguments: list[list[Scalar]]) -> list[Scalar]:
        """A primitive, component by component; a scalar beside a vector serves every component."""
        count = max(len(argument) for argument in arguments)
        columns = [self.spread(argument * count) if len(argument) < count else argument for argument in arguments]
        return [self.lines.join(TEMPLATES[name], *row) for row in zip(*columns, strict=True)]

    def texture(self, name: str, values: list[Value]) -> list[Scalar]:
        """The size of a texture, or one of its texels."""
        memory = values[0]
        assert isinstance(memory, Memory) and get_origin(memory.kind) in (Texture, Array)
        if name == "size":
            return [Scalar(f"{memory.name}.shape[{axis}]", True, True) for axis in (1, 0)]
        at = values[1]
        assert isinstance(at, list)
        column, row = self.lines.atom(self.prefix + "column", at[0]), self.lines.atom(self.prefix + "row", at[1])
        return self.load(memory, "{0}, {1}", row, column)
