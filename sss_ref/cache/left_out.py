"""Loading numba without SciPy, which it asks for a BLAS that no kernel here calls."""

import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

ASKING, ASKED_FOR = "numba.np.linalg", "scipy.linalg"


class _Absent(MetaPathFinder):
    """Finds no `scipy.linalg` while numba's array functions are being loaded, which is when they ask for it."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Raise ImportError for it, as if it were not installed; once asked it is in nobody's way any more."""
        if fullname == ASKED_FOR:
            sys.meta_path.remove(self)
            if ASKING in sys.modules:
                raise ModuleNotFoundError(f"{fullname}: left out", name=fullname)
        return None


def leave_out() -> None:
    """Have numba find no BLAS in this process, and so not load SciPy's linear algebra for it.

    For a process that runs nothing but our kernels: in others numba's `np.dot` would be refused.
    """
    sys.meta_path.insert(0, _Absent())
