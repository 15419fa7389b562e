"""How every kernel of the package is compiled, and where its machine code is kept.

The cache lives in a folder named by a hash of the versions and settings of what compiles; in it a file is named by the
sources and argument types of its kernel and by the processor (kernel_files.py). So an edit compiles anew what depends
on it and nothing else, and stale code cannot be served.
"""

import hashlib
import sys
from collections.abc import Callable
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numba
from numba.core.ccallback import CFunc
from numba.extending import register_jitable

from sss_ref.cache.address_files import AddressFiles
from sss_ref.cache.kernel_files import SUFFIX, KernelFiles
from sss_ref.cache.root import cache_below

SETTINGS: Any = numba.config  # filled at run time, so type checkers do not see its fields
CONTRACT: dict[str, Any] = {"nogil": True, "error_model": "numpy"}  # and never fastmath: rule A1
UNUSED: dict[str, Any] = {"no_cfunc_wrapper": True}  # what calls a kernel from C, which takes time to compile
DECIDING = ("OPT", "LOOP_VECTORIZE", "SLP_VECTORIZE", "BOUNDSCHECK", "DEBUGINFO_DEFAULT")


@cache
def cache_folder() -> Path | None:
    """The folder for this compiler (None: nowhere to write, so every process compiles anew)."""
    return cache_below(fingerprint())


def fingerprint() -> str:
    """A hash of what decides the machine code apart from sources, argument types and processor."""
    versions = [version(name) for name in ("numba", "llvmlite", "numpy")]
    settings = [getattr(SETTINGS, name) for name in DECIDING]
    return hashlib.sha256(repr([versions, sys.version, settings, CONTRACT]).encode()).hexdigest()[:16]


def is_cold() -> bool:
    """Whether no kernel was compiled and kept yet, so that the next rendering takes longer."""
    folder = cache_folder()
    return folder is None or next(folder.glob(f"*{SUFFIX}"), None) is None


def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` under the arithmetic contract (decorator): no GIL, IEEE division, no fast-math, cached."""
    kernel: Callable[..., Any] = _keeping(numba.njit(**CONTRACT, **UNUSED)(function), function, KernelFiles)
    return kernel


def part_of_kernels(function: Callable[..., Any]) -> Callable[..., Any]:
    """Let kernels call a function (decorator), compiled into them under the same contract; to Python it stays plain.

    What Python never calls needs no conversion of its arguments, which takes half the time to compile.
    """
    register_jitable(error_model=CONTRACT["error_model"], **UNUSED)(function)
    return function


def callable_compiled(function: Callable[..., Any], signature: Any) -> Any:
    """Compile `function` at once, under the same contract and cached, as one that is called by its `address`."""
    callback = CFunc(function, (signature.args, signature.return_type), {}, {"error_model": CONTRACT["error_model"]})
    _keeping(callback, function, AddressFiles).compile()
    return callback


def _keeping(kernel: Any, function: Callable[..., Any], files: type[KernelFiles]) -> Any:
    """The same kernel with its machine code kept in files, if there is a folder for them."""
    folder = cache_folder()
    if folder and not SETTINGS.DISABLE_JIT:
        kernel._cache = files(folder, function)
    return kernel
