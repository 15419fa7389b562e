"""A function's definition as a syntax tree: its file is parsed as a whole, once for all functions that are in it.

`inspect` reads a function word by word to find its end, which takes as long as all else that a stage needs.
"""

import ast
import inspect
import linecache
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import Any

from sss_ref.errors import StageError

FILES_KEPT = 8  # a tree takes some hundred times the memory of its source


def definition_of(function: Callable[..., Any]) -> ast.FunctionDef:
    """The definition of a function, with the lines of its file. Raises StageError where nobody knows its source."""
    code = inspect.unwrap(function).__code__
    linecache.checkcache(code.co_filename)
    lines = linecache.getlines(code.co_filename, function.__globals__)
    found = _definitions("".join(lines)).get(code.co_firstlineno)
    if found is None:
        where = f"{code.co_filename}:{code.co_firstlineno}: in {code.co_name}"
        raise StageError(f"{where}: expected a function whose source is in a file, got none there; define it in a file")
    return found


@lru_cache(FILES_KEPT)
def _definitions(source: str) -> dict[int, ast.FunctionDef]:
    """First line, that of a decorator if it has any -> every function that a source defines."""
    functions = _functions(ast.parse(source))
    return {min([each.lineno, *(line.lineno for line in each.decorator_list)]): each for each in functions}


def _functions(node: ast.AST) -> Iterator[ast.FunctionDef]:
    """All functions in a module or a statement, those inside others too."""
    if isinstance(node, ast.FunctionDef):
        yield node
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, ast.stmt | ast.excepthandler):
            yield from _functions(inner)
