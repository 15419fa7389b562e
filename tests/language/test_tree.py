"""The parts of a tree: which are inside an expression, and an expression with one of them replaced."""

import pytest

from sss_ref.language import Array, Texture, ivec2, texel, vec2, vec3
from sss_ref.language.tree import Call, Construct, Element, Literal, Member, Operation, Variable, children, with_child

X, Y, ROW = Variable(float, "x"), Variable(float, "y"), Variable(Array[float], "row")
MADE = [
    Member(float, Variable(vec2, "v"), "x"),
    Operation(float, "neg", (X,)),
    Operation(float, "-", (X, Y)),
    Construct(vec3, (X, Y, Literal(float, 2.0))),
    Element(float, ROW, Variable(int, "k")),
    Call(float, texel, (Variable(Texture[float], "map"), Variable(ivec2, "at"))),
]


@pytest.mark.parametrize("expression", MADE, ids=lambda each: type(each).__name__)
def test_each_part_can_be_replaced_and_the_others_stay(expression):
    parts = children(expression)
    for k, part in enumerate(parts):
        other = Variable(part.type, "other")
        found = with_child(expression, k, other)
        assert children(found) == (*parts[:k], other, *parts[k + 1 :])
        assert type(found) is type(expression) and with_child(found, k, part) == expression


def test_names_and_numbers_have_no_parts():
    assert children(X) == children(Literal(int, 3)) == ()
