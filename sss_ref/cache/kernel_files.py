"""Machine code between processes: a file for each kernel and each list of argument types, behind a hash of its own.

numba's own cache notices an edit of the file that holds a kernel, but not of the functions that the kernel calls, and
gives damaged code to the processor as it finds it. Here a file is named by a hash of all that its code depends on, so
that an edit asks for another file; and one that is not whole is told and made again.
"""

import hashlib
import pickle
from pathlib import Path
from typing import Any

from numba.core import compiler, serialize
from numba.core.runtime import nrt

from sss_ref.cache.kernel_sources import sources_hash
from sss_ref.cache.whole_files import keep, kept

COMPILE_RESULT: Any = compiler.CompileResult  # numba has no types
DUMPS: Any = serialize.dumps
MEMORY: Any = nrt.rtsys
SUFFIX = ".kernel"
NAMED = 32  # digits of a hash in a file's name


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
        reduced = path and kept(path)
        return self.rebuilt(path, pickle.loads(reduced), target) if path and reduced else None

    def save_overload(self, types: Any, result: Any) -> None:
        """Keep a compiled function."""
        path = self._path(types, result.codegen)
        if path is None or result.library.has_dynamic_globals:
            return
        keep(path, DUMPS(self.reduced(result)))

    def reduced(self, result: Any) -> Any:
        """What of a compiled function is kept."""
        return result._reduce()

    def rebuilt(self, path: Path, reduced: Any, target: Any) -> Any:
        """The compiled function of what a file held (None: it was another)."""
        return COMPILE_RESULT._rebuild(target, *reduced)

    def _path(self, types: Any, codegen: Any) -> Path | None:
        """The file for these argument types and this processor (None: a function whose source nobody knows)."""
        sources = sources_hash(self._function.__code__.co_filename)
        if sources is None or self._function.__closure__:
            return None
        name = self._function.__qualname__
        key = repr([sources, self._function.__module__, name, str(types), codegen.magic_tuple()])
        return self._folder / f"{name}-{hashlib.sha256(key.encode()).hexdigest()[:NAMED]}{self.suffix}"
