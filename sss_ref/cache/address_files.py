"""Machine code that is called by its address alone, kept between processes without what numba wants to know of it.

A kernel that Python calls is kept with its types and its code in LLVM's language, and takes ten times as long to load.
This code must need nothing from outside but C functions: those of Python, and those that numba has LLVM find.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sss_ref.cache.kernel_files import KernelFiles
from sss_ref.cache.linked import address_of_linked, link
from sss_ref.cache.whole_files import refused


class AddressFiles(KernelFiles):
    """The files of a function that is called by its address."""

    suffix = ".code"

    def reduced(self, result: Any) -> tuple[str, bytes]:
        """The name that its address has, and its object code."""
        _, _, (object_code, _) = result.library.serialize_using_object_code()
        return result.fndesc.llvm_cfunc_wrapper_name, object_code

    def rebuilt(self, path: Path, reduced: tuple[str, bytes], target: Any) -> "Loaded | None":
        """Its code, linked where it is now; None, which is said, if the file holds that of another function."""
        name, object_code = reduced
        link(object_code)
        address = address_of_linked(name)
        if address == 0:
            refused(path, f"the code of {name}", "none of that name")
            return None
        return Loaded(name, address)


@dataclass(frozen=True)
class Loaded:
    """Linked code, with the names under which numba asks a compiled function for its address."""

    llvm_cfunc_wrapper_name: str
    address: int

    @property
    def fndesc(self) -> "Loaded":
        """What numba calls a description of the function."""
        return self

    @property
    def library(self) -> "Loaded":
        """Where numba looks for the address."""
        return self

    def get_pointer_to_function(self, name: str) -> int:
        """The address, of the one function that there is."""
        return self.address
