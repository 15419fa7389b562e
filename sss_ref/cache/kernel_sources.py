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


@cache
def imported(source: str) -> tuple[Path, ...]:
    """The files of the package that a source imports, inside its functions too; kept, for many kernels share them."""
    return tuple(path for module, names in IMPORT.findall(source) for path in _files(module, names) if path.is_file())


def _files(module: str, names: str) -> Iterator[Path]:
    """Where a module and the members that are imported from it would be, if each were a module or a package."""
    folder = PACKAGE.joinpath(*module.split(".")[1:])
    for path in (folder, *(folder / name for name in re.findall(r"\w+", names))):
        yield from (path.with_suffix(".py"), path / "__init__.py")
