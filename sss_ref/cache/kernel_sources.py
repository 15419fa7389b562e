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
    hashes, todo = {module_file: ""}, [own]
    while todo:
        for path in imported(todo.pop()):
            if str(path) not in hashes:
                text, hashes[str(path)] = _read(path)
                todo.append(text)
    del hashes[module_file]
    return hashlib.sha256(repr([own, *sorted(hashes.items())]).encode()).hexdigest()


@cache
def _read(path: Path) -> tuple[str, str]:
    """A file's text and the hash of it; kept, for many kernels share them."""
    text = path.read_text(encoding="utf-8")
    return text, hashlib.sha256(text.encode()).hexdigest()


@cache
def imported(source: str) -> tuple[Path, ...]:
    """The files of the package that a source imports, inside its functions too; kept, for many kernels share them."""
    return tuple(path for module, names in IMPORT.findall(source) for path in _files(module, names) if path.is_file())


def _files(module: str, names: str) -> Iterator[Path]:
    """Where a module and the members that are imported from it would be, if each were a module or a package."""
    folder = PACKAGE.joinpath(*module.split(".")[1:])
    for path in (folder, *(folder / name for name in re.findall(r"\w+", names))):
        yield from (path.with_suffix(".py"), path / "__init__.py")
