"""How every kernel of the package is compiled, and where its machine code is kept.

numba notices an edit of the file that holds a kernel, but not of the functions the kernel calls, and its key
leaves out the optimisation level. So the cache lives in a folder named by a hash of all sources of the package,
of the compiler's version and of its settings: an edit anywhere opens a new folder, and stale code cannot be served.
"""

import hashlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numba

from sss_ref.cache.root import cache_below

SETTINGS: Any = numba.config  # filled at run time, so type checkers do not see its fields
CONTRACT: dict[str, Any] = {"nogil": True, "error_model": "numpy"}  # and never fastmath: rule A1


@cache
def cache_folder() -> Path | None:
    """The folder for these sources and this compiler (None: nowhere to write, so every process compiles anew)."""
    return cache_below(fingerprint())


def fingerprint() -> str:
    """A hash of everything that decides the machine code, apart from the processor (numba's own key holds that)."""
    digest = hashlib.sha256()
    package = Path(__file__).parents[1]
    for source in sorted(package.rglob("*.py")):
        digest.update(source.relative_to(package).as_posix().encode() + b"\0" + source.read_bytes())
    digest.update(repr([version("numba"), version("llvmlite"), version("numpy"), SETTINGS.OPT]).encode())
    return digest.hexdigest()[:16]


def is_cold() -> bool:
    """Whether no kernel of these sources was compiled and kept yet, so that the next rendering takes longer."""
    folder = cache_folder()
    return folder is None or next(folder.rglob("*.nbi"), None) is None


@contextmanager
def _caching_in(folder: Path) -> Iterator[None]:
    """Point numba at `folder` while a kernel is being defined; the user's own setting comes back afterwards."""
    before = SETTINGS.CACHE_DIR
    SETTINGS.CACHE_DIR = str(folder)
    try:
        yield
    finally:
        SETTINGS.CACHE_DIR = before


def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` under the arithmetic contract (decorator): no GIL, IEEE division, no fast-math, cached."""
    folder = cache_folder()
    kernel: Callable[..., Any]
    if folder is None:
        kernel = numba.njit(**CONTRACT)(function)
    else:
        with _caching_in(folder):
            kernel = numba.njit(cache=True, **CONTRACT)(function)
    return kernel


def callable_compiled(function: Callable[..., Any], signature: Any) -> Any:
    """Compile `function` at once, under the same contract and cached, as one that is called by its `address`."""
    folder = cache_folder()
    options = {"error_model": CONTRACT["error_model"]}
    if folder is None:
        return numba.cfunc(signature, **options)(function)
    with _caching_in(folder):
        return numba.cfunc(signature, cache=True, **options)(function)
