"""The modules of stages: their sources, which no file holds, and what is compiled from them, once for all passes."""

import hashlib
import linecache
import sys
from collections.abc import Callable
from functools import cache
from threading import RLock
from types import ModuleType
from typing import Any

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
        self.body = stage.body
        rows = source.rows
        self.inputs, self.outputs, self.others = rows.inputs, rows.outputs, len(rows.rows) - rows.inputs - rows.outputs
        self.calls: list[tuple[int, StageCall]] = [(_address(module, call), call) for call in source.calls]


def _address(module: ModuleType, call: StageCall) -> int:
    """Where the function that a call names begins."""
    if call.elementary:
        return address_of(ELEMENTARY_ROWS[call.function])
    address: int = getattr(module, call.function).address
    return address


ONE_AT_A_TIME = RLock()  # so that threads that want the same are given the same
ADDRESSES: dict[Callable[..., None], int] = {}


def address_of(function: Callable[..., None]) -> int:
    """Where a function of rows that is written by hand begins, compiled when it is first asked for."""
    with ONE_AT_A_TIME:
        if function not in ADDRESSES:
            ADDRESSES[function] = row_function(function).address
    return ADDRESSES[function]


CODES: dict[Any, list[StageCode]] = {}  # of each signature, those of different bodies


def code_of(stage: Stage, uniform: frozenset[str]) -> StageCode:
    """A stage compiled, once for all passes and lights; uniform: those of its parameters that are uniforms."""
    signature = stage.name, *stage.parameters.items(), *stage.outputs.items(), uniform
    with ONE_AT_A_TIME:
        codes = CODES.setdefault(signature, [])
        same = [code for code in codes if code.body is stage.body] or [
            code for code in codes if code.body == stage.body
        ]
        if not same:
            codes.append(StageCode(stage, uniform))
        return same[0] if same else codes[-1]


@cache
def imported(source: str, name: str) -> ModuleType:
    """The module of this source, which is in no file."""
    module_name = f"sss_ref_{name}_{hashlib.sha256(source.encode()).hexdigest()[:16]}"
    path = f"<{module_name}>"
    module = ModuleType(module_name)
    module.__file__ = path
    lines = source.splitlines(keepends=True)
    linecache.cache[path] = len(source), None, lines, path  # for whoever asks for its lines
    sys.modules[module_name] = module  # numba looks a kept function's module up by name
    exec(compile(source, path, "exec"), module.__dict__)
    return module
