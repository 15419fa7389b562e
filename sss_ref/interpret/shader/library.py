"""The definitions a shader needs: constants, functions for the types they are called with, structs and stages."""

import inspect
from collections.abc import Iterator, Mapping
from itertools import count
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from sss_ref.interpret.shader.dialect import FLOATING, Dialect
from sss_ref.interpret.shader.expressions import SUM, Expressions, number
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.text import braced, comment, folded
from sss_ref.language import tree
from sss_ref.language.stage import Function, Stage
from sss_ref.language.types import Array, Texture, Vector, ivec2, mat3, vec3, vec4
from sss_ref.language.typing_rules import element_type, type_name

EXTREMES = {"min": ("y < x", "y", "x"), "max": ("x < y", "y", "x")}  # condition, value if so, else: rule A1
CHOICE = "{0} ? {1} : {2}"  # of C's kin


def stage_source(stage: Stage, lengths: Mapping[str, int], dialect: Dialect = GLSL) -> str:
    """One stage as a function of a shader, with all that it uses before it.

    lengths: uniform array -> its length, see `array_lengths`. dialect: one of `DIALECTS`.
    """
    library = Library(dialect)
    library.stage(stage, lengths)
    return library.text


class Library:
    """Definitions, each written once and after those it uses."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self._constants: dict[str, str] = {}
        self._definitions: dict[Any, list[str]] = {}

    @property
    def text(self) -> str:
        """All that was asked for and what that uses, constants first."""
        blocks = ["\n".join(self._constants.values()), *map("\n".join, self._definitions.values())]
        return folded("\n\n".join(block for block in blocks if block))

    def constant(self, constant: tree.Constant) -> str:
        """The name of a constant of a stage's module."""
        declared = self.dialect.declared(constant.type, constant.name)
        self._constants[constant.name] = (
            f"{self.dialect.constant} {declared} = {number(constant.type, constant.value)};"
        )
        return constant.name

    def extreme(self, name: str, kind: Any) -> str:
        """The name of min or max for two values of a type; that of vectors works on their components."""
        written, meaning = self._of_type(name, kind), CHOICE.format(*EXTREMES[name])
        result = self.dialect.calls.get("select", CHOICE).format(*EXTREMES[name])
        if isinstance(kind, type) and issubclass(kind, Vector):
            self.extreme(name, element_type(kind))
            one = self._of_type(name, element_type(kind))
            each = ", ".join(f"{one}(x.{letter}, y.{letter})" for letter in "xyzw"[: kind.count])
            result = f"{self.dialect.types[kind]}({each})"
        head = self._signature(kind, written, {"x": kind, "y": kind})
        self._define((name, kind), f"{meaning} (rule A1)", head, [f"return {result};"])
        return written

    def _of_type(self, name: str, kind: Any) -> str:
        """The name of a function for values of a type: the same for all types where the language tells them apart."""
        return self.dialect.name(name if self.dialect.overloads else f"{name}_{type_name(kind)}")

    def texture_size(self, texture: Any) -> str:
        """The name of what gives the size of a texture of a type."""
        head = self._signature(ivec2, "texture_size", {"map": texture})
        self._define(("size", texture), "Width and height in texels.", head, [*self.dialect.size])
        return "texture_size"

    def transform(self, matrix: Any) -> str:
        """The name of the product of a matrix and a vector."""
        vector = vec3 if matrix is mat3 else vec4
        name = self._of_type("transform", matrix)
        head = self._signature(vector, name, {"m": matrix, "v": vector})
        doc = "Matrix times vector, each row summed in this order (rule A3)."
        declared, product = self.dialect.computed(vector, "result"), self.dialect.products[matrix]
        lines = [self.dialect.written.fixed.format(declared=declared, value=product), "return result;"]
        self._define(("transform", matrix), doc, head, lines)
        return name

    def function(self, call: tree.Call, lengths: Mapping[str, int]) -> str:
        """The name of a function of the language for the types of a call; lengths: those of the caller's arrays.

        One that says something else than another stage's function of the same name and types gets a number.
        """
        callee, body = call.callee, call.body
        assert isinstance(callee, Function) and body is not None
        given = zip(body.parameters, call.arguments, strict=True)
        own = {name: lengths[a.name] for name, a in given if isinstance(a, tree.Variable) and a.name in lengths}
        first = self.dialect.name(callee.name + generic_suffix(callee, body, self.dialect.overloads))
        kinds = (*body.parameters.values(), *own.items()) if self.dialect.overloads else ()
        doc, lines = inspect.getdoc(callee.python), self._body(body, own)

        def is_defined(name: str) -> bool:
            return self._define((name, *kinds), doc, self._signature(call.type, name, body.parameters, own), lines)

        return next(filter(is_defined, _numbered(first)))

    def stage(self, stage: Stage, lengths: Mapping[str, int]) -> None:
        """Define a stage; lengths: uniform array, as the pass names it -> its length (of others: a texture)."""
        arrays = {own: stage.reads[own] for own, kind in stage.parameters.items() if get_origin(kind) is Array}
        struct = stage.result_struct
        written, declared = self.dialect.written, self.dialect.declared
        fields = [written.field.format(declared=declared(kind, name)) for name, kind in stage.outputs.items()]
        self._define(struct, inspect.getdoc(struct), f"struct {struct.__name__}", fields, end=written.struct_end)
        own = {name: lengths[read] for name, read in arrays.items() if read in lengths}
        head = self._signature(struct, self.dialect.name(stage.name), stage.parameters, own)
        doc = f"{stage.description}\nSource: {stage.source}."
        self._define((stage.python, stage.variant), doc, head, self._body(stage.body, own, struct.__name__))

    def _define(self, key: Any, doc: str | None, head: str, lines: list[str], end: str = "}") -> bool:
        """Add a definition unless there is one with this key; whether that one says the same."""
        definition = [*comment(doc or ""), *braced(head, lines, end)]
        return self._definitions.setdefault(key, definition) == definition

    def _signature(
        self, result: Any, name: str, parameters: Mapping[str, Any], lengths: Mapping[str, int] | None = None
    ) -> str:
        """The head of a function: in C's kin `type name(type parameter, ...)`."""
        known = lengths or {}
        listed = ", ".join(self.dialect.declared(kind, own, known.get(own)) for own, kind in parameters.items())
        return self.dialect.written.function.format(result=self.dialect.type(result), name=name, parameters=listed)

    def _body(self, body: tree.Body, lengths: Mapping[str, int], struct: str = "") -> list[str]:
        """The statements of a body; `struct`: what it returns, if not a single value."""
        expressions, changing = Expressions(self, lengths), tree.accumulators(body)
        known = set(body.parameters)
        lines: list[str] = []
        for statement in body.statements:
            if isinstance(statement, tree.Assign):
                lines.append(self._assign(statement, known, expressions, statement.name in changing))
            else:
                lines += self._loop(statement, known, expressions)
        values = [
            self._result(own if struct else "result", value, known, expressions, lines)
            for own, value in body.result.values.items()
        ]
        returned = self.dialect.returned if struct else ("return {values};",)
        return [*lines, *(line.format(struct=struct, values=", ".join(values)) for line in returned)]

    def _result(
        self, own: str, value: tree.Expression, known: set[str], expressions: Expressions, lines: list[str]
    ) -> str:
        """What a function returns: an exact result is a variable, declared in a line of its own."""
        text = expressions.text(value)
        if not self.dialect.exact or not _rounds(value):
            return text
        name = next(name for name in _numbered(own) if name not in known)
        known.add(name)
        lines.append(self.dialect.written.fixed.format(declared=self.dialect.computed(value.type, name), value=text))
        return self.dialect.name(name)

    def _assign(self, statement: tree.Assign, known: set[str], expressions: Expressions, changes: bool = False) -> str:
        """`type name = value;`, without the type where an accumulator is assigned again; changes: whether it is one."""
        text = expressions.text(statement.value)
        if statement.name in known:
            return f"{self.dialect.name(statement.name)} = {text};"
        known.add(statement.name)
        form = self.dialect.written.changing if changes else self.dialect.written.fixed
        return form.format(declared=local(self.dialect, statement.name, statement.value), value=text)

    def _loop(self, statement: tree.Loop, known: set[str], expressions: Expressions) -> list[str]:
        """The loop; what is new in its block is unknown after it."""
        index, inside = self.dialect.name(statement.index), set(known)
        start, stop = expressions.text(statement.start), expressions.text(statement.stop, SUM)
        head = self.dialect.written.loop.format(index=index, start=start, stop=stop)
        block = [self._assign(assign, inside, expressions) for assign in statement.block]
        return braced(head, block)


