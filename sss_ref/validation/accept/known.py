"""What is known of a name: what it is here, beside all that it may be on a right processor; the two never part."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, get_origin

import numpy as np

from sss_ref.interpret.intervals.enclosing import NO_DOUBT
from sss_ref.interpret.intervals.value_sets import Texels, componentwise
from sss_ref.interpret.work import buffer_value
from sss_ref.language.types import Texture, components
from sss_ref.numerics.interval import Interval

Pixels = tuple[np.ndarray, np.ndarray]  # rows, columns


@dataclass(frozen=True, eq=False)
class Known:
    """A value of the language at some pixels.

    exact: as the array interpreter has it. bounds: the same on intervals; or once more the exact value, where it can be
    no other. doubt: uint8, whether it is one of several, as in `Outcome`.
    """

    exact: Any
    bounds: Any
    doubt: Any = NO_DOUBT

    @classmethod
    def exactly(cls, value: Any) -> "Known":
        """A value that can be no other."""
        return cls(value, value)

    @property
    def columns(self) -> np.ndarray:
        """The components of the exact value side by side: (N, C), or (1, C) for a uniform."""
        return stacked(self.exact)

    @property
    def reach(self) -> np.ndarray:
        """How far from its exact value its bounds lie, float64 (N, C); infinite where there are none."""
        parts = components(self.bounds)
        low, high = (np.stack([np.asarray(getattr(part, end)) for part in parts], axis=-1) for end in ("low", "high"))
        return _reach(self.columns, low, high)


@dataclass(frozen=True, eq=False)
class KnownBuffer:
    """A buffer at all its pixels: exact, low and high of one shape, (H, W) or (H, W, C); doubt: bool (H, W).

    span: the length of the range of its texture, where that has bytes; 0 of any other.
    """

    exact: np.ndarray
    low: np.ndarray
    high: np.ndarray
    doubt: np.ndarray
    span: float = 0.0

    @classmethod
    def exactly(cls, buffer: np.ndarray) -> "KnownBuffer":
        """A buffer that can hold nothing else."""
        return cls(buffer, buffer, buffer, np.zeros(buffer.shape[:2], bool))

    @property
    def is_exact(self) -> bool:
        """Whether it can hold nothing else."""
        return self.low is self.exact and self.high is self.exact

    def read(self, kind: Any, at: Pixels) -> Known:
        """As a stage reads it: whole as a texture, else its values at these pixels."""
        exact = buffer_value(kind, self.exact, *at)
        if get_origin(kind) is Texture:
            return Known(exact, Texels(self.low, self.high, self.span))
        if self.is_exact:
            return Known.exactly(exact)
        return Known(exact, componentwise(Interval, *(buffer_value(kind, end, *at) for end in (self.low, self.high))))

    def copy(self) -> "KnownBuffer":
        """The same, to be written to."""
        return replace(self, **{name: getattr(self, name).copy() for name in ("exact", "low", "high", "doubt")})

    def write(self, known: Known, at: Pixels) -> None:
        """Put what a stage wrote where it wrote it."""
        parts = components(known.bounds)
        _put(self.exact, components(known.exact), at)
        _put(self.low, [part.low for part in parts], at)
        _put(self.high, [part.high for part in parts], at)
        self.doubt[at] = known.doubt != 0

    def put(self, at: Pixels, exact: np.ndarray, low: np.ndarray, high: np.ndarray) -> None:
        """Put values with their ends at some pixels; it is in doubt where they differ."""
        for buffer, values in ((self.exact, exact), (self.low, low), (self.high, high)):
            buffer[at] = _within_type(values, buffer.dtype)
        apart = self.low[at] != self.high[at]
        self.doubt[at] = apart if apart.ndim == 1 else apart.any(axis=1)

    def include(self, buffer: np.ndarray, where: np.ndarray) -> None:
        """Let it hold the values of another buffer too where a mask, bool (H, W), says so."""
        self.low[where] = np.minimum(self.low[where], buffer[where])
        self.high[where] = np.maximum(self.high[where], buffer[where])

    @property
    def reach(self) -> np.ndarray:
        """How far from what it holds here its bounds lie, float64 of its shape; infinite where there are none."""
        return _reach(self.exact, self.low, self.high)


def pixels_of(where: np.ndarray) -> Pixels:
    """The pixels of a mask, bool (H, W), row by row."""
    rows, columns = np.nonzero(where)
    return rows, columns


def stacked(value: Any) -> np.ndarray:
    """The components of a value side by side: (N, C), or (1, C) for a uniform."""
    return np.stack(np.broadcast_arrays(*map(np.atleast_1d, components(value))), axis=1)


def _reach(exact: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    exact, low, high = np.broadcast_arrays(exact, low, high)  # a stage of uniforms gives one value for all pixels
    reach, apart = np.zeros(exact.shape), (low != exact) | (high != exact)
    middle = exact[apart].astype(np.float64)
    with np.errstate(invalid="ignore"):
        off = np.maximum(np.maximum(high[apart] - middle, middle - low[apart]), 0.0)
    reach[apart] = np.nan_to_num(off, nan=np.inf, posinf=np.inf)
    return reach


def _within_type(values: np.ndarray, dtype: np.dtype) -> np.ndarray:
    """Values that a buffer of a type can hold; of a truth value 0 and 1."""
    if dtype.kind == "f":
        return values
    least, most = (0, 1) if dtype == np.uint8 else (np.iinfo(dtype).min, np.iinfo(dtype).max)
    return np.clip(values, least, most)


def _put(buffer: np.ndarray, parts: Sequence[Any], at: Pixels) -> None:
    buffer[at] = parts[0] if buffer.ndim == 2 else np.stack(np.broadcast_arrays(*parts), axis=-1)
