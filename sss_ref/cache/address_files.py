"""Machine code that is called by its address alone, kept between processes without what numba wants to know of it.

A kernel that Python calls is kept with its types and its code in LLVM's language, and takes ten times as long to load.
This code must need nothing from outside but C functions: those of Python, and those that numba has LLVM find.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import llvmlite.binding as llvm

from sss_ref.cache.kernel_files import KernelFiles


class AddressFiles(KernelFiles):
    """The files of a function that is called by its address."""

    suffix = ".code"

    def reduced(self, result: Any) -> tuple[str, bytes]:
        """The name that its address has, and its object code."""
        _, _, (object_code, _) = result.library.serialize_using_object_code()
        return result.fndesc.llvm_cfunc_wrapper_name, object_code

    def rebuilt(self, kept: tuple[str, bytes], target: Any) -> "Loaded":
        """Its code, linked where it is now."""
        name, object_code = kept
        return Loaded(name, object_code)


@dataclass(frozen=True)
class Loaded:
    """Linked code, with the names under which numba asks a compiled function for its address."""

    llvm_cfunc_wrapper_name: str
    object_code: bytes

    @property
    def fndesc(self) -> "Loaded":
        """What numba calls a description of the function."""
        return self

    @property
    def library(self) -> "Loaded":
        """Where numba looks for the address."""
        return self

    def get_pointer_to_function(self, name: str) -> int:
        """The address of the function of that name."""
        engine = _engine()
        engine.add_object_file(llvm.ObjectFileRef.from_data(self.object_code))
        engine.finalize_object()
        address: int = engine.get_function_address(name)
        return address


@cache
def _engine() -> Any:
    """What links the code; numba has told LLVM of the processor."""
    machine = llvm.Target.from_default_triple().create_target_machine(jit=True)
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
