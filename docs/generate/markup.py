"""The pieces of Markdown that all generated pages are made of."""

import re
from collections.abc import Iterable, Sequence
from typing import Any

SPECIAL = re.compile(r"(`[^`]*`)|([*_\[\]<>|$])")  # code, which is left alone, or a character that means something


def prose(text: str | None) -> str:
    """A docstring as Markdown: what is between backticks stays code, all else is text."""
    return SPECIAL.sub(lambda found: found[1] or f"\\{found[2]}", text or "")


def one_line(text: str | None) -> str:
    """Prose on one line, for the cell of a table."""
    return prose(" ".join((text or "").split()))


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; its cells are Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def fenced(language: str, source: str) -> str:
    """A block of source code."""
    return f"```{language}\n{source.strip()}\n```"


def directive(name: str, argument: str, content: str, options: Any = ()) -> str:
    """A Sphinx directive; options: pairs of name and value."""
    head = "\n".join([f"::::{{{name}}} {argument}", *(f":{key}: {value}".rstrip() for key, value in options)])
    return f"{head}\n\n{content}\n::::"
