"""What the keys of a table mean: the texts that stand below its fields, read from the source when somebody asks."""

import ast
import inspect
from collections.abc import Iterator
from functools import cache
from itertools import pairwise

from sss_ref.scene_file.quantities import Table


@cache
def key_texts(model: type[Table]) -> dict[str, str]:
    """Key -> what it means, of a table and of those it inherits from; "" of a key without a text."""
    tables = (each for each in reversed(model.__mro__) if issubclass(each, Table))
    texts = {key: text for table in tables for key, text in _texts_below(table)}
    return {key: texts.get(key, "") for key in model.model_fields}


def _texts_below(table: type[Table]) -> Iterator[tuple[str, str]]:
    (definition,) = ast.parse(inspect.getsource(table)).body
    assert isinstance(definition, ast.ClassDef)
    for statement, after in pairwise(definition.body):
        match statement, after:
            case ast.AnnAssign(target=ast.Name(id=key)), ast.Expr(value=ast.Constant(value=str(text))):
                yield key, inspect.cleandoc(text)
