"""The primitives of the shader language, named as in GLSL, and what they mean for NumPy arrays and float32 scalars.

A primitive is what an interpreter must know by itself; all other built-ins are written in the language (builtins.py).
"""

# mypy: disable-error-code="return-value, call-overload, operator, arg-type, no-any-return"
# The annotations are the types of the language; the values are NumPy's.

import builtins
from collections.abc import Callable
from functools import cached_property, update_wrapper
from typing import Any, TypeVar, cast, get_type_hints

import numpy as np

from sss_ref.language.types import Texture, Vector, ivec2, vec2, vec3, vec4
from sss_ref.language.typing_rules import call_type
from sss_ref.numerics import elementary

genType = TypeVar("genType", float, vec2, vec3, vec4)
number = TypeVar("number", int, float, bool, vec2, vec3, vec4, ivec2)
T = TypeVar("T")
F = TypeVar("F", bound=Callable[..., Any])


class Primitive:
    """A built-in with a meaning of its own in each interpreter; called, it computes with NumPy."""

    def __init__(self, definition: Callable[..., Any], by_component: bool) -> None:
        self.definition = definition
        self.name = definition.__name__
        self.by_component = by_component
        update_wrapper(self, definition)

    def __call__(self, *arguments: Any) -> Any:
        """Compute with NumPy, component by component where a vector is among the arguments."""
        vector = next((a for a in arguments if isinstance(a, Vector)), None)
        if vector is None or not self.by_component:
            return self.definition(*map(_typed, arguments))
        columns = [list(a) if isinstance(a, Vector) else [a] * vector.count for a in arguments]
        return type(vector)(*(self.definition(*map(_typed, row)) for row in zip(*columns, strict=True)))

    @cached_property
    def _hints(self) -> dict[str, Any]:
        return get_type_hints(self.definition)

    def result_type(self, types: list[Any]) -> Any:
        """What a call with these argument types gives, or None where they do not fit the signature."""
        return call_type(self._hints, types)

    def body(self, types: tuple[Any, ...]) -> None:
        """A primitive has no body."""


def _typed(argument: Any) -> Any:
    """A literal of a stage is a Python float; as an argument of NumPy it must already be float32."""
    return np.float32(argument) if isinstance(argument, builtins.float) else argument


def by_component(definition: F) -> F:
    """Make a primitive that works component by component; a scalar beside a vector serves every component."""
    return cast(F, Primitive(definition, by_component=True))


def whole(definition: F) -> F:
    """Make a primitive that takes its arguments whole."""
    return cast(F, Primitive(definition, by_component=False))


@by_component
def sqrt(x: genType) -> genType:
    """Square root, correctly rounded (IEEE); x >= 0."""
    return np.sqrt(x)


@by_component
def floor(x: genType) -> genType:
    """Largest whole number <= x, as a float."""
    return np.floor(x)


@by_component
def min(x: number, y: number) -> number:
    """y < x ? y : x (rule A1: decides which zero, and what NaN gives)."""
    return np.where(y < x, y, x)[()]


@by_component
def max(x: number, y: number) -> number:
    """x < y ? y : x (rule A1)."""
    return np.where(x < y, y, x)[()]


@by_component
def pow(x: genType, y: genType) -> genType:
    """x to the power y, correctly rounded (rule A2); x >= 0."""
    return elementary.pow_array(x, y)


@by_component
def exp(x: genType) -> genType:
    """e to the power x, correctly rounded (rule A2)."""
    return elementary.exp_array(x)


@by_component
def exp2(x: genType) -> genType:
    """2 to the power x, correctly rounded (rule A2)."""
    return elementary.exp2_array(x)


@by_component
def log2(x: genType) -> genType:
    """Logarithm to base 2, correctly rounded (rule A2); x > 0."""
    return elementary.log2_array(x)


@by_component
def select(condition: bool, if_true: number, if_false: number) -> number:
    """GLSL's condition ? if_true : if_false, the language's only choice; array code computes both sides."""
    return np.where(condition, if_true, if_false)[()]


@by_component
def float32(i: int) -> float:
    """GLSL float(i): the float nearest to an integer."""
    return np.float32(i)


@by_component
def int32(x: float) -> int:
    """GLSL int(x): towards zero; |x| < 2^31."""
    return np.int32(x)


@whole
def texel(texture: Texture[T], at: ivec2) -> T:
    """GLSL texelFetch: the stored value at (column, row), which must lie inside the texture."""
    return texture.fetch(at)


@whole
def size(texture: Texture[T]) -> ivec2:
    """GLSL textureSize: (width, height) in texels."""
    height, width = texture.data.shape[:2]
    return ivec2(np.int32(width), np.int32(height))
