"""The typed syntax tree of a stage: what the front end makes of its source and the interpreters walk.

A type is the Python object that stands in the signature: float, int, bool, vec3, mat4, Texture[vec3] and so on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Protocol, runtime_checkable


@runtime_checkable
class Callee(Protocol):
    """What a stage may call: a primitive, or a function of the language. Called, it computes with NumPy."""

    @property
    def name(self) -> str:
        """Its name, as in GLSL."""

    def __call__(self, *arguments: Any) -> Any:
        """Its value for values of the language."""

    def result_type(self, types: list[Any]) -> Any:
        """What a call with these argument types gives, or None where they do not fit."""

    def body(self, types: tuple[Any, ...]) -> Body | None:
        """The tree for these argument types, which must fit; None of a primitive."""


@dataclass(frozen=True)
class Literal:
    """A number or truth value written in the source; a float one is exact in float32."""

    type: Any
    value: float | int | bool


@dataclass(frozen=True)
class Constant:
    """A float32 or int constant of the module, by its name."""

    type: Any
    name: str
    value: float | int


@dataclass(frozen=True)
class Variable:
    """A parameter, a local value or a loop index."""

    type: Any
    name: str


@dataclass(frozen=True)
class Member:
    """Some components of a vector: `.x`, `.xy`, `.xyz`."""

    type: Any
    vector: Expression
    letters: str


@dataclass(frozen=True)
class Operation:
    """`operator` is one of + - * / < <= > >= == != & |, or "neg"."""

    type: Any
    operator: str
    operands: tuple[Expression, ...]


@dataclass(frozen=True)
class Construct:
    """A vector from its parts: vec4(position, 1.0)."""

    type: Any
    parts: tuple[Expression, ...]


@dataclass(frozen=True)
class Element:
    """One element of a uniform array."""

    type: Any
    array: Variable
    index: Expression


@dataclass(frozen=True)
class Call:
    """A call of a primitive, or of a function with the body it has for these argument types."""

    type: Any
    callee: Callee
    arguments: tuple[Expression, ...]
    body: Body | None = None


Expression = Literal | Constant | Variable | Member | Operation | Construct | Element | Call


@dataclass(frozen=True)
class Assign:
    """name = value."""

    name: str
    value: Expression
    line: int


@dataclass(frozen=True)
class Loop:
    """For index in range(start, stop): the statements of `block`."""

    index: str
    start: Expression
    stop: Expression
    block: tuple[Assign, ...]
    line: int


@dataclass(frozen=True)
class Return:
    """The values of a body, by output name (a function's only value is called "return")."""

    values: Mapping[str, Expression]
    line: int


@dataclass(frozen=True)
class Body:
    """A checked function: parameters with their types, statements in order, and the one return at the end."""

    parameters: Mapping[str, Any]
    statements: tuple[Assign | Loop, ...]
    result: Return


def children(expression: Expression) -> tuple[Expression, ...]:
    """The expressions directly inside an expression."""
    match expression:
        case Member(vector=inner):
            return (inner,)
        case Operation(operands=inner) | Construct(parts=inner) | Call(arguments=inner):
            return inner
        case Element(array=array, index=index):
            return (array, index)
    return ()


def names_in(expression: Expression) -> Iterator[str]:
    """Every name an expression mentions."""
    if isinstance(expression, Variable):
        yield expression.name
    for inner in children(expression):
        yield from names_in(inner)


def expressions(body: Body) -> Iterator[Expression]:
    """The right sides of all lines of a body."""
    for statement in body.statements:
        block = statement.block if isinstance(statement, Loop) else (statement,)
        yield from (assign.value for assign in block)
    yield from body.result.values.values()


def accumulators(body: Body) -> set[str]:
    """The names that a loop assigns again."""
    outside = {each.name for each in body.statements if isinstance(each, Assign)}
    loops = [each for each in body.statements if isinstance(each, Loop)]
    return outside & {assign.name for loop in loops for assign in loop.block}


def with_child(expression: Expression, index: int, child: Expression) -> Expression:
    """An expression with one of its `children` replaced."""

    def put(parts: tuple[Expression, ...]) -> tuple[Expression, ...]:
        return (*parts[:index], child, *parts[index + 1 :])

    match expression:
        case Member():
            return replace(expression, vector=child)
        case Operation(operands=parts):
            return replace(expression, operands=put(parts))
        case Construct(parts=parts):
            return replace(expression, parts=put(parts))
        case Call(arguments=parts):
            return replace(expression, arguments=put(parts))
        case Element(array=array, index=at):
            whole, at = put((array, at))
            assert isinstance(whole, Variable)  # nothing else has elements
            return replace(expression, array=whole, index=at)
    raise AssertionError(expression)


def mapped(body: Body, put: Callable[[Expression], Expression]) -> Body:
    """A body with the right side of every line put through a function; itself if that changes nothing."""
    if all(put(expression) is expression for expression in expressions(body)):
        return body
    statements = tuple(
        replace(each, block=tuple(replace(assign, value=put(assign.value)) for assign in each.block))
        if isinstance(each, Loop)
        else replace(each, value=put(each.value))
        for each in body.statements
    )
    values = {name: put(value) for name, value in body.result.values.items()}
    return replace(body, statements=statements, result=replace(body.result, values=values))
