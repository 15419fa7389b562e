"""Lines of source: indented, folded, commented."""

import re
import textwrap
from collections.abc import Sequence

INDENT = "    "
LINE_LENGTH = 120
TYPED, UNBROKEN = re.compile(r"(?<=\w): "), "\xa0"  # a name and its type stay together


def indented(lines: Sequence[str]) -> list[str]:
    """Lines one level further in."""
    return [INDENT + line for line in lines]


def braced(head: str, lines: Sequence[str], end: str = "}") -> list[str]:
    """A head and the lines in its braces."""
    return [head, "{", *indented(lines), end]


def folded(text: str) -> str:
    """Source with its long lines broken at spaces."""
    return "\n".join(part for line in text.splitlines() for part in _folded_line(line))


def _folded_line(line: str) -> list[str]:
    if len(line) <= LINE_LENGTH:
        return [line]
    further = line[: len(line) - len(line.lstrip())] + 2 * INDENT
    kept = TYPED.sub(f":{UNBROKEN}", line)
    parts = textwrap.wrap(kept, LINE_LENGTH, subsequent_indent=further, break_long_words=False, break_on_hyphens=False)
    return [part.replace(UNBROKEN, " ") for part in parts]


def comment(text: str) -> list[str]:
    """A text as comment lines; its own line breaks stay."""
    wrapped = [part for line in text.splitlines() for part in textwrap.wrap(line, LINE_LENGTH - 3) or [""]]
    return [f"// {line}".rstrip() for line in wrapped]


def joined(blocks: list[list[str]]) -> str:
    """A source of blocks of lines, with an empty line between them."""
    return folded("\n\n".join("\n".join(block) for block in blocks if block)) + "\n"
