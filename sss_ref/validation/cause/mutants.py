"""Mistakes that shaders have: every way to change one place of a stage, as trees that can be run.

A mutant is a body in which one call is dropped, one operator or constant is another, two operands have changed places,
or one term is missing, in the stage or in a function it calls; GLSL's own functions are left as they are.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from sss_ref.language import builtins, tree
from sss_ref.language.evaluation import run_body
from sss_ref.language.notation import written
from sss_ref.language.stage import Stage

OTHER_OPERATORS = {
    "+": "-",
    "-": "+",
    "*": "/",
    "/": "*",
    "<": ">=",
    "<=": ">",
    ">": "<=",
    ">=": "<",
    "==": "!=",
    "&": "|",
    "|": "&",
}
ORDERED = ("-", "/")  # operators whose operands may have changed places
OTHER_LITERALS = {0.0: 1.0, 1.0: 0.0, 2.0: 1.0, 0.5: 0.0}
OTHER_MEMBERS = {"x": "y", "y": "x", "z": "x", "w": "z"}


@dataclass(frozen=True)
class Mutant:
    """A stage with one mistake.

    line: the line as it should be. wrong: as it is in the mutant. inside: the function it is in, or "".
    right, mistaken: the body of the stage, or of that function, without and with the mistake.
    """

    stage: Stage
    right: tree.Body
    mistaken: tree.Body
    line: str
    wrong: str
    inside: str = ""

    @cached_property
    def body(self) -> tree.Body:
        """The body of the stage with the mistake, in a function wherever that is called."""
        return _with_function(self.stage.body, self.right, self.mistaken) if self.inside else self.mistaken

    @property
    def description(self) -> str:
        """The mistake in words."""
        where = f" in {self.inside}" if self.inside else ""
        return f"`{self.wrong}` for `{self.line}`{where}"

    def __call__(self, *inputs: Any) -> dict[str, Any]:
        """Buffer -> value, as the stage gives them with the mistake."""
        with np.errstate(all="ignore"):
            results = run_body(self.body, dict(zip(self.stage.parameters, inputs, strict=True)))
        return {self.stage.writes[own]: value for own, value in results.items()}


def mutants(stage: Stage) -> Iterator[Mutant]:
    """Every mutant of a stage."""
    for name, body in {"": stage.body, **_functions(stage.body)}.items():
        for mistaken, line, wrong in _of_body(body):
            yield Mutant(stage, body, mistaken, line, wrong, name)


Changed = tuple[tree.Body, str, str]  # the body, the line before, the line after


def _of_body(body: tree.Body) -> Iterator[Changed]:
    """The body with one place of its own lines changed."""
    for k, statement in enumerate(body.statements):
        block = statement.block if isinstance(statement, tree.Loop) else (statement,)
        for index, assign in enumerate(block):
            for value in _of_expression(assign.value):
                line = replace(assign, value=value)
                inside = (*block[:index], line, *block[index + 1 :])
                other = replace(statement, block=inside) if isinstance(statement, tree.Loop) else line
                statements = (*body.statements[:k], other, *body.statements[k + 1 :])
                yield replace(body, statements=statements), *_lines(assign.name, assign.value, value)
    for name, before in body.result.values.items():
        for value in _of_expression(before):
            result = replace(body.result, values={**body.result.values, name: value})
            yield replace(body, result=result), *_lines("" if name == "return" else name, before, value)


def _lines(name: str, before: tree.Expression, after: tree.Expression) -> tuple[str, str]:
    left = f"{name} = " if name else ""
    return left + written(before), left + written(after)


def _functions(body: tree.Body) -> dict[str, tree.Body]:
    """The functions that a body calls, and those that these call, by name; GLSL's own are left out."""
    found: dict[str, tree.Body] = {}

    def look(expression: tree.Expression) -> None:
        for child in tree.children(expression):
            look(child)
        if isinstance(expression, tree.Call) and expression.body is not None and not _is_builtin(expression):
            found.setdefault(expression.callee.name, expression.body)
            for inner in tree.expressions(expression.body):
                look(inner)

    for expression in tree.expressions(body):
        look(expression)
    return found


def _with_function(body: tree.Body, old: tree.Body, new: tree.Body) -> tree.Body:
    """The body with a function replaced in all calls, those in other functions too."""

    def put(expression: tree.Expression) -> tree.Expression:
        for k, child in enumerate(tree.children(expression)):
            changed = put(child)
            if changed is not child:
                expression = tree.with_child(expression, k, changed)
        if isinstance(expression, tree.Call) and expression.body is not None:
            inner = new if expression.body is old else _with_function(expression.body, old, new)
            return expression if inner is expression.body else replace(expression, body=inner)
        return expression

    return tree.mapped(body, put)


def _of_expression(expression: tree.Expression) -> Iterator[tree.Expression]:
    """The expression with one place changed."""
    yield from _here(expression)
    for k, child in enumerate(tree.children(expression)):
        for other in _of_expression(child):
            yield tree.with_child(expression, k, other)


def _is_builtin(call: tree.Call) -> bool:
    """Whether GLSL has the function itself, so that nobody writes it wrong."""
    return call.callee.name in vars(builtins)


def _here(expression: tree.Expression) -> Iterator[tree.Expression]:
    """The changes of an expression itself, all of its own type."""
    match expression:
        case tree.Literal(type=kind, value=value) if kind is float and value in OTHER_LITERALS:
            yield replace(expression, value=OTHER_LITERALS[value])
        case tree.Member(letters=letters) if letters in OTHER_MEMBERS:
            other = OTHER_MEMBERS[letters]
            if hasattr(expression.vector.type, other):
                yield replace(expression, letters=other)
        case tree.Operation(operands=(operand,)):
            yield operand
        case tree.Operation(operator=operator, operands=(left, right)):
            yield from _of_operation(expression, operator, left, right)
        case tree.Call(arguments=arguments):
            yield from (each for each in arguments if each.type == expression.type)
            if len(arguments) >= 2 and arguments[-1].type == arguments[-2].type:
                yield replace(expression, arguments=(*arguments[:-2], arguments[-1], arguments[-2]))


def _of_operation(
    whole: tree.Operation, operator: str, left: tree.Expression, right: tree.Expression
) -> Iterator[tree.Expression]:
    matrix = whole.type not in (left.type, bool)
    if operator in OTHER_OPERATORS and not matrix and whole.type is not int:
        yield replace(whole, operator=OTHER_OPERATORS[operator])
    if operator in ORDERED and left.type == right.type:
        yield replace(whole, operands=(right, left))
    yield from (
        side for side in (left, right) if side.type == whole.type and operator in ("+", "-", "*", "/", "&", "|")
    )