def local(dialect: Dialect, name: str, value: tree.Expression) -> str:
    """The declaration of a local variable that holds a value; its sums must stay as written."""
    is_sum = value.type in FLOATING or _rounds(value)
    return (dialect.computed if is_sum else dialect.declared)(value.type, name)


def _rounds(expression: tree.Expression) -> bool:
    """Whether an expression has operations on numbers of its own, apart from those in the functions that it calls."""
    own = isinstance(expression, tree.Operation) and expression.type in FLOATING
    return own or any(map(_rounds, tree.children(expression)))


def _numbered(name: str) -> Iterator[str]:
    """The name itself, then name_2, name_3 ..."""
    yield name
    yield from (f"{name}_{k}" for k in count(2))


def generic_suffix(callee: Function, body: tree.Body, overloads: bool) -> str:
    """What tells apart the forms of a function that is generic in what a texture holds: their parameters may not.

    overloads: whether they may where the function is generic in a parameter's own type.
    """
    for name, kind in body.parameters.items():
        hint = get_type_hints(callee.python)[name]
        if get_origin(hint) is Texture and isinstance(get_args(hint)[0], TypeVar):
            return f"_{type_name(get_args(kind)[0])}"
        if isinstance(hint, TypeVar) and not overloads:
            return f"_{type_name(kind)}"
    return ""
