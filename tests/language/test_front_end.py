"""What the language accepts, and the line and rule it names for what it does not."""

import inspect
from typing import NamedTuple

import numpy as np
import pytest

from sss_ref.errors import StageError
from sss_ref.language import (
    Array,
    Texture,
    dot,
    function,
    ivec2,
    mat4,
    max,
    select,
    stage,
    texel,
    tree,
    vec2,
    vec3,
    vec4,
)


class Value(NamedTuple):
    value: float


class Two(NamedTuple):
    first: vec3
    second: bool


HALF_EXACT = np.float32(0.1)


@stage(source="test")
def good(position: vec3, scale: float) -> Two:
    """A stage with two outputs."""
    longer = position * scale + 0.5
    return Two(longer, dot(longer, longer) > HALF_EXACT)


def test_signature_is_the_contract():
    assert good.name == "good"
    assert dict(good.parameters) == {"position": vec3, "scale": float}
    assert dict(good.outputs) == {"first": vec3, "second": bool}
    assert good.source == "test"


def test_tree_is_typed_statement_by_statement():
    (assign,) = good.body.statements
    assert (assign.name, assign.value.type) == ("longer", vec3)
    comparison = good.body.result.values["second"]
    assert (comparison.type, comparison.operator) == (bool, ">")
    assert comparison.operands[1] == tree.Constant(float, "HALF_EXACT", float(np.float32(0.1)))


def test_generic_function_has_a_body_for_each_type():
    call = good.body.result.values["second"].operands[0]
    assert call.callee.name == "dot" and call.type is float
    assert list(call.body.parameters.values()) == [vec3, vec3]


def test_bound_renames_what_a_pass_sees_only():
    bound = good.bound(scale="light_scale", first="light_first")
    assert dict(bound.reads) == {"position": "position", "scale": "light_scale"}
    assert dict(bound.writes) == {"first": "light_first", "second": "second"}
    assert dict(good.reads)["scale"] == "scale"
    with pytest.raises(StageError, match="no parameter or output `colour`"):
        good.bound(colour="x")


# Each of these is rejected; the comment marks the line that the message must name.


def inexact_literal(x: float) -> Value:
    y = x + 1.0
    return Value(y * 0.1)  # here


def branch(x: float) -> Value:
    y = x
    if x > 0.0:  # here
        y = -x
    return Value(y)


def ternary(x: float) -> Value:
    return Value(x if x > 0.0 else -x)  # here


def assigned_twice(x: float) -> Value:
    y = x + 1.0
    y = y + 1.0  # here
    return Value(y)


def augmented(x: float) -> Value:
    y = x + 1.0
    y += 1.0  # here
    return Value(y)


def unknown_name(x: float) -> Value:
    return Value(x + missing)  # here  # noqa: F821


def outside_function(x: float) -> Value:
    return Value(np.sqrt(x))  # here


def not_of_the_language(x: float) -> Value:
    return Value(abs(x))  # here


def mixed_types(x: float, n: int) -> Value:
    return Value(x * n)  # here


def wrong_result(x: vec3) -> Value:
    return Value(x + 1.0)  # here


def wrong_argument(x: float) -> Value:
    return Value(dot(x, x))  # here


def no_component(x: vec2) -> Value:
    return Value(x.z)  # here


def wrong_parts(x: vec3) -> Value:
    y = vec4(x)  # here
    return Value(y.w)


def two_literals(x: float) -> Value:
    return Value(x * (1.0 / 4.0))  # here


def boolean_words(x: float) -> Value:
    return Value(select(x > 0.0 and x < 1.0, x, 0.0))  # here


def while_loop(x: float) -> Value:
    while x > 0.0:  # here
        pass
    return Value(x)


def loop_over_list(x: float) -> Value:
    total = x
    for y in (x, x):  # here
        total = total + y
    return Value(total)


