"""Object code, put where this process can call it."""

from functools import cache
from typing import Any

import llvmlite.binding as llvm


def link(object_code: bytes) -> None:
    """Make its functions callable; what they call must be of C, of Python, or `known`."""
    engine = _engine()
    engine.add_object_file(llvm.ObjectFileRef.from_data(object_code))
    engine.finalize_object()


def address_of_linked(name: str) -> int:
    """Where a linked function begins; 0 if there is none of that name."""
    address: int = _engine().get_function_address(name)
    return address


def make_known(name: str, address: int) -> None:
    """Have what is linked from now on find a function by its name."""
    llvm.add_symbol(name, address)


@cache
def _engine() -> Any:
    """What links; numba has told LLVM of the processor."""
    machine = llvm.Target.from_default_triple().create_target_machine(jit=True)
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
