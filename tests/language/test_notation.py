"""A tree read back as source is the source it was made of."""

import ast
import inspect
import textwrap

import pytest
from one_stage import stages_by_module

from sss_ref.language import function, select, tree, vec3, vec4
from sss_ref.language.notation import written

STAGES = [stage for stages in stages_by_module().values() for stage in stages]


def functions_in(body):
    """Every function of the language that a body calls, with the body it has there."""
    for statement in body.statements:
        block = statement.block if isinstance(statement, tree.Loop) else (statement,)
        for assign in block:
            yield from calls_in(assign.value)
    for value in body.result.values.values():
        yield from calls_in(value)


def calls_in(expression):
    if isinstance(expression, tree.Call) and expression.body is not None:
        yield expression.callee.python, expression.body
        yield from functions_in(expression.body)
    for inner in tree.children(expression):
        yield from calls_in(inner)


def sources_of(python):
    """What a function assigns and returns, as Python itself writes it."""
    (definition,) = ast.parse(textwrap.dedent(inspect.getsource(python))).body
    for node in ast.walk(definition):
        if isinstance(node, ast.Assign):
            yield node.targets[0].id, ast.unparse(node.value)
    returned = definition.body[-1].value
    fields = returned.args if isinstance(returned, ast.Call) and returned.func.id[0].isupper() else [returned]
    yield from (("return", ast.unparse(field)) for field in fields)


def written_of(body):
    for statement in body.statements:
        for assign in statement.block if isinstance(statement, tree.Loop) else (statement,):
            yield assign.name, written(assign.value)
    yield from (("return", written(value)) for value in body.result.values.values())


@pytest.mark.parametrize("stage", STAGES, ids=lambda stage: stage.name)
def test_every_line_of_every_stage_and_of_what_it_calls(stage):
    for python, body in [(stage.python, stage.body), *functions_in(stage.body)]:
        assert set(written_of(body)) == {(name, as_python(text)) for name, text in sources_of(python)}, python.__name__


def as_python(text):
    """The source without parentheses that Python does not need, which `unparse` has dropped already."""
    return ast.unparse(ast.parse(text, mode="eval"))


@function
def grouped(a: float, b: float, c: vec4) -> vec3:
    """Every way of grouping that matters."""
    left = a + b + a * (b - (a - b))
    right = -(a * b) / (a / b) - -1.5
    both = (left < right) & ((a >= b) | (a == b))
    one = ((a < b) | both) & (both | (a != b) & (b == a))
    mixed = (a - b) * a / b + (a + b) / (a * b) - (-a) * (b / a)
    turned = (-c).xyz * -(a + b) - (-(a / b) + mixed)
    return select(one, c * (left * right), -c).xyz + turned


def test_parentheses_stand_where_the_order_needs_them():
    assert [text for _, text in written_of(grouped.body((float, float, vec4)))] == [
        "a + b + a * (b - (a - b))",
        "-(a * b) / (a / b) - -1.5",
        "(left < right) & ((a >= b) | (a == b))",
        "((a < b) | both) & (both | (a != b) & (b == a))",
        "(a - b) * a / b + (a + b) / (a * b) - -a * (b / a)",
        "(-c).xyz * -(a + b) - (-(a / b) + mixed)",
        "select(one, c * (left * right), -c).xyz + turned",
    ]
