"""Files that are there as a whole or not at all, however a command ends."""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from uuid import uuid4

Put = Callable[[Path, Path], object]


@contextmanager
def whole_file(path: Path, put: Put = Path.replace) -> Iterator[Path]:
    """Where to write what shall have the name `path` when it is whole. Raises OSError as the system does.

    It is a hidden file beside it, with the same ending. put: gives it its name. A link, a device and a pipe are written
    through, as they are.
    """
    if path.is_symlink() or (path.exists() and not path.is_file()):
        yield path
        return
    hidden = path.with_name(f".{uuid4().hex}{path.suffix}")
    try:
        yield hidden
        if path.exists():
            shutil.copymode(path, hidden)
        put(hidden, path)
    finally:
        hidden.unlink(missing_ok=True)


def put_new(hidden: Path, path: Path) -> None:
    """Give a file a name that nothing has yet. Raises FileExistsError where something has."""
    try:
        os.link(hidden, path)
    except FileExistsError:
        raise
    except OSError:  # a file system without links
        if path.exists():
            raise FileExistsError from None
        hidden.replace(path)
