"""Machine code between processes: a file for each kernel and each list of argument types, behind a hash of its own.

numba's own cache notices an edit of the file that holds a kernel, but not of the functions that the kernel calls, and
gives damaged code to the processor as it finds it. Here a file is named by a hash of all that its code depends on, so
that an edit asks for another file; and one that is not whole is told and made again.
"""

import hashlib
import logging
import os
import pickle
import shutil
from pathlib import Path
from typing import Any

from numba.core import compiler, serialize
from numba.core.runtime import nrt

from sss_ref.cache.kernel_sources import sources_hash

COMPILE_RESULT: Any = compiler.CompileResult  # numba has no types
DUMPS: Any = serialize.dumps
MEMORY: Any = nrt.rtsys
SUFFIX = ".kernel"
DIGEST = 32  # bytes of SHA-256 before the content of a file


class KernelFiles:
    """What numba asks of the cache of one function; its own has the same methods.

    folder: where the files are, which the caller names by compiler, versions and settings.
    """

    suffix = SUFFIX

    def __init__(self, folder: Path, function: Any) -> None:
        self.cache_path = str(folder)
        self._folder, self._function = folder, function

    def load_overload(self, types: Any, target: Any) -> Any:
        """The compiled function for these argument types, or None."""
        MEMORY.initialize(target)  # of what numba's own cache makes ready here, machine code needs no more
        path = self._path(types, target.codegen())
        reduced = path and _kept(path)
        return self.rebuilt(pickle.loads(reduced), target) if reduced else None

    def save_overload(self, types: Any, result: Any) -> None:
        """Keep a compiled function."""
        path = self._path(types, result.codegen)
        if path is None or result.library.has_dynamic_globals:
            return
        reduced = DUMPS(self.reduced(result))
        part = path.with_suffix(f".{os.getpid()}.part")
        try:
            part.write_bytes(_digest(path, reduced) + reduced)
            part.replace(path)
        except OSError as error:
            _say(path, "a file that can be written", error.strerror or "none", "the next process compiles again")

    def reduced(self, result: Any) -> Any:
        """What of a compiled function is kept."""
        return result._reduce()

    def rebuilt(self, kept: Any, target: Any) -> Any:
        """The compiled function of what was kept."""
        return COMPILE_RESULT._rebuild(target, *kept)

    def _path(self, types: Any, codegen: Any) -> Path | None:
        """The file for these argument types and this processor (None: a function whose source nobody knows)."""
        sources = sources_hash(self._function.__code__.co_filename)
        if sources is None or self._function.__closure__:
            return None
        name = self._function.__qualname__
        key = repr([sources, self._function.__module__, name, str(types), codegen.magic_tuple()])
        return self._folder / f"{name}-{hashlib.sha256(key.encode()).hexdigest()[:DIGEST]}{self.suffix}"


def _kept(path: Path) -> bytes | None:
    """What was kept in a file; None if there is none, or a damaged one, which is said: it will be replaced."""
    if not os.path.lexists(path):
        return None
    try:
        if not path.is_file():
            _clear(path)
            came = "a folder or a device"
        else:
            content = path.read_bytes()
            if content[:DIGEST] == _digest(path, content[DIGEST:]):
                return content[DIGEST:]
            came = "a damaged one"
    except OSError as error:
        came = error.strerror or "one that cannot be read"
    _say(path, "a whole file", came, "it is compiled and written again")
    return None


def _digest(path: Path, reduced: bytes) -> bytes:
    """The hash of a file's content and of its name, so that one under another's name is none."""
    return hashlib.sha256(path.name.encode() + b"\0" + reduced).digest()


def _clear(path: Path) -> None:
    """Remove what no file can be written over."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink()


def _say(path: Path, expected: str, came: str, remedy: str) -> None:
    logging.getLogger("sss_ref").warning("%s: expected %s, got %s; %s", path, expected, came, remedy)
