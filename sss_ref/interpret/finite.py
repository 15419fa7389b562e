"""No buffer ever holds NaN or infinity (rule A6): whoever fills one looks for them while its rows are in the cache."""

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.interpret.work import Work
from sss_ref.language.layout import FLOAT32

INFINITY = 0x7F800000  # bit pattern of float32 infinity; NaNs lie above


def is_finite(work: Work, rows: slice = slice(None)) -> bool:
    """Whether no float32 output of a pass holds NaN or infinity in some rows."""
    buffers = [buffer[rows] for buffer in work.outputs.values() if buffer.dtype == FLOAT32]
    return all(largest_magnitude(buffer.reshape(-1).view(np.int32)) < INFINITY for buffer in buffers)


@compiled
def largest_magnitude(bits: np.ndarray) -> np.int32:
    """The largest of float32 values given as int32 bit patterns (N,), signs cleared, as a bit pattern."""
    largest = np.int32(0)
    for k in range(len(bits)):
        magnitude = np.int32(bits[k] & np.int32(0x7FFFFFFF))
        largest = magnitude if magnitude > largest else largest
    return largest
