"""Triangle numbers: which storages hold them whole, and what stands for -1 where nothing is drawn."""

import numpy as np

from sss_ref.dump.slots import Slot
from sss_ref.dump.sources import Source
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

EXACT_BELOW = 2.0**31  # what int32 can hold
WHOLE_UP_TO = {"float16": 2**11, "float24": 2**16, "float32": 2**24}
"""Float storage -> the whole number after which some have no equal there."""
CODES = {"unorm8": "uint8", "unorm16": "uint16"}
NOTHING = {"uint8": 255, "uint16": 65535}  # what -1 becomes in a storage without sign; see `decoded` for 32 bits


def written_as_codes(texels: StoredTexels) -> str | None:
    """The integers that a picture of bytes or words holds where it is one of numbers; None for any other."""
    return CODES.get(texels.storage)


def whole_numbers(values: np.ndarray, slot: Slot, source: Source, storage: str) -> np.ndarray:
    """The values as int32. Raises DumpError for fractions, and where the storage cannot have told two numbers apart."""
    is_held = (np.abs(values) < EXACT_BELOW) & (np.rint(values) == values)
    if not is_held.all():
        raise DumpError(unfit(values, is_held, "whole numbers", slot, source))
    _check_told_apart(values, slot, source, storage)
    numbers = values.astype(slot.dtype)
    is_plain = (source.table.scale, source.table.offset) == (1.0, 0.0) and source.table.background is None
    return np.where(numbers == NOTHING.get(storage), -1, numbers).astype(slot.dtype) if is_plain else numbers


def _check_told_apart(values: np.ndarray, slot: Slot, source: Source, storage: str) -> None:
    """Raise DumpError where the mesh has more triangles than the storage has whole numbers."""
    limit, last = WHOLE_UP_TO.get(storage), slot.largest or 0
    if storage in NOTHING and last >= NOTHING[storage]:
        expected = f"a number for each of {last + 1} triangles in {slot.name}"
        raise DumpError(told(str(source.path), expected, f"{storage}, which has fewer", "dump them as 32-bit integers"))
    if limit is not None and last > limit and (np.abs(values) >= limit).any():
        expected = f"numbers up to {limit} in {slot.name}, as {storage} holds no more of them whole"
        largest = f"{np.abs(values).max():.0f} of a mesh of {last + 1} triangles"
        raise DumpError(told(str(source.path), expected, largest, "dump them as 32-bit integers or floats"))


def unfit(values: np.ndarray, is_held: np.ndarray, expected: str, slot: Slot, source: Source) -> str:
    """What is said of the first value that the buffer's type cannot hold."""
    row, column = np.argwhere(~is_held)[0][:2].tolist()
    came = f"{values[row, column, 0]!s} at pixel {column},{row} (column,row; row 0 at the bottom)"
    return told(str(source.path), f"{expected} in {slot.name}", came, "check encoding, scale and offset")
