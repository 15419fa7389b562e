"""The sources that a kernel's machine code comes from: its own module, and all of the package that this imports."""

import hashlib
import linecache
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parents[1]
IMPORT = re.compile(rf"^[ \t]*(?:from|import)[ \t]+({PACKAGE.name}[.\w]*)(?:[ \t]+import[ \t]+(\([^)]*\)|.*))?", re.M)


@cache
def sources_hash(module_file: str) -> str | None:
    """A hash of everything that the functions of a module may call, by its `__file__` (None: it has no source)."""
    own = "".join(linecache.getlines(module_file))
    if not own:
        return None
    texts, todo = {module_file: own}, [own]
    while todo:
        for path in imported(todo.pop()):
            if str(path) not in texts:
                todo.append(texts.setdefault(str(path), path.read_text(encoding="utf-8")))
    del texts[module_file]
    return hashlib.sha256(repr([own, *sorted(texts.items())]).encode()).hexdigest()


def imported(source: str) -> Iterator[Path]:
    """The files of the package that a source imports, inside its functions too."""
    for module, names in IMPORT.findall(source):
        folder = PACKAGE.joinpath(*module.split(".")[1:])
        members = [folder / name for name in re.findall(r"\w+", names)]
        candidates = [each for path in (folder, *members) for each in (path.with_suffix(".py"), path / "__init__.py")]
        yield from (path for path in candidates if path.is_file())