def loop_loses_the_sum(x: float, n: int) -> Value:
    total = x
    for _i in range(0, n):
        total = x + 1.0  # here
    return Value(total)


def no_final_return(x: float) -> Value:  # here
    y = x  # noqa: F841


def unread_parameter(x: float, y: float) -> Value:  # here
    return Value(x)


def indexed_vector(x: vec3) -> Value:
    return Value(x[0])  # here


def matrix_of_wrong_size(m: mat4, x: vec3) -> Value:
    y = m * x  # here
    return Value(y.x)


def texture_by_float(t: Texture[float], at: vec2) -> Value:
    return Value(texel(t, at))  # here


def two_targets(x: float) -> Value:
    y = z = x  # here
    return Value(y + z)


def a_member_assigned(x: vec2) -> Value:
    x.y = x.x  # here
    return Value(x.y)


def loop_up_to(x: float, n: int) -> Value:
    total = x
    for _i in range(n):  # here
        total = total + x
    return Value(total)


def loop_in_steps(x: float, n: int) -> Value:
    total = x
    for _i in range(0, n, 2):  # here
        total = total + x
    return Value(total)


def loop_of_two(x: float, n: int) -> Value:
    total = x
    for _i in zip(n, n):  # here  # noqa: B905
        total = total + x
    return Value(total)


def loop_with_an_end(x: float, n: int) -> Value:
    total = x
    for _i in range(0, n):  # here
        total = total + x
    else:
        total = total + 1.0
    return Value(total)


def loop_of_pairs(x: float, n: int) -> Value:
    total = x
    for _i, _j in range(0, n):  # here
        total = total + x
    return Value(total)


def loop_to_a_float(x: float) -> Value:
    total = x
    for _i in range(0, x):  # here
        total = total + x
    return Value(total)


def sum_of_another_type(x: float, n: int, v: vec3) -> Value:
    total = x
    for _i in range(0, n):
        total = total * v  # here
    return Value(total)


def not_returned_as_fields(x: float) -> Value:
    return x  # here


def a_field_too_many(x: float) -> Value:
    return Value(x, x)  # here


def minus_a_truth_value(x: float) -> Value:
    return Value(select(-(x > 0.0), x, 0.0))  # here


def minus_a_matrix(m: mat4, x: vec4) -> Value:
    y = -m * x  # here
    return Value(y.x)


def a_word(x: float) -> Value:
    return Value(x + "half")  # here


def element_of_a_constant(x: float) -> Value:
    return Value(x * HALF_EXACT[0])  # here


def element_at_a_float(x: Array[float], at: float) -> Value:
    return Value(x[at])  # here


def power_by_an_operator(x: float) -> Value:
    return Value(x**x)  # here


def a_chain(x: float) -> Value:
    return Value(select(0.0 < x < 1.0, x, 0.0))  # here


def a_keyword(x: float) -> Value:
    return Value(dot(a=x, b=x))  # here


