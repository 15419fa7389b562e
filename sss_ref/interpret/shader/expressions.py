"""Expressions of the typed tree as text, with no more parentheses than their order needs."""

from collections.abc import Mapping
from typing import Any, Protocol, get_args, get_origin

import numpy as np

from sss_ref.interpret.shader.dialect import Dialect
from sss_ref.language import tree
from sss_ref.language.intrinsics import Primitive
from sss_ref.language.types import Vector, mat3, mat4

SELECTION, OR, AND, EQUALITY, ORDER, SUM, PRODUCT, SIGN, ATOM = range(9)  # how tightly an operator binds
BINDING = {
    "|": OR,
    "&": AND,
    **dict.fromkeys(("==", "!="), EQUALITY),
    **dict.fromkeys(("<", "<=", ">", ">="), ORDER),
    **dict.fromkeys("+-", SUM),
    **dict.fromkeys("*/", PRODUCT),
    "neg": SIGN,
}
SYMBOLS = {"&": "&&", "|": "||"}
LOADED = {bool: EQUALITY}  # a truth value in a texture is a number other than 0


def number(kind: Any, value: float | int | bool) -> str:
    """A literal; a float has the fewest digits that give back its float32."""
    if kind is bool:
        return "true" if value else "false"
    return str(value) if kind is int else repr(float(str(np.float32(value))))


class Definitions(Protocol):
    """What expressions refer to: each method gives the name of a definition, which the shader holds from then on."""

    dialect: Dialect

    def constant(self, constant: tree.Constant) -> str:
        """The name of a constant of a stage's module."""

    def extreme(self, name: str, kind: Any) -> str:
        """The name of min or max for two values of a type."""

    def texture_size(self, texture: Any) -> str:
        """The name of what gives the size of a texture of a type."""

    def transform(self, matrix: Any) -> str:
        """The name of the product of a matrix of a type and a vector."""

    def function(self, call: tree.Call, lengths: Mapping[str, int]) -> str:
        """The name of a function of the language for the types of a call; lengths: those of the caller's arrays."""


class Expressions:
    """Writes the expressions of one function; `lengths`: uniform array -> its length, where it is no texture."""

    def __init__(self, definitions: Definitions, lengths: Mapping[str, int]) -> None:
        self.definitions, self.dialect, self.lengths = definitions, definitions.dialect, lengths

    def text(self, expression: tree.Expression, least: int = SELECTION) -> str:
        """The expression, in parentheses where it binds less than `least`."""
        written, binding = self.written(expression)
        return written if binding >= least else f"({written})"

    def written(self, expression: tree.Expression) -> tuple[str, int]:
        """The expression and how tightly it binds."""
        match expression:
            case tree.Literal(type=kind, value=value):
                text = number(kind, value)
                return text, SIGN if text.startswith("-") else ATOM
            case tree.Constant():
                return self.definitions.constant(expression), ATOM
            case tree.Variable(name=name):
                return self.dialect.name(name), ATOM
            case tree.Member(vector=vector, letters=letters):
                return f"{self.text(vector, ATOM)}.{letters}", ATOM
            case tree.Construct(type=kind, parts=parts):
                return f"{self.dialect.types[kind]}({self.listed(parts)})", ATOM
            case tree.Operation():
                return self.operation(expression)
            case tree.Element(array=array, index=index):
                return self.element(array, index)
            case tree.Call():
                return self.call(expression)

    def listed(self, expressions: tuple[tree.Expression, ...]) -> str:
        """Expressions with commas between them."""
        return ", ".join(map(self.text, expressions))

    def operation(self, expression: tree.Operation) -> tuple[str, int]:
        """An operation; what stands on the right of its equal needs parentheses, as operators group to the left."""
        binding = BINDING[expression.operator]
        first = expression.operands[0]
        if expression.operator == "neg":
            return f"-{self.text(first, ATOM)}", binding
        if first.type in (mat3, mat4):
            return f"{self.definitions.transform(first.type)}({self.listed(expression.operands)})", ATOM
        symbol, second = SYMBOLS.get(expression.operator, expression.operator), expression.operands[1]
        if expression.operator in self.dialect.calls and first.type is float:
            return self.dialect.calls[expression.operator].format(self.text(first, SUM), self.text(second, SUM)), SIGN
        if expression.operator == "|":
            return f"{self.side_of_or(first)} {symbol} {self.side_of_or(second)}", binding
        return f"{self.text(first, binding)} {symbol} {self.text(second, binding + 1)}", binding

    def side_of_or(self, expression: tree.Expression) -> str:
        """What stands beside an or: an and in parentheses, without which WGSL takes none."""
        written, binding = self.written(expression)
        return f"({written})" if binding in (SELECTION, AND) else written

    def element(self, array: tree.Variable, index: tree.Expression) -> tuple[str, int]:
        """One element of a uniform array; in a texture its index is divided."""
        name, (kind,) = self.dialect.name(array.name), get_args(array.type)
        if array.name in self.lengths:
            return f"{name}[{self.text(index)}]", ATOM
        return self.dialect.looked_up(kind, name, self.text(index, PRODUCT)), LOADED.get(kind, ATOM)

    def call(self, expression: tree.Call) -> tuple[str, int]:
        """A primitive as the dialect has it; a function of the language by the name of its definition."""
        name, arguments = expression.callee.name, expression.arguments
        if expression.body is not None:
            return f"{self.definitions.function(expression, self.lengths)}({self.listed(arguments)})", ATOM
        if name == "select" and "select" not in self.dialect.calls:
            condition, if_true, if_false = arguments
            sides = f"{self.widened(if_true, expression, OR)} : {self.widened(if_false, expression)}"
            return f"{self.text(condition, OR)} ? {sides}", SELECTION
        if name == "texel":
            (kind,) = get_args(arguments[0].type)
            return self.dialect.fetched(kind, *map(self.text, arguments)), LOADED.get(kind, ATOM)
        texts = [self.widened(argument, expression) for argument in arguments]
        if name in self.dialect.calls:
            return self.dialect.calls[name].format(*texts), ATOM
        if name == "size":
            return f"{self.definitions.texture_size(arguments[0].type)}({texts[0]})", ATOM
        return f"{self.definitions.extreme(name, expression.type)}({', '.join(texts)})", ATOM

    def widened(self, argument: tree.Expression, call: tree.Call, least: int = SELECTION) -> str:
        """An argument of a primitive, as `text` has it; a scalar that stands beside a vector becomes one."""
        text = self.text(argument, least)
        assert isinstance(call.callee, Primitive)
        vector = isinstance(call.type, type) and issubclass(call.type, Vector) and get_origin(argument.type) is None
        scalar = vector and call.callee.by_component and argument.type is float
        return self.dialect.splat.format(self.dialect.types[call.type], text) if scalar else text
