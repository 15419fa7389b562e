"""Which operators, constructors and calls there are: those of GLSL 4.60 (5.4, 5.9, 8), but for what is left out.

Left out are matrices but for one that acts on a column, `/` of integers, and comparisons of anything but numbers.
"""

from typing import TypeVar

import pytest

from sss_ref.language import Array, Texture, ivec2, mat3, mat4, vec2, vec3, vec4
from sss_ref.language.typing_rules import call_type, construct_error, is_type, operation_type, type_name

TYPES = (float, int, bool, vec2, vec3, vec4, ivec2, mat3, mat4)
ARITHMETIC = {
    **{(kind, kind): kind for kind in (float, int, vec2, vec3, vec4, ivec2)},
    **{(kind, float): kind for kind in (vec2, vec3, vec4)},
    **{(float, kind): kind for kind in (vec2, vec3, vec4)},
}
COMPARED = {(float, float): bool, (int, int): bool}
OPERATIONS = {
    **dict.fromkeys(("+", "-"), ARITHMETIC),
    "*": {**ARITHMETIC, (mat3, vec3): vec3, (mat4, vec4): vec4},
    "/": {pair: kind for pair, kind in ARITHMETIC.items() if kind not in (int, ivec2)},
    **dict.fromkeys(("<", "<=", ">", ">=", "==", "!="), COMPARED),
    "&": {(bool, bool): bool},
    "|": {(bool, bool): bool},
}


@pytest.mark.parametrize("operator", OPERATIONS)
def test_every_operator_between_any_two_types(operator):
    for left in TYPES:
        for right in TYPES:
            found = operation_type(operator, left, right)
            assert found is OPERATIONS[operator].get((left, right)), (left, operator, right)


@pytest.mark.parametrize(
    ("kind", "parts", "error"),
    [
        (vec2, (float, float), None),
        (vec3, (vec2, float), None),
        (vec3, (float, vec2), None),
        (vec4, (vec2, vec2), None),
        (vec4, (vec3, float), None),
        (vec4, (float, float, float, float), None),
        (ivec2, (int, int), None),
        (ivec2, (ivec2,), None),
        (vec2, (float,), "vec2 takes 2 components, got 1"),
        (vec2, (), "vec2 takes 2 components, got 0"),
        (vec3, (vec2, vec2), "vec3 takes 3 components, got 4"),
        (vec4, (vec3, vec3), "vec4 takes 4 components, got 6"),
        (vec2, (float, int), "vec2 takes float components, got int"),
        (vec2, (ivec2,), "vec2 takes float components, got ivec2"),
        (ivec2, (vec2,), "ivec2 takes int components, got vec2"),
        (ivec2, (int, float), "ivec2 takes int components, got float"),
        (vec3, (bool, float, float), "vec3 takes float components, got bool"),
        (vec3, (mat3,), "vec3 takes float components, got mat3"),
    ],
)
def test_of_which_parts_a_vector_is_made(kind, parts, error):
    assert construct_error(kind, list(parts)) == error


Any_ = TypeVar("Any_")
FloatOrVector = TypeVar("FloatOrVector", float, vec2, vec3)
TWO = {"a": FloatOrVector, "b": FloatOrVector, "return": FloatOrVector}
FETCH = {"texture": Texture[Any_], "at": ivec2, "return": Any_}
CHOICE = {"condition": bool, "a": FloatOrVector, "b": FloatOrVector, "return": FloatOrVector}


@pytest.mark.parametrize(
    ("hints", "types", "result"),
    [
        (TWO, (float, float), float),
        (TWO, (vec3, vec3), vec3),
        (TWO, (vec3, float), vec3),
        (TWO, (float, vec3), vec3),
        (TWO, (vec3, vec2), None),
        (TWO, (vec2, vec3), None),
        (TWO, (vec4, vec4), None),
        (TWO, (float, int), None),
        (TWO, (int, int), None),
        (TWO, (float,), None),
        (TWO, (float, float, float), None),
        (CHOICE, (bool, vec3, float), vec3),
        (CHOICE, (float, vec3, vec3), None),
        (FETCH, (Texture[vec3], ivec2), vec3),
        (FETCH, (Texture[bool], ivec2), bool),
        (FETCH, (Texture[vec3], vec2), None),
        (FETCH, (Array[vec3], ivec2), None),
        (FETCH, (vec3, ivec2), None),
        ({"texture": Texture[FloatOrVector], "return": float}, (Texture[int],), None),
        ({"a": float, "return": bool}, (float,), bool),
        ({"a": float, "return": bool}, (int,), None),
        ({"return": int}, (), int),
    ],
)
def test_what_a_call_gives(hints, types, result):
    assert call_type(hints, list(types)) is result


@pytest.mark.parametrize("kind", [*TYPES, Texture[vec3], Texture[bool], Array[float], Array[vec4]])
def test_a_stage_may_read_it(kind):
    assert is_type(kind)


@pytest.mark.parametrize(
    "kind", [str, list, Texture[ivec2], Texture[mat3], Array[mat4], Texture[str], list[float], None]
)
def test_a_stage_may_not_read_it(kind):
    assert not is_type(kind)


def test_types_read_in_a_message_as_they_are_written():
    kinds = (float, vec3, Texture[vec3], Array[Texture[int]])
    assert [type_name(kind) for kind in kinds] == ["float", "vec3", "Texture[vec3]", "Array[Texture[int]]"]
