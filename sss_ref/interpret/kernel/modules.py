"""The modules of stages: written into the cache folder, so that their machine code is kept, and imported from there."""

import hashlib
import importlib.util
import linecache
import os
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from sss_ref.cache.compiled import cache_folder
from sss_ref.interpret.kernel.elementary_rows import ELEMENTARY_ROWS
from sss_ref.interpret.kernel.row_function import row_function
from sss_ref.interpret.kernel.source import StageSource
from sss_ref.interpret.kernel.stage_rows import StageCall
from sss_ref.language.stage import Stage


class StageCode:
    """A compiled stage: the addresses of its calls, and how many rows it wants for inputs, outputs and in between."""

    def __init__(self, stage: Stage, uniform: frozenset[str]) -> None:
        source = StageSource(stage, uniform)
        module = imported(source.text, stage.name)
        rows = source.rows
        self.inputs, self.outputs, self.others = rows.inputs, rows.outputs, len(rows.rows) - rows.inputs - rows.outputs
        self.calls: list[tuple[int, StageCall]] = [(_address(module, call), call) for call in source.calls]


def _address(module: ModuleType, call: StageCall) -> int:
    """Where the function that a call names begins."""
    if call.elementary:
        return address_of(ELEMENTARY_ROWS[call.function])
    address: int = getattr(module, call.function).address
    return address


@cache
def address_of(function: Callable[..., None]) -> int:
    """Where a function of rows that is written by hand begins, compiled when it is first asked for."""
    address: int = row_function(function).address
    return address


CODES: dict[Any, StageCode] = {}


def code_of(stage: Stage, uniform: frozenset[str]) -> StageCode:
    """A stage compiled, once for all passes and lights; uniform: those of its parameters that are uniforms."""
    key = stage.python, stage.name, *stage.parameters.items(), *stage.outputs.items(), uniform
    if key not in CODES:
        CODES[key] = StageCode(stage, uniform)
    return CODES[key]


@cache
def imported(source: str, name: str) -> ModuleType:
    """The module of this source, from the cache folder if there is one."""
    module_name = f"sss_ref_{name}_{hashlib.sha256(source.encode()).hexdigest()[:16]}"
    folder = cache_folder()
    path = _written(folder / f"{module_name}.py", source) if folder else f"<{module_name}>"
    spec = importlib.util.spec_from_loader(module_name, loader=None, origin=str(path))
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    module.__file__ = str(path)
    linecache.cache[str(path)] = (len(source), None, source.splitlines(keepends=True), str(path))
    sys.modules[module_name] = module  # numba looks a cached function's module up by name
    exec(compile(source, str(path), "exec"), module.__dict__)
    return module


def _written(path: Path, source: str) -> Path:
    """The file, written whole if it is not there yet: numba drops its cache when a source file's time changes."""
    if not path.exists():
        part = path.with_suffix(f".{os.getpid()}.part")
        part.write_text(source)
        part.replace(path)
    return path
