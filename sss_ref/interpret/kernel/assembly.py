"""The module of a stage in LLVM's language, translated line by line from its Python.

numba would do it too, in ten times the time: it reads bytecode, and has to find out the type of each name. What
source.py writes has no branches, and no values but float32, whole numbers and truth values, so types are read off.
As in numba, arithmetic of whole numbers is one of 64 bits. Of LLVM's language see its Reference Manual.
"""

import ast
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

BIT, BYTE, WORD, WHOLE, FLOAT, POINTER = "i1", "i8", "i32", "i64", "float", "ptr"
ARGUMENTS = {"scratch": POINTER, "count": WHOLE, "rows": POINTER, "uniforms": POINTER, "tables": POINTER}
SCALARS = {"pow_scalar": 2, "exp_scalar": 1, "exp2_scalar": 1, "log2_scalar": 1}  # float32 each, the module's user has
CALLED = {"np.sqrt": "llvm.sqrt.f32", "np.floor": "llvm.floor.f32", **{name: name for name in SCALARS}}
KINDS = {"np.float32": FLOAT, "np.int32": WORD, "np.int64": WHOLE}
ACCESSED = {"float": FLOAT, "int": WORD, "byte": BYTE}  # the ends of the names of what `row_memory` has
CONVERSIONS = {
    (BIT, WORD): "zext",
    (BIT, WHOLE): "zext",
    (BIT, FLOAT): "uitofp",
    (BYTE, WORD): "zext",
    (WORD, WHOLE): "sext",
    (WORD, FLOAT): "sitofp",
    (WHOLE, WORD): "trunc",
    (WHOLE, FLOAT): "sitofp",
    (FLOAT, WORD): "fptosi",
    (FLOAT, WHOLE): "fptosi",
}
Instructions = dict[type[ast.operator], str]
OF_FLOATS: Instructions = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
OF_BITS: Instructions = {ast.BitAnd: "and", ast.BitOr: "or", ast.BitXor: "xor"}
OF_WHOLE: Instructions = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.RShift: "ashr", **OF_BITS}
ORDER = {ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge", ast.Eq: "eq", ast.NotEq: "ne"}


class Value(NamedTuple):
    """A value: its type, and the name or number that stands for it."""

    kind: str
    text: str

    def __str__(self) -> str:
        return f"{self.kind} {self.text}"


def assembled(source: str, prefix: str) -> str:
    """The module of a Python source; its function `name` is here prefix.name, which no other module has."""
    constants: dict[str, Value] = {}
    functions: list[AssembledFunction] = []
    for statement in ast.parse(source).body:
        match statement:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=kind, args=[number])):
                constants[name] = constant(KINDS[ast.unparse(kind)], ast.literal_eval(number))
            case ast.FunctionDef(name=name, body=body):
                functions.append(AssembledFunction(f"{prefix}.{name}", constants, body))
    declared = [f"declare float @{name}(float)" for name in ("llvm.sqrt.f32", "llvm.floor.f32")]
    declared += [f"declare float @{name}({', '.join(['float'] * count)})" for name, count in SCALARS.items()]
    return "\n".join([*declared, *(each.text for each in functions), *scopes(max(each.rows for each in functions))])


def constant(kind: str, number: float) -> Value:
    """A number; LLVM writes one of float32 as the bits of the same number in float64."""
    bits = np.float64(np.float32(number)).view(np.uint64)
    return Value(kind, f"0x{bits:016x}" if kind == FLOAT else str(number))


def scopes(rows: int) -> list[str]:
    """What tells apart the rows that a function writes (row_memory.py): `own`, `others` and `all_rows` of them."""
    names = [f'!{3 * row + 2} = !{{!"row {row}", !0}}' for row in range(rows)]
    own = [f"{own_row(row)} = !{{!{3 * row + 2}}}" for row in range(rows)]
    others = [f"{other_rows(row)} = !{{{listed(each for each in range(rows) if each != row)}}}" for row in range(rows)]
    return ['!0 = !{!"sss_ref rows"}', f"{ALL_ROWS} = !{{{listed(range(rows))}}}", *names, *own, *others]


ALL_ROWS = "!1"


