"""The tree of a stage, run: what its lines give, for one fragment or for arrays of fragments."""

import operator
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from sss_ref.language import tree

OPERATORS: dict[str, Callable[..., Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
    "&": operator.and_,
    "|": operator.or_,
    "neg": operator.neg,
}


def run_body(body: tree.Body, names: Mapping[str, Any]) -> dict[str, Any]:
    """Run a body: output -> value. names: parameter -> value; arrays of fragments do as well as scalars."""
    return Evaluation(dict(names)).run(body, {})


class Evaluation:
    """The values of one body as its lines are run, by name. Who wants to know more of a line overrides what is here."""

    def __init__(self, names: dict[str, Any]) -> None:
        self.names = names

    def run(self, body: tree.Body, results: Mapping[str, str]) -> dict[str, Any]:
        """Run a body; output -> value. results: output -> the name that its line is told under."""
        for statement in body.statements:
            if isinstance(statement, tree.Loop):
                self.loop(statement)
            else:
                self.names[statement.name] = self.line(statement.name, statement.value)
        return {own: self.line(results.get(own, ""), value) for own, value in body.result.values.items()}

    def line(self, name: str, expression: tree.Expression) -> Any:
        """What a line gives."""
        return self.value(expression)

    def loop(self, statement: tree.Loop) -> None:
        """Run a loop."""
        for index in range(self.value(statement.start), self.value(statement.stop)):
            self.turn(statement, index)

    def turn(self, statement: tree.Loop, index: int) -> None:
        """Run the block of a loop once."""
        self.names[statement.index] = index
        for assign in statement.block:
            self.names[assign.name] = self.line(assign.name, assign.value)

    def value(self, expression: tree.Expression) -> Any:
        """The value of an expression."""
        match expression:
            case tree.Literal(value=value):
                return value
            case tree.Constant(type=kind, value=value):
                return np.float32(value) if kind is float else value
            case tree.Variable(name=name):
                return self.names[name]
            case tree.Member(vector=vector, letters=letters):
                return getattr(self.value(vector), letters)
            case tree.Construct(type=kind, parts=parts):
                return kind(*map(self.value, parts))
            case tree.Operation(operator=sign, operands=operands):
                return OPERATORS[sign](*map(self.value, operands))
            case tree.Element():
                return self.element(expression)
            case tree.Call():
                return self.call(expression)

    def element(self, expression: tree.Element) -> Any:
        """One element of a uniform array."""
        return self.names[expression.array.name][self.value(expression.index)]

    def call(self, expression: tree.Call) -> Any:
        """A call of a primitive, or of a function, which is run in names of its own."""
        arguments = list(map(self.value, expression.arguments))
        if expression.body is None:
            return expression.callee(*arguments)
        names = dict(zip(expression.body.parameters, arguments, strict=True))
        return type(self)(names).run(expression.body, {})["return"]
