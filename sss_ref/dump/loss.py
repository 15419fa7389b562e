"""What storage keeps of a number: the step between the numbers that it has, and the ends of its range."""

from dataclasses import dataclass

import numpy as np

INFINITY = float("inf")
DIAGONAL = 3**0.5
ROUNDING = 2.0**-23  # the step of float32, relative to the value
LARGEST_BYTE = 255


@dataclass(frozen=True)
class Loss:
    """How far what is held may be from what was given, in the unit of the buffer.

    relative, least: the step between neighbours, relative to the value and at least. low, high: the ends of the range:
    a value that is held there, or beyond as infinity, may have been anything beyond. flushed: the size below which a
    number may be kept as 0, the smallest normal one of small floats.
    """

    relative: float = 0.0
    least: float = 0.0
    low: float = -INFINITY
    high: float = INFINITY
    flushed: float = 0.0

    def step(self, values: np.ndarray) -> np.ndarray:
        """The step at these values, float64."""
        size = np.abs(values.astype(np.float64))
        return np.maximum(np.where(np.isfinite(size), size, 0.0) * self.relative, self.least)

    @property
    def span_of_bytes(self) -> float:
        """The length of its range, if bytes can tell so many steps in it; else 0."""
        span = self.high - self.low
        return span if np.isfinite(span) and self.least * LARGEST_BYTE > span * (1 - ROUNDING) else 0.0

    def spread(self, largest: float) -> "Loss":
        """The loss of vectors that were turned: of any component that of the whole, three steps at right angles."""
        return Loss(least=DIAGONAL * max(largest * self.relative, self.least, self.flushed) + largest * ROUNDING)

    def unclamped(self) -> "Loss":
        """The same step without ends."""
        return Loss(self.relative, self.least, flushed=self.flushed)

    def scaled(self, scale: float, offset: float, largest: float) -> "Loss":
        """Of value = stored * scale + offset, rounded once to float32. largest: of the stored values, by size."""
        low, high = sorted(float(np.float32(end * scale + offset)) for end in (self.low, self.high))
        least, flushed = self.least * abs(scale), self.flushed * abs(scale)
        if offset:
            step = max(least, flushed, self.relative * abs(scale) * largest)
            return Loss(0.0, step + ROUNDING * (abs(scale) * largest + abs(offset)), low, high)
        return Loss(self.relative + ROUNDING, least, low, high, flushed)


EXACT = Loss()
LARGEST_HALF = 65504.0  # what lies beyond is kept as this or as infinity: a conversion may cut off or round
LOSSES = {
    "float16": Loss(2.0**-10, 2.0**-24, -LARGEST_HALF, LARGEST_HALF, 2.0**-14),
    "float24": Loss(2.0**-15, 2.0**-141),
    "r11g11b10f": Loss(2.0**-5, 2.0**-19, 0.0, 64512.0, 2.0**-14),  # those of blue, which has the fewest bits
    "unorm8": Loss(0.0, 1 / 255, 0.0, 1.0),
    "rgb10a2": Loss(0.0, 1 / 1023, 0.0, 1.0),
    "unorm16": Loss(0.0, 1 / 65535, 0.0, 1.0),
    "unorm24": Loss(0.0, 1 / (2**24 - 1), 0.0, 1.0),
    "snorm8": Loss(0.0, 1 / 127, -1.0, 1.0),
    "snorm16": Loss(0.0, 1 / 32767, -1.0, 1.0),
    "srgb8": Loss(0.0, 3.3 / 255, 0.0, 1.0),  # a code near white stands for more linear light than one near black
}
"""Storage -> its loss, of those that hold fewer numbers than float32."""

LARGEST_SHARED = 65408.0
SHARED_MANTISSA = 2.0**-8  # R9G9B9E5 has nine bits of each channel, counted from the first of the largest channel


def loss_of(storage: str | Loss) -> Loss:
    """The loss of a storage by its name, none for float32 and integers; a loss is its own."""
    return storage if isinstance(storage, Loss) else LOSSES.get(storage, EXACT)


def shared_exponent(data: np.ndarray) -> Loss:
    """The loss of texels (H, W, C) that share an exponent: the step of the largest value of all."""
    finite = data[np.isfinite(data)]
    return Loss(0.0, float(np.abs(finite).max(initial=0.0)) * SHARED_MANTISSA, 0.0, LARGEST_SHARED)
