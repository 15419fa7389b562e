"""Machine code between processes: a file for each kernel and each list of argument types, behind a hash of its own.

numba's own cache notices an edit of the file that holds a kernel, but not of the functions that the kernel calls, and
gives damaged code to the processor as it finds it. Here a file is named by a hash of all that its code depends on, so
that an edit asks for another file; and one that is not whole is told and made again.
"""

import hashlib
import logging
import os
import pickle
from pathlib import Path
from typing import Any

from numba.core import compiler, serialize

from sss_ref.cache.kernel_sources import sources_hash

COMPILE_RESULT: Any = compiler.CompileResult  # numba has no types
DUMPS: Any = serialize.dumps
SUFFIX = ".kernel"
DIGEST = 32  # bytes of SHA-256 before the content of a file


class KernelFiles:
    """What numba asks of the cache of one function; its own has the same methods.

    folder: where the files are, which the caller names by compiler, versions and settings.
    """

    def __init__(self, folder: Path, function: Any) -> None:
        self.cache_path = str(folder)
        self._folder, self._function = folder, function

    def load_overload(self, types: Any, target: Any) -> Any:
        """The compiled function for these argument types, or None."""
        target.refresh()
        path = self._path(types, target.codegen())
        if path is None or not path.exists():
            return None
        try:
            content = path.read_bytes()
        except OSError as error:
            _say(path, "a file that can be read", error.strerror or "none", "its kernel is compiled again")
            return None
        digest, reduced = content[:DIGEST], content[DIGEST:]
        if hashlib.sha256(reduced).digest() != digest:
            _say(path, "a whole file", "a damaged one", "it is compiled and written again")
            return None
        return COMPILE_RESULT._rebuild(target, *pickle.loads(reduced))

    def save_overload(self, types: Any, result: Any) -> None:
        """Keep a compiled function."""
        path = self._path(types, result.codegen)
        if path is None or result.library.has_dynamic_globals:
            return
        reduced = DUMPS(result._reduce())
        part = path.with_suffix(f".{os.getpid()}.part")
        try:
            part.write_bytes(hashlib.sha256(reduced).digest() + reduced)
            part.replace(path)
        except OSError as error:
            _say(path, "a file that can be written", error.strerror or "none", "the next process compiles again")

    def _path(self, types: Any, codegen: Any) -> Path | None:
        """The file for these argument types and this processor (None: a function whose source nobody knows)."""
        sources = sources_hash(self._function.__code__.co_filename)
        if sources is None or self._function.__closure__:
            return None
        name = self._function.__qualname__
        key = repr([sources, self._function.__module__, name, str(types), codegen.magic_tuple()])
        return self._folder / f"{name}-{hashlib.sha256(key.encode()).hexdigest()[:DIGEST]}{SUFFIX}"


def _say(path: Path, expected: str, came: str, remedy: str) -> None:
    logging.getLogger("sss_ref").warning("%s: expected %s, got %s; %s", path, expected, came, remedy)
