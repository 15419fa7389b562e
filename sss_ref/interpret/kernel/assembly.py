"""A module of functions of rows in LLVM's language, translated line by line from its Python.

numba would do it too, in ten times the time: it reads bytecode, and has to find out the type of each name. What
source.py writes, and fragment_rows.py holds, is a small part of Python whose types are read off: numbers, truth values,
pairs and triples of them, loops over whole numbers. Functions that these call are written out where they are called.
"""

import ast
import inspect

from sss_ref.interpret.kernel.instructions import (
    ALL_ROWS,
    BIT,
    BYTE,
    DOUBLE,
    FLOAT,
    KINDS,
    ORDER,
    POINTER,
    WHOLE,
    WORD,
    Instructions,
    Value,
    constant,
    scopes,
)
from sss_ref.numerics.scalar import SCALARS

ARGUMENTS = {"scratch": POINTER, "count": WHOLE, "rows": POINTER, "uniforms": POINTER, "tables": POINTER}
ROUNDED = {"np.sqrt": "llvm.sqrt.f32", "np.floor": "llvm.floor.f32"}
ELEMENTARY = {each.__name__: len(inspect.signature(each).parameters) for each in SCALARS.values()}  # the user has them
CALLED = ROUNDED | {name: name for name in ELEMENTARY}
ACCESSED = {"float": FLOAT, "int": WORD, "word": WORD, "byte": BYTE}  # the ends of the names in `plain_memory`


def assembled(source: str, prefix: str) -> str:
    """The module of a Python source; its function `name` is here prefix.name, which no other module has."""
    outside = Outside(ast.parse(source))
    functions = [AssembledFunction(f"{prefix}.{each.name}", outside, each.body) for each in outside.of_rows]
    numbers = dict.fromkeys(ROUNDED.values(), 1) | ELEMENTARY
    declared = [f"declare float @{name}({', '.join(['float'] * count)})" for name, count in numbers.items()]
    return "\n".join([*declared, *(each.text for each in functions), *scopes(max(each.rows for each in functions))])


class Outside:
    """What functions find in their module: numbers, and the functions that are not `of_rows`."""

    def __init__(self, module: ast.Module) -> None:
        self.constants: dict[str, Value] = {}
        self.called: dict[str, ast.FunctionDef] = {}
        self.of_rows: list[ast.FunctionDef] = []
        for statement in module.body:
            match statement:
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.Constant(value=int() as number)):
                    self.constants[name] = constant(WHOLE, number)
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=kind, args=[number])):
                    self.constants[name] = constant(KINDS[ast.unparse(kind)], ast.literal_eval(number))
                case ast.FunctionDef(name=name, args=arguments):
                    if [each.arg for each in arguments.args] == [*ARGUMENTS]:
                        self.of_rows.append(statement)
                    else:
                        self.called[name] = statement


