"""Arrays in files that users hand over: mapped, so that a damaged file takes no memory and none is left open."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

ARCHIVE = b"PK\3\4"  # how an NPZ file begins, whatever its name


def mapped_array(path: Path) -> NDArray[Any] | None:
    """The array of an NPY file, as it lies there; None for an NPZ file.

    numpy.load would open an archive too, and leave a damaged one open. Raises whatever damage makes NumPy raise.
    """
    with path.open("rb") as file:
        if file.read(len(ARCHIVE)) == ARCHIVE:
            return None
    with np.errstate(over="ignore"):  # of the product of a shape of very many numbers
        return np.lib.format.open_memmap(path, mode="r")
