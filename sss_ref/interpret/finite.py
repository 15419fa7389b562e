"""No buffer ever holds NaN or infinity (rule A6): the check after each pass, and the message if one does."""

from concurrent.futures import Executor
from typing import Any

import numpy as np

from sss_ref.cache.compiled import compiled
from sss_ref.errors import RenderError
from sss_ref.interpret.arrays import draw_values, run_stages
from sss_ref.interpret.work import Work
from sss_ref.language.layout import FLOAT32
from sss_ref.language.types import Array, Texture, components

INFINITY = 0x7F800000  # bit pattern of float32 infinity; NaNs lie above
PART = 1 << 20  # values a task


def require_finite(work: Work, pool: Executor | None) -> None:
    """Raise RenderError, naming stage, pixel and inputs, if an output of a pass holds NaN or infinity."""
    for name, buffer in work.outputs.items():
        if buffer.dtype == FLOAT32 and _largest(buffer, pool) >= INFINITY:
            bad = ~np.isfinite(buffer)
            row, column = np.argwhere(bad.any(axis=-1) if bad.ndim == 3 else bad)[0]
            raise RenderError(_message(work, name, row, column))


def _largest(buffer: np.ndarray, pool: Executor | None) -> int:
    bits = buffer.reshape(-1).view(np.int32)
    parts = [bits[start : start + PART] for start in range(0, len(bits), PART)]
    return int(max((pool.map if pool else map)(largest_magnitude, parts)))


@compiled
def largest_magnitude(bits: np.ndarray) -> np.int32:
    """The largest of float32 values given as int32 bit patterns (N,), signs cleared, as a bit pattern."""
    largest = np.int32(0)
    for k in range(len(bits)):
        magnitude = np.int32(bits[k] & np.int32(0x7FFFFFFF))
        largest = magnitude if magnitude > largest else largest
    return largest


def _message(work: Work, name: str, row: int, column: int) -> str:
    """Run the stages again on the one pixel, up to the first value that is not finite."""
    at = np.array([row]), np.array([column])
    for stage, inputs, results in run_stages(work, *at, draw_values(work, *at)):
        if not all(np.isfinite(part).all() for value in results.values() for part in components(value)):
            named = zip(stage.reads.values(), inputs, strict=True)
            listed = ", ".join(f"{read} = {_shown(value)}" for read, value in named if _shown(value))
            return f"stage {stage.name}, pixel {column},{row}: result is not finite; inputs: {listed}"
    return f"pass {work.this_pass.name}, pixel {column},{row}: buffer {name} is not finite"


def _shown(value: Any) -> str:
    """An input in a message: its components; textures, arrays and matrices are left out."""
    if isinstance(value, Texture | Array) or hasattr(value, "rows"):
        return ""
    return " ".join(str(np.ravel(part)[0]) for part in components(value))
