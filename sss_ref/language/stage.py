"""`@function` and `@stage`: a Python function in the shader language, checked when it is defined.

A **function** takes and gives values and may be generic. A **stage** is the unit of validation: its parameters name
the buffers and uniforms it reads, the fields of the NamedTuple it returns are the buffers it writes. Both stay
callable as plain Python, which is how array code runs them.
"""

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, update_wrapper, wraps
from typing import Any, TypeVar, cast, get_type_hints

import numpy as np

from sss_ref.errors import StageError
from sss_ref.language import tree
from sss_ref.language.evaluation import run_body
from sss_ref.language.front_end import body_of
from sss_ref.language.typing_rules import call_type, is_type, type_name

F = TypeVar("F", bound=Callable[..., Any])


class Function:
    """A function of the language; `body(types)` is its tree for given argument types."""

    def __init__(self, python: Callable[..., Any]) -> None:
        self.python = python
        self._bodies: dict[tuple[Any, ...], tree.Body] = {}
        update_wrapper(self, python)

    def __call__(self, *arguments: Any) -> Any:
        """Run the function as plain Python."""
        return self.python(*arguments)

    @property
    def name(self) -> str:
        """The function's name, as in GLSL."""
        return self.python.__name__

    @cached_property
    def _hints(self) -> dict[str, Any]:
        return get_type_hints(self.python)

    def result_type(self, types: list[Any]) -> Any:
        """What a call with these argument types gives, or None where they do not fit the signature."""
        return call_type(self._hints, types)

    def body(self, types: tuple[Any, ...]) -> tree.Body:
        """The tree for these argument types, which must fit."""
        if types not in self._bodies:
            names = [name for name in self._hints if name != "return"]
            outputs = {"return": self.result_type(list(types))}
            self._bodies[types] = body_of(self.python, dict(zip(names, types, strict=True)), outputs)
        return self._bodies[types]


def function(python: F) -> F:
    """Make a Python function one of the language (decorator)."""
    return cast(F, Function(python))


@dataclass(frozen=True)
class Stage:
    """A stage and the buffers it is bound to; `reads` and `writes` map its own names to those of the pass.

    variant: of a stage that was made from another one, by `parallel_rays`: what its name has behind that one's, and a
    sentence for its description. Its body is what it computes then.
    """

    python: Callable[..., Any]
    source: str
    body: tree.Body
    outputs: Mapping[str, Any]
    reads: Mapping[str, str]
    writes: Mapping[str, str]
    variant: tuple[str, str] = ("", "")

    def __call__(self, *arguments: Any) -> Any:
        """Run the stage as plain Python, on scalars or on arrays of fragments."""
        if not self.variant[0]:
            return self.python(*arguments)
        return self.result_struct(**run_body(self.body, dict(zip(self.parameters, arguments, strict=True))))

    def run(self, inputs: Sequence[Any]) -> dict[str, Any]:
        """Run the stage as plain Python: buffer -> value. inputs: one value per parameter, in order; no warnings."""
        with np.errstate(all="ignore"):
            return dict(zip(self.writes.values(), self(*inputs), strict=True))

    @property
    def name(self) -> str:
        """The stage's name, by which a report calls it."""
        return self.python.__name__ + self.variant[0]

    @property
    def description(self) -> str:
        """The stage in words: what it is, and what it computes."""
        return "\n".join(filter(None, (inspect.getdoc(self.python), self.variant[1])))

    @property
    def result_struct(self) -> Any:
        """The NamedTuple that it returns."""
        return get_type_hints(self.python)["return"]

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Parameter name -> type, in order."""
        return self.body.parameters

    def bound(self, **names: str) -> "Stage":
        """The same stage with some of its own names bound to others, as clip_from_model="light_clip_from_model"."""
        unknown = set(names) - set(self.reads) - set(self.writes)
        if unknown:
            raise StageError(f"stage {self.name} has no parameter or output `{min(unknown)}` to bind")
        reads = {own: names.get(own, name) for own, name in self.reads.items()}
        return replace(self, reads=reads, writes={own: names.get(own, name) for own, name in self.writes.items()})

    def retyped(self, **kinds: Any) -> "Stage":
        """The same stage with other types of some of its own names, as x=vec3: its source is read again with these.

        Where an operation works component by component, each component is computed as the stage computes a number.
        Raises StageError where the source does not allow it.
        """
        own = {**self.parameters, **self.outputs}
        if unknown := set(kinds) - set(own):
            raise StageError(f"stage {self.name} has no parameter or output `{min(unknown)}` to give another type")
        changed = own | kinds
        parameters, outputs = ({name: changed[name] for name in names} for names in (self.parameters, self.outputs))
        return replace(self, body=_body(self.python, (*parameters.items(),), (*outputs.items(),)), outputs=outputs)

    def with_body(self, body: tree.Body) -> "Stage":
        """A stage of this name and these buffers that computes another body, in every interpreter."""
        struct = self.result_struct

        def run(*arguments: Any) -> Any:
            return struct(**run_body(body, dict(zip(body.parameters, arguments, strict=True))))

        return replace(self, python=wraps(self.python)(run), body=body)

    def renamed(self, rename: Callable[[str], str]) -> "Stage":
        """The same stage with every name that a pass sees replaced."""
        reads = {own: rename(name) for own, name in self.reads.items()}
        return replace(self, reads=reads, writes={own: rename(name) for own, name in self.writes.items()})


def stage(source: str) -> Callable[[Callable[..., Any]], Stage]:
    """Make a Python function a stage (decorator); `source` says where its equation stands: "paper 3.2".

    Raises StageError, with file and line, where the function is not in the language.
    """

    def define(python: Callable[..., Any]) -> Stage:
        hints = get_type_hints(python)
        outputs = get_type_hints(hints.pop("return", None) or (lambda: None))
        for name, kind in [*hints.items(), *outputs.items()]:
            if not is_type(kind):
                raise StageError(f"{_place(python)}: `{name}` has type {type_name(kind)}, which no shader has")
        if not outputs:
            raise StageError(f"{_place(python)}: a stage returns a NamedTuple whose fields are the buffers it writes")
        body = body_of(python, hints, outputs)
        names = {name: name for name in hints}
        return Stage(python, source, body, outputs, names, {name: name for name in outputs})

    return define


@cache
def _body(
    python: Callable[..., Any], parameters: tuple[tuple[str, Any], ...], outputs: tuple[tuple[str, Any], ...]
) -> tree.Body:
    """The tree of a stage for these types, read once."""
    return body_of(python, dict(parameters), dict(outputs))


def _place(python: Callable[..., Any]) -> str:
    return f"{python.__code__.co_filename}:{python.__code__.co_firstlineno}: in {python.__name__}"
