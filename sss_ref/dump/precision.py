"""How far a buffer that was converted may be from what its texture was given: the storage's loss, carried along."""

from dataclasses import replace

import numpy as np

from sss_ref.dump.encoding import LARGEST_CODE, PACKED, Encoding
from sss_ref.dump.loss import Loss, loss_of, shared_exponent
from sss_ref.dump.mapping import BufferTable

BENT = 3.0  # how much farther two directions may be apart than their places on the octahedral map, in any component


def encoding_of(table: BufferTable, storage: str, loss: Loss | None, stored: np.ndarray) -> Encoding:
    """How a buffer was stored, with its loss if that is not the storage's own.

    loss: of the format, where it has one of its own. stored: the numbers of the file, before scale and offset.
    A file that was converted, or compressed to fewer bits, holds less than the texture had, unless the mapping says so.
    """
    encoding = Encoding(storage, **table.stored)
    loss = loss or (shared_exponent(stored) if storage == "rgb9e5" else None)
    if storage != "float24" and loss is None and table.is_plain:
        return encoding
    moved = None if table.is_plain and loss is None else _moved(table, loss or loss_of(storage), largest(stored))
    texture = None if storage in (*LARGEST_CODE, *PACKED) or (table.is_plain and loss) else "float32"
    return replace(encoding, loss=moved, rounded_from=table.rounded_from or texture)


def largest(values: np.ndarray) -> float:
    """The largest finite value by size, 0 if there is none."""
    finite = np.abs(values[np.isfinite(values)].astype(np.float64))
    return float(finite.max(initial=0.0))


def _moved(table: BufferTable, loss: Loss, size: float) -> Loss:
    """The loss after scale and offset, the encoding of normals and the turn to world space; size: of what is stored."""
    scales, offsets = (value if isinstance(value, tuple) else (value,) for value in (table.scale, table.offset))
    reach = max(map(abs, scales)), max(map(abs, offsets))
    if len(scales) == len(offsets) == 1 and (scales, offsets) != ((1.0,), (0.0,)):
        loss = loss.scaled(scales[0], offsets[0], size)
    elif max(len(scales), len(offsets)) > 1:
        loss = loss.scaled(reach[0], reach[1], size).unclamped()
    if table.normals == "n*.5+.5":
        loss = loss.scaled(2.0, -1.0, 1.0)
    elif table.normals == "octahedral":
        loss = Loss(least=BENT * loss.spread(1.0).least)
    if table.space == "view":
        loss = loss.spread(2 * (size * reach[0] + reach[1]))
    return loss
