"""Loading numba without what it asks for and makes nothing of here: a quarter of the time that it takes."""

import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType

ASKED_FOR_BY = {  # what is asked for -> the module of numba that does, while it is loaded itself
    "scipy": "numba",  # for its version
    "scipy.linalg": "numba.np.linalg",  # for a BLAS, which no kernel calls
    "coverage": "numba.misc.coverage_support",  # to count the lines that it compiles
    "yaml": "numba.core.config",  # to read SETTINGS
}
SETTINGS = Path(".numba_config.yaml")  # numba's own file, of the folder that the process runs in


class _Absent(MetaPathFinder):
    """Does not find a module while numba asks for it; for whoever asks next it is in nobody's way."""

    def __init__(self, left: dict[str, str]) -> None:
        self.left = left

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Raise ImportError for it, as if it were not installed."""
        if self.left.pop(fullname, None) in sys.modules:
            raise ModuleNotFoundError(f"{fullname}: left out", name=fullname)
        return None


def leave_out() -> None:
    """Have numba find none of it in this process, but for the YAML of its settings where there are some.

    For a process that runs nothing but our kernels: in others numba's `np.dot` would be refused.
    """
    left = {name: asking for name, asking in ASKED_FOR_BY.items() if name != "yaml" or not SETTINGS.is_file()}
    sys.meta_path.insert(0, _Absent(left))