REJECTED = {
    two_targets: "only `name = expression`, the loop and the final return are statements",
    a_member_assigned: "only `name = expression`, the loop and the final return are statements",
    loop_up_to: r"the only loop is `for i in range\(start, stop\)`",
    loop_in_steps: r"the only loop is `for i in range\(start, stop\)`",
    loop_of_two: r"the only loop is `for i in range\(start, stop\)`",
    loop_with_an_end: r"the only loop is `for i in range\(start, stop\)`",
    loop_of_pairs: r"the only loop is `for i in range\(start, stop\)`",
    loop_to_a_float: "expected int, got float",
    sum_of_another_type: "`total` is float, not vec3",
    not_returned_as_fields: "return the output type with its 1 fields in order",
    a_field_too_many: "return the output type with its 1 fields in order",
    minus_a_truth_value: "no minus for bool",
    minus_a_matrix: "no minus for mat4",
    a_word: "literal 'half' is neither a number nor a truth value",
    element_of_a_constant: "`HALF_EXACT` is float: only a uniform Array has elements",
    element_at_a_float: "expected int, got float",
    power_by_an_operator: r"operator of `x \*\* x` is not in the language",
    a_chain: "`0.0 < x < 1.0` is not in the language",
    a_keyword: r"`dot\(a=x, b=x\)` is not in the language",
    inexact_literal: "literal 0.1 is not exact in float32",
    branch: r"no branches: compute both sides and choose with select",
    ternary: r"no branches: choose with select",
    assigned_twice: "`y` is assigned twice",
    augmented: "write the sum out",
    unknown_name: "`missing` is neither a parameter, a local value, nor a constant",
    outside_function: "not in the language",
    not_of_the_language: "`abs` is neither a built-in nor a function of the language",
    mixed_types: r"no `\*` between float and int",
    wrong_result: "expected float, got vec3",
    wrong_argument: r"`dot` does not take \(float, float\)",
    no_component: "vec2 has no component `z`",
    wrong_parts: "vec4 takes 4 components, got 3",
    two_literals: "two literals: Python would compute it in float64",
    boolean_words: "write & and |",
    while_loop: "the only loop",
    loop_over_list: "the only loop",
    loop_loses_the_sum: "`total` is assigned twice",
    no_final_return: "the last statement must be the one `return`",
    unread_parameter: "parameter `y` is never read",
    indexed_vector: "only a uniform Array has elements",
    matrix_of_wrong_size: r"no `\*` between mat4 and vec3",
    texture_by_float: r"`texel` does not take \(Texture\[float\], vec2\)",
}


@pytest.mark.parametrize("python", REJECTED, ids=lambda python: python.__name__)
def test_rejected_with_file_line_and_rule(python):
    source, first = inspect.getsourcelines(python)
    line = first + next(k for k, text in enumerate(source) if "# here" in text)
    with pytest.raises(StageError, match=REJECTED[python]) as raised:
        stage(source="test")(python)
    assert f"{__file__}:{line}: in {python.__name__}" in str(raised.value)


def test_a_stage_returns_named_outputs():
    def unnamed(x: float) -> float:
        return x

    with pytest.raises(StageError, match="a stage returns a NamedTuple"):
        stage(source="test")(unnamed)


def test_a_parameter_has_a_shader_type():
    def texty(x: str) -> Value:
        return Value(x)

    with pytest.raises(StageError, match="`x` has type str, which no shader has"):
        stage(source="test")(texty)


def test_an_error_inside_a_function_names_the_function():
    @function
    def halved(x: float) -> float:
        return x * 0.3

    def calls(x: float) -> Value:
        return Value(halved(x))

    with pytest.raises(StageError, match=r"in halved: literal 0\.3"):
        stage(source="test")(calls)


def test_a_scalar_may_stand_beside_a_vector_in_a_built_in():
    @stage(source="test")
    def positive(x: vec3) -> Two:
        return Two(max(x, 0.0), x.x > 0.0)

    assert positive.body.result.values["first"].type is vec3


def test_constructor_takes_vectors_apart():
    @stage(source="test")
    def built(x: vec3, at: ivec2, t: Texture[float]) -> Value:
        whole = vec4(x, texel(t, at))
        return Value(whole.w)

    assert built.body.statements[0].value.type is vec4


def test_a_minus_before_a_number_is_of_the_number():
    @stage(source="test")
    def shifted(x: float) -> Value:
        return Value(x + -1.5)

    _, number = shifted.body.result.values["value"].operands
    assert (number.type, number.value) == (float, -1.5)


def test_letters_of_a_vector_are_a_number_or_a_shorter_vector():
    @stage(source="test")
    def parts(x: vec4, at: ivec2, y: float) -> Two:
        pair = x.xy
        three = x.xyz
        column = at.x
        one = select(column > 0, three.z, pair.y)
        return Two(three, one > y)

    assert [each.value.type for each in parts.body.statements] == [vec2, vec3, int, float]
