"""Reads the source of a stage and turns it into a typed tree, or says which line breaks which rule.

The language is the part of Python that means the same in GLSL, in NumPy and in compiled scalar code: names assigned
once, no branches, calls of built-ins and functions only, float literals exact in float32. The one loop is
`for i in range(start, stop)`, in which a name from outside may be accumulated: `total = total + value`.
"""

import ast
import inspect
from collections.abc import Callable, Mapping
from typing import Any, NoReturn, get_args, get_origin

import numpy as np

from sss_ref.errors import StageError
from sss_ref.language import tree
from sss_ref.language.definitions import definition_of
from sss_ref.language.types import Array, Vector
from sss_ref.language.typing_rules import MEMBERS, construct_error, operation_type, type_name

OPERATORS = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.BitAnd: "&",
    ast.BitOr: "|",
}
INSTEAD = {
    ast.If: "a stage has no branches: compute both sides and choose with select(condition, a, b)",
    ast.IfExp: "a stage has no branches: choose with select(condition, a, b)",
    ast.While: "the only loop is `for i in range(start, stop)`",
    ast.BoolOp: "write & and | instead of `and` and `or`: every interpreter computes both sides",
    ast.AugAssign: "write the sum out: total = total + value",
}


def body_of(function: Callable[..., Any], parameters: Mapping[str, Any], outputs: Mapping[str, Any]) -> tree.Body:
    """The typed tree of a Python function for these parameter types (outputs: name -> type, in order).

    Raises StageError, with file and line, for anything that is not in the language.
    """
    return _Reader(function, parameters, outputs).read()


