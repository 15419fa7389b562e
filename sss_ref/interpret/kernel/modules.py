"""The modules of stages: their sources, which no file holds, and what is compiled from them, once for all passes."""

import hashlib
import inspect
import linecache
from collections.abc import Callable
from functools import cache
from threading import RLock
from types import ModuleType
from typing import Any

from numba import types

from sss_ref.cache import object_files
from sss_ref.cache.compiled import SETTINGS, callable_compiled
from sss_ref.cache.kernel_sources import sources_hash
from sss_ref.cache.linked import address_of_linked, make_known
from sss_ref.interpret.kernel import assembly, fragment_rows
from sss_ref.interpret.kernel.elementary_rows import ELEMENTARY_ROWS
from sss_ref.interpret.kernel.row_function import row_function
from sss_ref.interpret.kernel.source import StageSource
from sss_ref.interpret.kernel.stage_rows import StageCall
from sss_ref.language.stage import Stage
from sss_ref.numerics.scalar import SCALARS


class StageCode:
    """A compiled stage: the addresses of its calls, and how many rows it wants for inputs, outputs and in between."""

    def __init__(self, stage: Stage, uniform: frozenset[str]) -> None:
        source = StageSource(stage, uniform)
        own = own_addresses(source, stage.name)
        self.body = stage.body
        rows = source.rows
        self.inputs, self.outputs, self.others = rows.inputs, rows.outputs, len(rows.rows) - rows.inputs - rows.outputs
        self.calls: list[tuple[int, StageCall]] = [
            (address_of(ELEMENTARY_ROWS[call.function]) if call.elementary else own[call.function], call)
            for call in source.calls
        ]


def own_addresses(source: StageSource, name: str) -> dict[str, int]:
    """Where each function of a stage's module begins."""
    names = [call.function for call in source.calls if not call.elementary]
    if SETTINGS.DISABLE_JIT:
        module = imported(source.text, name)
        return {each: getattr(module, each).address for each in names}
    if not names:
        return {}
    make_scalars_known(source.text)
    prefix = linked(source.text, name, names[0])
    return {each: address_of_linked(f"{prefix}.{each}") for each in names}


@cache
def linked(source: str, name: str, function: str) -> str:
    """Make the functions of rows in a module, of which one is told, callable; what precedes the dot in their names."""
    prefix = f"sss_ref_{hashlib.sha256(source.encode()).hexdigest()[:16]}"
    sources = repr([source, sources_hash(assembly.__file__), sources_hash(object_files.__file__)])
    object_files.link_object_code(name, sources, lambda: assembly.assembled(source, prefix), f"{prefix}.{function}")
    return prefix


def make_scalars_known(text: str) -> None:
    """Have the elementary functions that loops call found by their names."""
    for function in SCALARS.values():
        if f"{function.__name__}(" in text:
            make_known(function.__name__, address_of_scalar(function))


@cache
def address_of_scalar(function: Any) -> int:
    """Where an elementary function of numbers begins, compiled when it is first asked for."""
    numbers = [types.float32] * function.py_func.__code__.co_argcount
    address: int = callable_compiled(function.py_func, types.float32(*numbers)).address
    return address


ONE_AT_A_TIME = RLock()  # so that threads that want the same are given the same
ADDRESSES: dict[Callable[..., None], int] = {}


def address_of(function: Callable[..., None]) -> int:
    """Where a function of rows that is written by hand begins, compiled when it is first asked for."""
    with ONE_AT_A_TIME:
        if function not in ADDRESSES:
            ADDRESSES[function] = _compiled(function)
    return ADDRESSES[function]


def _compiled(function: Callable[..., None]) -> int:
    """Where it begins: one of fragment_rows.py translated with its module, any other compiled by numba."""
    if function in fragment_rows.ALL and not SETTINGS.DISABLE_JIT:
        prefix = linked(inspect.getsource(fragment_rows), "fragment_rows", fragment_rows.ALL[0].__name__)
        return address_of_linked(f"{prefix}.{function.__name__}")
    address: int = row_function(function).address
    return address


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
    """The module of this source as Python, which is in no file: for runs without any compiler."""
    module_name = f"sss_ref_{name}_{hashlib.sha256(source.encode()).hexdigest()[:16]}"
    path = f"<{module_name}>"
    module = ModuleType(module_name)
    module.__file__ = path
    lines = source.splitlines(keepends=True)
    linecache.cache[path] = len(source), None, lines, path  # for whoever asks for its lines
    exec(compile(source, path, "exec"), module.__dict__)
    return module
