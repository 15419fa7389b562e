"""The vocabulary of the shader language: types and built-ins, with their signatures and exact definitions."""

import inspect
from collections.abc import Callable, Iterable
from typing import Any, TypeVar, get_args, get_type_hints

from markup import directive, prose

from sss_ref import language
from sss_ref.language.intrinsics import Primitive
from sss_ref.language.stage import Function
from sss_ref.language.types import Vector
from sss_ref.language.typing_rules import type_name

HEAD = """# The shader language

What a stage is written in, `from sss_ref.language import ...`. Names and meanings are GLSL's; where GLSL leaves the
result open, the rule that decides is named. A body assigns each name once, has no `if`, chooses with `select`, and
loops in one form, `for i in range(a, b)`. Operators `+ - * /` work component by component; `&` and `|` join conditions.
"""


def page() -> str:
    """The page: the types, then the built-ins."""
    public = {name: value for name, value in vars(language).items() if not name.startswith("_")}
    types = [kind for kind in public.values() if isinstance(kind, type) and is_type_of_the_language(kind)]
    builtins = [value for value in public.values() if isinstance(value, Function | Primitive)]
    parts = [
        HEAD,
        "## Types",
        *(directive("py:class", type_name(kind), prose(inspect.getdoc(kind))) for kind in types),
        *(directive("py:class", kind.__name__, f"Any of {alternatives(kind)}.") for kind in generics(builtins)),
        "## Built-in functions",
        *(described(value) for value in sorted(builtins, key=lambda value: value.name.lower())),
    ]
    return "\n\n".join(parts) + "\n"


def is_type_of_the_language(kind: type) -> bool:
    """Whether a parameter of a stage may have this type, or a special form of it."""
    return issubclass(kind, Vector) or kind in (language.mat3, language.mat4, language.Texture, language.Array)


def generics(builtins: Iterable[Function | Primitive]) -> list[TypeVar]:
    """The generic types of all signatures, each name once."""
    hints = [kind for value in builtins for kind in get_type_hints(definition(value)).values()]
    found = [each for kind in hints for each in (kind, *get_args(kind)) if isinstance(each, TypeVar)]
    return list({kind.__name__: kind for kind in found}.values())


def alternatives(kind: TypeVar) -> str:
    """The types that a generic one stands for; the same one throughout a call."""
    return ", ".join(f"`{type_name(each)}`" for each in kind.__constraints__) or "the types above"


def definition(value: Function | Primitive) -> Callable[..., Any]:
    """The Python function behind a built-in."""
    return value.python if isinstance(value, Function) else value.definition


def described(value: Function | Primitive) -> str:
    """A built-in."""
    python = definition(value)
    return directive("py:function", signature(value.name, python), prose(inspect.getdoc(python)))


def signature(name: str, python: Callable[..., Any]) -> str:
    """A call as it reads: name(a: type) -> type; a generic type as the types it stands for."""
    hints = {key: kind_name(kind) for key, kind in get_type_hints(python).items()}
    result = hints.pop("return")
    return f"{name}({', '.join(f'{key}: {kind}' for key, kind in hints.items())}) -> {result}"


def kind_name(kind: Any) -> str:
    """A type's name; of a type variable, its own."""
    if isinstance(kind, TypeVar):
        return kind.__name__
    arguments = [kind_name(each) for each in get_args(kind)]
    return f"{kind.__origin__.__name__}[{', '.join(arguments)}]" if arguments else type_name(kind)