class AssembledFunction(Instructions):
    """A function of rows being translated.

    Each variable is a place in memory for each type that it has, from which LLVM makes values that nobody stores.
    """

    def __init__(self, name: str, outside: Outside, body: list[ast.stmt]) -> None:
        super().__init__()
        self.name, self.outside = name, outside
        self.values = outside.constants | {name: Value(kind, f"%{name}") for name, kind in ARGUMENTS.items()}
        self.tuples: dict[str, list[Value]] = {}
        self.places: dict[str, Value] = {}  # name -> the place that its value is in now
        self.allocated: dict[tuple[str, Value], str] = {}  # function called, type and name of a variable -> its place
        self.inside = ""  # the function that is written out, told apart from its other calls
        self.statements(body)

    @property
    def text(self) -> str:
        """The whole function."""
        arguments = ", ".join(f"{kind} %{name}" for name, kind in ARGUMENTS.items())
        places = [f"{place} = alloca {variable.kind}" for (_, variable), place in self.allocated.items()]
        head = f'define void @"{self.name}"({arguments}) nounwind {{'
        return "\n".join([head, "entry:", *places, *self.lines, "ret void", "}"])

    def statements(self, statements: list[ast.stmt]) -> None:
        """Statements, one after the other."""
        for statement in statements:
            match statement:
                case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=parts)):
                    for name, value in zip(names, [self.value(part) for part in parts], strict=True):
                        self.assign(name, value)
                case ast.Assign(targets=[ast.Name(id=name)], value=ast.Tuple(elts=parts)):
                    self.tuples[name] = [self.value(part) for part in parts]
                case ast.Assign(targets=names, value=expression):
                    value = self.value(expression)
                    for name in names:
                        self.assign(name, value)
                case ast.For(target=target, iter=ast.Call(args=bounds), body=body):
                    self.loop(target, [self.as_kind(WHOLE, self.value(bound)) for bound in bounds], body)
                case ast.If(test=test, body=body, orelse=other):
                    self.either(self.value(test), body, other)
                case ast.Expr(value=ast.Call(func=ast.Name(id=name), args=arguments)):
                    self.store(name, arguments)
                case ast.Expr(value=ast.Constant()):  # a docstring
                    pass
                case _:
                    raise AssertionError(ast.unparse(statement))

    def assign(self, target: ast.expr, value: Value) -> None:
        """Put a value into a variable."""
        assert isinstance(target, ast.Name)
        variable = self.inside, Value(value.kind, target.id)
        place = self.allocated.setdefault(variable, f"%p{len(self.allocated)}")
        self.places[target.id] = Value(value.kind, place)
        self.lines.append(f"store {value}, ptr {place}")

    def loop(self, index: ast.expr, bounds: list[Value], body: list[ast.stmt]) -> None:
        """A loop over whole numbers."""
        start, stop = bounds if len(bounds) == 2 else (Value(WHOLE, "0"), *bounds)
        before, head, turn, end, after = self.block, *(self.fresh() for _ in range(4))
        self.go_to(head)
        self.begin(head)
        number = self.named(WHOLE, f"phi i64 [{start.text}, %{before}], [%{end}.next, %{end}]")
        self.branch(self.named(BIT, f"icmp slt {number}, {stop.text}"), turn, after)
        self.begin(turn)
        self.assign(index, number)
        self.statements(body)
        self.go_to(end)
        self.begin(end)
        self.lines.append(f"%{end}.next = add nsw {number}, 1")
        self.go_to(head)
        self.begin(after)

    def either(self, condition: Value, body: list[ast.stmt], other: list[ast.stmt]) -> None:
        """One of two lists of statements."""
        if_true, if_false, after = (self.fresh() for _ in range(3))
        self.branch(condition, if_true, if_false)
        for label, statements in ((if_true, body), (if_false, other)):
            self.begin(label)
            self.statements(statements)
            self.go_to(after)
        self.begin(after)

    def store(self, function: str, arguments: list[ast.expr]) -> None:
        """Write into a row, or into a buffer, which is as a row of its own."""
        row = ast.literal_eval(arguments[0]) if function.startswith("write_") else 0
        memory, index, value = (self.value(each) for each in arguments[-3:])
        kind = ACCESSED[function.rpartition("_")[2]]
        where = self.element(kind, memory, index)
        self.lines.append(f"store {self.as_kind(kind, value)}, {where}, align {aligned(kind)}, {self.only(row)}")

    def value(self, expression: ast.expr) -> Value:
        """What an expression gives."""
        match expression:
            case ast.Constant(value=bool() as truth):
                return Value(BIT, str(truth).lower())
            case ast.Constant(value=int() | float() as number):
                return constant(WHOLE if isinstance(number, int) else DOUBLE, number)
            case ast.Name(id=name) if name in self.places:
                kind, place = self.places[name]
                return self.named(kind, f"load {kind}, ptr {place}")
            case ast.Name(id=name):
                return self.values[name]
            case ast.Subscript(value=ast.Name(id=name), slice=ast.Constant(value=int() as index)) if (
                name in self.tuples
            ):
                return self.tuples[name][index]
            case ast.Subscript(value=memory, slice=at):
                return self.named(WHOLE, f"load i64, {self.element(WHOLE, self.value(memory), self.value(at))}")
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.negated(self.value(operand))
            case ast.BinOp(left=left, op=op, right=right):
                return self.operation(type(op), self.value(left), self.value(right))
            case ast.BoolOp(op=ast.And(), values=[left, right]):
                return self.operation(ast.BitAnd, self.value(left), self.value(right))
            case ast.Compare(left=left, ops=[order], comparators=[right]):
                return self.comparison(ORDER[type(order)], self.value(left), self.value(right))
            case ast.IfExp(test=test, body=if_true, orelse=if_false):
                return self.one_of(self.value(test), if_true, if_false)
            case ast.Call(func=function, args=arguments):
                return self.call(ast.unparse(function), arguments)
        raise AssertionError(ast.unparse(expression))

    def one_of(self, condition: Value, *expressions: ast.expr) -> Value:
        """The first of two expressions if a condition holds, else the second; the other is not computed."""
        labels, after, ways = [self.fresh(), self.fresh()], self.fresh(), []
        self.branch(condition, *labels)
        for label, expression in zip(labels, expressions, strict=True):
            self.begin(label)
            value = self.value(expression)
            ways.append(f"[{value.text}, %{self.block}]")
            self.go_to(after)
        self.begin(after)
        return self.named(value.kind, f"phi {value.kind} {', '.join(ways)}")

    def call(self, function: str, arguments: list[ast.expr]) -> Value:
        """A call: of a type, of what `plain_memory` has, of an elementary function, of one of the module."""
        if function in self.outside.called:
            return self.written_out(self.outside.called[function], arguments)
        if function.startswith("reread_"):
            row, *arguments = arguments
            return self.load(function, [self.value(each) for each in arguments], self.only(ast.literal_eval(row)))
        values = [self.value(each) for each in arguments]
        if function in KINDS:
            return self.as_kind(KINDS[function], *values)
        if function == "chosen":
            condition, if_true, if_false = values
            return self.named(if_true.kind, f"select {condition}, {if_true}, {self.as_kind(if_true.kind, if_false)}")
        if function in CALLED:
            return self.named(FLOAT, f"call float @{CALLED[function]}({', '.join(map(str, values))})")
        return self.load(function, values, f"!noalias {ALL_ROWS}")

    def written_out(self, function: ast.FunctionDef, arguments: list[ast.expr]) -> Value:
        """What a function returns, whose statements stand here."""
        *body, returned = function.body
        assert isinstance(returned, ast.Return) and returned.value
        outer = self.values, self.tuples, self.places, self.inside
        inner, tuples = dict(self.outside.constants), dict[str, list[Value]]()
        for parameter, argument in zip(function.args.args, arguments, strict=True):
            if isinstance(argument, ast.Tuple):
                tuples[parameter.arg] = [self.value(each) for each in argument.elts]
            elif isinstance(argument, ast.Name) and argument.id in self.tuples:
                tuples[parameter.arg] = self.tuples[argument.id]
            else:
                inner[parameter.arg] = self.value(argument)
        self.values, self.tuples, self.places, self.inside = inner, tuples, {}, self.fresh()
        self.statements(body)
        result = self.value(returned.value)
        self.values, self.tuples, self.places, self.inside = outer
        return result

    def load(self, function: str, values: list[Value], apart: str) -> Value:
        """What lies in memory; a byte as a number of 32 bits."""
        kind = ACCESSED[function.rpartition("_")[2]]
        value = self.named(kind, f"load {kind}, {self.element(kind, *values)}, align {aligned(kind)}, {apart}")
        return self.as_kind(WORD, value) if kind == BYTE else value


def aligned(kind: str) -> int:
    """The bytes that an element takes."""
    return 1 if kind == BYTE else 4
