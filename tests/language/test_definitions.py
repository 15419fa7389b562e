import ast
import inspect
import textwrap
from functools import wraps

import pytest

from sss_ref.errors import StageError
from sss_ref.language.definitions import FILES_KEPT, definition_of
from sss_ref.passes import shadow_map


def same(function):
    return function


@same
def plain(x):
    text = """
def plain(x):  # a text, and no function
"""
    return text, x


if __name__:

    @same
    @wraps(
        plain,
        updated=(),
    )
    def in_a_block(x):
        return x


try:
    raise KeyError
except KeyError:

    def in_a_handler(x):
        return x  # a bracket of its own line follows


class Holder:
    def method(self):
        def inside():
            return self

        return inside


FUNCTIONS = [plain, in_a_handler, Holder.method, Holder().method(), definition_of, shadow_map.back_point.python]


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)
def test_it_is_what_the_standard_library_finds_word_by_word(function):
    lines, first = inspect.getsourcelines(function)
    expected = ast.parse(textwrap.dedent("".join(lines))).body[0]
    found = definition_of(function)
    assert ast.dump(found) == ast.dump(expected)
    assert found.lineno == first + expected.lineno - 1


def test_what_wraps_a_function_is_defined_where_that_is():
    assert definition_of(in_a_block) is definition_of(plain)
    del in_a_block.__wrapped__
    assert definition_of(in_a_block).name == "in_a_block"


def test_a_file_that_has_changed_is_read_anew(tmp_path):
    path = tmp_path / "changed.py"
    for number in range(FILES_KEPT + 2):
        path.write_text("\n" * number + f"def f(x):\n    return {number} * x\n")
        scope = {}
        exec(compile(path.read_text(), path, "exec"), scope)
        assert ast.unparse(definition_of(scope["f"])) == f"def f(x):\n    return {number} * x"


def test_without_a_source_it_says_what_to_do():
    scope = {}
    exec("def f(x):\n    return x", scope)
    with pytest.raises(StageError, match=r"<string>:1: in f: expected a function whose source is in a file, got none"):
        definition_of(scope["f"])