def own_row(row: int) -> str:
    """The list of one row."""
    return f"!{3 * row + 3}"


def other_rows(row: int) -> str:
    """The list of all rows but one."""
    return f"!{3 * row + 4}"


def listed(rows: Iterable[int]) -> str:
    """Rows by their names."""
    return ", ".join(f"!{3 * row + 2}" for row in rows)


class AssembledFunction:
    """A function of rows being translated; rows: how many it writes, as far as they are told apart.

    Each variable is a place in memory for each type that it has, from which LLVM makes values that nobody stores.
    """

    def __init__(self, name: str, constants: dict[str, Value], body: list[ast.stmt]) -> None:
        self.name, self.rows = name, 0
        self.values = constants | {name: Value(kind, f"%{name}") for name, kind in ARGUMENTS.items()}
        self.places: dict[str, Value] = {}  # name -> the place that its value is in now
        self.allocated: dict[Value, str] = {}  # type and name of a variable -> its place
        self.lines: list[str] = []
        self.counted = 0
        self.block(body)

    @property
    def text(self) -> str:
        """The whole function."""
        arguments = ", ".join(f"{kind} %{name}" for name, kind in ARGUMENTS.items())
        places = [f"{place} = alloca {variable.kind}" for variable, place in self.allocated.items()]
        head = f'define void @"{self.name}"({arguments}) nounwind {{'
        return "\n".join([head, "entry:", *places, *self.lines, "ret void", "}"])

    def fresh(self) -> str:
        """A name for a value or a label."""
        self.counted += 1
        return f"v{self.counted}"

    def named(self, kind: str, instruction: str) -> Value:
        """What an instruction gives, under a name."""
        value = Value(kind, f"%{self.fresh()}")
        self.lines.append(f"{value.text} = {instruction}")
        return value

    def label(self, name: str) -> None:
        """The next block begins."""
        self.lines += [f"br label %{name}", f"{name}:"]

    def block(self, statements: list[ast.stmt]) -> None:
        """Statements, one after the other."""
        for statement in statements:
            match statement:
                case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=parts)):
                    for name, value in zip(names, [self.value(part) for part in parts], strict=True):
                        self.assign(name, value)
                case ast.Assign(targets=names, value=expression):
                    value = self.value(expression)
                    for name in names:
                        self.assign(name, value)
                case ast.For(target=target, iter=ast.Call(args=bounds), body=body):
                    self.loop(target, [self.as_kind(WHOLE, self.value(bound)) for bound in bounds], body)
                case ast.Expr(value=ast.Call(func=ast.Name(id=name), args=[row, memory, index, value])):
                    place = self.element(ACCESSED[name.removeprefix("write_")], self.value(memory), self.value(index))
                    self.lines.append(f"store {self.value(value)}, {place}, align 4, {self.only(row)}")
                case _:
                    raise AssertionError(ast.unparse(statement))

    def assign(self, target: ast.expr, value: Value) -> None:
        """Put a value into a variable."""
        assert isinstance(target, ast.Name)
        variable = Value(value.kind, target.id)
        place = self.allocated.setdefault(variable, f"%p{len(self.allocated)}")
        self.places[target.id] = Value(value.kind, place)
        self.lines.append(f"store {value}, ptr {place}")

    def loop(self, index: ast.expr, bounds: list[Value], body: list[ast.stmt]) -> None:
        """A loop over whole numbers."""
        start, stop = bounds if len(bounds) == 2 else (Value(WHOLE, "0"), *bounds)
        before, head, turn, end, after = (self.fresh() for _ in range(5))
        self.label(before)
        self.label(head)
        number = self.named(WHOLE, f"phi i64 [{start.text}, %{before}], [%{end}.next, %{end}]")
        more = self.named(BIT, f"icmp slt {number}, {stop.text}")
        self.lines += [f"br {more}, label %{turn}, label %{after}", f"{turn}:"]
        self.assign(index, number)
        self.block(body)
        self.label(end)
        self.lines += [f"%{end}.next = add nsw {number}, 1", f"br label %{head}", f"{after}:"]

    def value(self, expression: ast.expr) -> Value:
        """What an expression gives."""
        match expression:
            case ast.Constant(value=bool() as truth):
                return Value(BIT, str(truth).lower())
            case ast.Constant(value=number):
                return Value(WHOLE, str(number))
            case ast.Name(id=name) if name in self.places:
                kind, place = self.places[name]
                return self.named(kind, f"load {kind}, ptr {place}")
            case ast.Name(id=name):
                return self.values[name]
            case ast.Subscript(value=memory, slice=index):
                return self.named(WHOLE, f"load i64, {self.element(WHOLE, self.value(memory), self.value(index))}")
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.negated(self.value(operand))
            case ast.BinOp(left=left, op=op, right=right):
                return self.operation(type(op), self.value(left), self.value(right))
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return self.comparison(ORDER[type(op)], self.value(left), self.value(right))
            case ast.Call(func=function, args=arguments):
                return self.call(ast.unparse(function), arguments)
        raise AssertionError(ast.unparse(expression))

    def negated(self, value: Value) -> Value:
        """The number of the other sign."""
        if value.kind == FLOAT:
            return self.named(FLOAT, f"fneg {value}")
        return self.named(WHOLE, f"sub i64 0, {self.as_kind(WHOLE, value).text}")

    def operation(self, operator: type[ast.operator], left: Value, right: Value) -> Value:
        """An operation; of truth values one of bits, of whole numbers one of 64."""
        kind = left.kind if left.kind in (FLOAT, BIT) else WHOLE
        instructions = OF_FLOATS if kind == FLOAT else OF_WHOLE
        left, right = self.as_kind(kind, left), self.as_kind(kind, right)
        return self.named(kind, f"{instructions[operator]} {left}, {right.text}")

    def comparison(self, order: str, left: Value, right: Value) -> Value:
        """A comparison; nothing is equal to NaN, nor less or greater."""
        if left.kind == FLOAT:
            return self.named(BIT, f"fcmp {'une' if order == 'ne' else 'o' + order} {left}, {right.text}")
        signed = order if order in ("eq", "ne") else f"s{order}"
        return self.named(BIT, f"icmp {signed} {self.as_kind(WHOLE, left)}, {self.as_kind(WHOLE, right).text}")

    def call(self, function: str, arguments: list[ast.expr]) -> Value:
        """A call: of a type, of what `row_memory` has, of an elementary function."""
        if function.startswith("reread_"):
            row, *arguments = arguments
            return self.loaded(function, [self.value(each) for each in arguments], f"align 4, {self.only(row)}")
        values = [self.value(each) for each in arguments]
        if function in KINDS:
            return self.as_kind(KINDS[function], *values)
        if function == "chosen":
            condition, if_true, if_false = values
            if_false = self.as_kind(if_true.kind, if_false)
            return self.named(if_true.kind, f"select {condition}, {if_true}, {if_false}")
        if function in CALLED:
            return self.named(FLOAT, f"call float @{CALLED[function]}({', '.join(map(str, values))})")
        return self.loaded(function, values, f"align {1 if function.endswith('byte') else 4}, !noalias {ALL_ROWS}")

    def loaded(self, function: str, values: list[Value], how: str) -> Value:
        """What lies in memory; a byte as a number of 32 bits."""
        memory, index = values
        kind = ACCESSED[function.rpartition("_")[2]]
        if memory.kind == WHOLE:
            memory = self.named(POINTER, f"inttoptr {memory} to ptr")
        value = self.named(kind, f"load {kind}, {self.element(kind, memory, index)}, {how}")
        return self.as_kind(WORD, value) if kind == BYTE else value

    def element(self, kind: str, memory: Value, index: Value) -> Value:
        """Where an element lies."""
        return self.named(POINTER, f"getelementptr {kind}, {memory}, {index}")

    def only(self, row: ast.expr) -> str:
        """What says that an access touches this row of those that are written, and no other."""
        number = ast.literal_eval(row)
        self.rows = max(self.rows, number + 1)
        return f"!alias.scope {own_row(number)}, !noalias {other_rows(number)}"

    def as_kind(self, kind: str, value: Value) -> Value:
        """A value as one of this type."""
        if value.kind == kind:
            return value
        return self.named(kind, f"{CONVERSIONS[value.kind, kind]} {value} to {kind}")
