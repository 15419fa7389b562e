"""Which types the language's operators, constructors and generic parameters accept, and what they give."""

from typing import Any, TypeVar, get_args, get_origin

from sss_ref.language.types import Array, Texture, Vector, ivec2, mat3, mat4, vec2, vec3, vec4

SCALARS = (float, int, bool)
FLOAT_VECTORS = (vec2, vec3, vec4)
MEMBERS = {vec2: ("x", "y"), ivec2: ("x", "y"), vec3: ("x", "y", "z"), vec4: ("x", "y", "z", "w", "xy", "xyz")}
ORDER = ("<", "<=", ">", ">=")
EQUALITY = ("==", "!=")


def type_name(kind: Any) -> str:
    """How a type reads in a message: float, vec3, Texture[vec3]."""
    if get_origin(kind):
        return f"{get_origin(kind).__name__}[{', '.join(map(type_name, get_args(kind)))}]"
    return getattr(kind, "__name__", str(kind))


def is_type(kind: Any) -> bool:
    """Whether a stage may have a parameter or output of this type."""
    if get_origin(kind) in (Texture, Array):
        return get_args(kind)[0] in (*SCALARS, *FLOAT_VECTORS)
    return kind in (*SCALARS, *FLOAT_VECTORS, ivec2, mat3, mat4)


def operation_type(operator: str, left: Any, right: Any) -> Any:
    """The type of `left operator right`, or None where GLSL has none."""
    if operator in ("&", "|"):
        return bool if left is right is bool else None
    if operator in ORDER + EQUALITY:
        return bool if left is right and left in (float, int) else None
    if operator == "*" and (left, right) in ((mat3, vec3), (mat4, vec4)):
        return right
    if left is right and left in (float, *FLOAT_VECTORS):
        return left
    if left is right and left in (int, ivec2):
        return left if operator != "/" else None
    if left in FLOAT_VECTORS and right is float:
        return left
    return right if left is float and right in FLOAT_VECTORS else None


def element_type(vector: Any) -> Any:
    """The type of one component."""
    return int if vector is ivec2 else float


def construct_error(kind: Any, parts: list[Any]) -> str | None:
    """Why a vector cannot be made of these parts, or None."""
    wanted = element_type(kind)
    count = 0
    for part in parts:
        vector = isinstance(part, type) and issubclass(part, Vector)
        if (element_type(part) if vector else part) is not wanted:
            return f"{type_name(kind)} takes {type_name(wanted)} components, got {type_name(part)}"
        count += part.count if vector else 1
    return None if count == kind.count else f"{type_name(kind)} takes {kind.count} components, got {count}"


def bind(parameter: Any, argument: Any, bound: dict[Any, Any]) -> bool:
    """Match an argument type with a parameter type, binding type variables; a float may stand beside a vector."""
    if isinstance(parameter, TypeVar):
        known = bound.get(parameter)
        if known in (None, argument) or (known is float and argument in FLOAT_VECTORS):
            bound[parameter] = argument
            return not parameter.__constraints__ or argument in parameter.__constraints__
        return argument is float and known in FLOAT_VECTORS
    if get_origin(parameter) in (Texture, Array):
        same = get_origin(parameter) is get_origin(argument)
        return same and bind(get_args(parameter)[0], get_args(argument)[0], bound)
    return parameter is argument


def call_type(hints: dict[str, Any], types: list[Any]) -> Any:
    """What a call with these argument types gives under a signature, or None where they do not fit it."""
    parameters = [kind for name, kind in hints.items() if name != "return"]
    bound: dict[Any, Any] = {}
    fits = len(parameters) == len(types) and all(map(lambda p, t: bind(p, t, bound), parameters, types))
    result = hints["return"]
    return (bound[result] if isinstance(result, TypeVar) else result) if fits else None
