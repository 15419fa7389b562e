"""From the docstrings' own form, `name: what it is`, to the fields that Sphinx shows as a list of parameters."""

import ast
import inspect
import re
import textwrap
from collections.abc import Collection, Iterator
from typing import Any

SPECIAL = re.compile(r"(`[^`]*`)|([*|\\])")  # code, or a character that means something in reStructuredText


def with_fields(docstring: str, names: Collection[str], kind: str = "param") -> str:
    """A docstring as reStructuredText, with what it says of its arguments as fields.

    names: the arguments, or the attributes of a class, whose kind of field is "ivar". Their explanations stand at the
    beginning of a line or of a sentence, for one argument or for several, `a, b: text`, and end where the next begins,
    or a sentence about what is raised.
    """
    listed = "|".join(sorted(map(re.escape, names), key=len, reverse=True)) or r"(?!)"
    start = re.compile(rf"(?:\A|(?<=\n)|(?<=\. ))(?:((?:{listed})(?:, (?:{listed}))*): |(?=Raises ))")
    return "\n\n".join("\n".join(_blocks(start.split(each), kind)) for each in docstring.strip().split("\n\n"))


def comments(fields: Any) -> dict[str, str]:
    """The comment beside each field of a NamedTuple or dataclass that has one."""
    source = textwrap.dedent(inspect.getsource(fields))
    lines = source.splitlines()
    found = {
        node.target.id: lines[node.lineno - 1].partition("#")[2].strip()
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)
    }
    return {name: text for name, text in found.items() if text}


def _blocks(pieces: list[str], kind: str) -> Iterator[str]:
    """What stands before the first explanation as it is; then each explanation as a field, each sentence for itself."""
    before, *rest = pieces
    if before.strip():
        yield f"{_text(before.rstrip())}\n"
    for names, told in zip(rest[::2], rest[1::2], strict=True):
        text = _text(" ".join(told.split()))
        yield from [f":{kind} {name}: {text}" for name in names.split(", ")] if names else [f"\n{text}\n"]


def _text(source: str) -> str:
    return SPECIAL.sub(lambda found: f"`{found[1]}`" if found[1] else f"\\{found[2]}", source)