class _Reader:
    """One pass over one function; `names` holds the types of what is in scope."""

    def __init__(self, function: Callable[..., Any], parameters: Mapping[str, Any], outputs: Mapping[str, Any]) -> None:
        self.function = function
        self.parameters = parameters
        self.outputs = outputs
        self.names: dict[str, Any] = dict(parameters)
        self.used: set[str] = set()
        self.scope = {**function.__globals__, **inspect.getclosurevars(function).nonlocals}

    def read(self) -> tree.Body:
        definition = definition_of(self.function)
        self.first_line = definition.lineno
        statements = definition.body[1:] if ast.get_docstring(definition) else definition.body
        if not statements or not isinstance(statements[-1], ast.Return):
            self.fail(definition, "the last statement must be the one `return`")
        read = tuple(self.statement(statement) for statement in statements[:-1])
        result = self.result(statements[-1])
        unused = [name for name in self.parameters if name not in self.used]
        if unused:
            self.fail(definition, f"parameter `{unused[0]}` is never read: the signature is the contract, take it out")
        return tree.Body(dict(self.parameters), read, result)

    def fail(self, node: ast.AST, message: str) -> NoReturn:
        """Raise StageError for the source line of `node`."""
        line = getattr(node, "lineno", self.first_line)
        raise StageError(f"{self.function.__code__.co_filename}:{line}: in {self.function.__name__}: {message}")

    # Statements

    def statement(self, node: ast.stmt) -> tree.Assign | tree.Loop:
        if isinstance(node, ast.For):
            return self.loop(node)
        return self.assign(node)

    def assign(self, node: ast.stmt, accumulators: frozenset[str] = frozenset()) -> tree.Assign:
        if not (isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name)):
            default = "only `name = expression`, the loop and the final return are statements"
            self.fail(node, INSTEAD.get(type(node), default))
        name = node.targets[0].id
        value = self.expression(node.value)
        if name in self.names:
            if name not in accumulators or name not in tree.names_in(value):
                self.fail(node, f"`{name}` is assigned twice; give the new value a name of its own")
            if self.names[name] != value.type:
                self.fail(node, f"`{name}` is {type_name(self.names[name])}, not {type_name(value.type)}")
        self.names[name] = value.type
        return tree.Assign(name, value, node.lineno)

    def loop(self, node: ast.For) -> tree.Loop:
        call = node.iter
        if not (isinstance(node.target, ast.Name) and isinstance(call, ast.Call) and not node.orelse):
            self.fail(node, "the only loop is `for i in range(start, stop)`")
        if not (isinstance(call.func, ast.Name) and call.func.id == "range" and len(call.args) == 2):
            self.fail(node, "the only loop is `for i in range(start, stop)`")
        start, stop = (self.typed(argument, int) for argument in call.args)
        outside = dict(self.names)
        self.names[node.target.id] = int
        block = tuple(self.assign(statement, frozenset(outside)) for statement in node.body)
        self.names = outside
        return tree.Loop(node.target.id, start, stop, block, node.lineno)

    def result(self, node: ast.stmt) -> tree.Return:
        assert isinstance(node, ast.Return)
        if list(self.outputs) == ["return"]:
            return tree.Return({"return": self.typed(node.value, self.outputs["return"])}, node.lineno)
        if not (isinstance(node.value, ast.Call) and len(node.value.args) == len(self.outputs)):
            self.fail(node, f"return the output type with its {len(self.outputs)} fields in order")
        fields = zip(self.outputs.items(), node.value.args, strict=True)
        return tree.Return({name: self.typed(value, kind) for (name, kind), value in fields}, node.lineno)

    # Expressions

    def typed(self, node: ast.expr | None, kind: Any) -> tree.Expression:
        """An expression that must have this type."""
        if node is None:
            self.fail(ast.Pass(), f"expected a value of type {type_name(kind)}")
        value = self.expression(node)
        if value.type != kind:
            self.fail(node, f"expected {type_name(kind)}, got {type_name(value.type)}")
        return value

    def expression(self, node: ast.expr) -> tree.Expression:
        match node:
            case ast.Constant(value=value):
                return self.literal(node, value)
            case ast.Name(id=name):
                return self.name(node, name)
            case ast.Attribute():
                return self.member(node)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.negative(node, self.expression(operand))
            case ast.BinOp(left=left, op=operator, right=right):
                return self.operation(node, OPERATORS.get(type(operator)), left, right)
            case ast.Compare(left=left, ops=[operator], comparators=[right]):
                return self.operation(node, OPERATORS.get(type(operator)), left, right)
            case ast.Call(func=ast.Name(id=name), keywords=[]):
                return self.call(node, name)
            case ast.Subscript(value=ast.Name(id=name), slice=index):
                return self.element(node, name, index)
        self.fail(node, INSTEAD.get(type(node), f"`{ast.unparse(node)}` is not in the language"))

    def literal(self, node: ast.expr, value: object) -> tree.Literal:
        if isinstance(value, float) and float(np.float32(value)) != value:
            self.fail(node, f"literal {value!r} is not exact in float32; make it a parameter or a named constant")
        if not isinstance(value, float | int):
            self.fail(node, f"literal {value!r} is neither a number nor a truth value")
        return tree.Literal(type(value), value)

    def name(self, node: ast.expr, name: str) -> tree.Variable | tree.Constant:
        if name in self.names:
            self.used.add(name)
            return tree.Variable(self.names[name], name)
        value = self.scope.get(name)
        if isinstance(value, np.float32):
            return tree.Constant(float, name, float(value))
        if isinstance(value, int):
            return tree.Constant(int, name, value)
        self.fail(node, f"`{name}` is neither a parameter, a local value, nor a constant (np.float32 or int)")

    def member(self, node: ast.Attribute) -> tree.Member:
        vector = self.expression(node.value)
        if node.attr not in MEMBERS.get(vector.type, ()):
            self.fail(node, f"{type_name(vector.type)} has no component `{node.attr}`")
        result = vector.type.__annotations__[node.attr] if len(node.attr) == 1 else None
        return tree.Member(result or next(k for k in MEMBERS if k.count == len(node.attr)), vector, node.attr)

    def negative(self, node: ast.expr, operand: tree.Expression) -> tree.Expression:
        if operand.type not in (float, int, *MEMBERS):
            self.fail(node, f"no minus for {type_name(operand.type)}")
        if isinstance(operand, tree.Literal):
            return tree.Literal(operand.type, -operand.value)
        return tree.Operation(operand.type, "neg", (operand,))

    def operation(self, node: ast.expr, operator: str | None, *sides: ast.expr) -> tree.Operation:
        if operator is None:
            self.fail(node, f"operator of `{ast.unparse(node)}` is not in the language")
        left, right = (self.expression(side) for side in sides)
        if isinstance(left, tree.Literal) and isinstance(right, tree.Literal):
            self.fail(node, f"`{ast.unparse(node)}` has two literals: Python would compute it in float64; name it")
        kind = operation_type(operator, left.type, right.type)
        if kind is None:
            self.fail(node, f"no `{operator}` between {type_name(left.type)} and {type_name(right.type)}")
        return tree.Operation(kind, operator, (left, right))

    def call(self, node: ast.Call, name: str) -> tree.Expression:
        callee = self.scope.get(name)
        arguments = tuple(self.expression(argument) for argument in node.args)
        types = [argument.type for argument in arguments]
        if isinstance(callee, type) and issubclass(callee, Vector):
            wrong = construct_error(callee, types)
            return self.fail(node, wrong) if wrong else tree.Construct(callee, arguments)
        if not isinstance(callee, tree.Callee):
            self.fail(node, f"`{name}` is neither a built-in nor a function of the language (@function)")
        result = callee.result_type(types)
        if result is None:
            self.fail(node, f"`{name}` does not take ({', '.join(map(type_name, types))})")
        return tree.Call(result, callee, arguments, callee.body(tuple(types)))

    def element(self, node: ast.expr, name: str, index: ast.expr) -> tree.Element:
        array = self.name(node, name)
        if not isinstance(array, tree.Variable) or get_origin(array.type) is not Array:
            self.fail(node, f"`{name}` is {type_name(array.type)}: only a uniform Array has elements")
        return tree.Element(get_args(array.type)[0], array, self.typed(index, int))
