"""Modules in LLVM's language as machine code, kept between processes; of numba they need the processor's name."""

import hashlib
from collections.abc import Callable
from typing import Any

import llvmlite.binding as llvm
from numba.core import registry

from sss_ref.cache.compiled import SETTINGS, cache_folder
from sss_ref.cache.kernel_files import NAMED
from sss_ref.cache.linked import address_of_linked, link
from sss_ref.cache.whole_files import keep, kept, refused

PROCESSOR: Any = registry.cpu_target  # numba has no types


def link_object_code(name: str, sources: str, module: Callable[[], str], symbol: str) -> None:
    """Make the functions of a module callable, compiled or as a file has them.

    name: of its file, for whoever looks at the folder. sources: all that the module comes from. module: writes it.
    symbol: one of its functions, by which a file with other code is told and replaced.
    """
    folder, processor = cache_folder(), PROCESSOR.target_context.codegen().magic_tuple()
    if folder is None:
        link(compiled_module(module(), processor))
        return
    key = hashlib.sha256(repr([sources, processor]).encode()).hexdigest()[:NAMED]
    path = folder / f"{name}-{key}.code"
    code = kept(path)
    if code is not None and _linked(code, symbol):
        return
    if code is not None:
        refused(path, f"the code of {symbol}", "none of that name")
    code = compiled_module(module(), processor)
    keep(path, code)
    link(code)


def _linked(code: bytes, symbol: str) -> bool:
    """Whether object code was linked and has a function: LLVM says of others that they begin at 0."""
    link(code)
    return address_of_linked(symbol) != 0


def compiled_module(text: str, processor: tuple[str, str, str]) -> bytes:
    """The object code of a module; processor: the kind of system, its name and what it can do, as numba has it."""
    triple, name, features = processor
    target = llvm.Target.from_triple(triple)
    machine = target.create_target_machine(
        cpu=name,
        features=features,
        opt=SETTINGS.OPT,
        reloc="static" if target.name.startswith("x86") else "default",  # as LLVM's linker wants it
        jit=True,
    )
    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = triple, str(machine.target_data)
    module.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=SETTINGS.OPT)
    options.loop_vectorization, options.slp_vectorization = SETTINGS.LOOP_VECTORIZE, SETTINGS.SLP_VECTORIZE
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code
