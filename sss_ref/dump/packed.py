"""Texels whose channels share one unsigned integer, lowest bits first, and the floats of 11 and 10 bits."""

import numpy as np

# The small floats have the five exponent bits of float16 and no sign: their value is that of float16 with zeros below.
MANTISSA_OF_11, MANTISSA_OF_10, MANTISSA_OF_16 = 6, 5, 10


def r10g10b10a2(words: np.ndarray) -> np.ndarray:
    """uint32 (H, W) -> R, G, B = n/1023 and A = n/3, float32 (H, W, 4)."""
    fields = (0, 1023), (10, 1023), (20, 1023), (30, 3)
    return np.dstack([(words >> shift & top).astype(np.float32) / np.float32(top) for shift, top in fields])


def r11g11b10(words: np.ndarray) -> np.ndarray:
    """uint32 (H, W) -> R and G of 11 bits, B of 10, float32 (H, W, 3), exact."""
    fields = (words & 0x7FF, MANTISSA_OF_11), (words >> 11 & 0x7FF, MANTISSA_OF_11), (words >> 22, MANTISSA_OF_10)
    return np.dstack([_small_float(bits, mantissa) for bits, mantissa in fields])


def d24s8(words: np.ndarray) -> np.ndarray:
    """uint32 (H, W) -> depth n/(2^24 - 1) of the lower 24 bits, float32 (H, W, 1)."""
    return ((words & 0xFFFFFF).astype(np.float32) / np.float32(0xFFFFFF))[..., np.newaxis]


def d32s8(words: np.ndarray) -> np.ndarray:
    """uint64 (H, W) -> the float32 of the lower 32 bits (H, W, 1)."""
    return (words & 0xFFFFFFFF).astype(np.uint32).view(np.float32)[..., np.newaxis]


def r9g9b9e5(words: np.ndarray) -> np.ndarray:
    """uint32 (H, W) -> R, G, B of nine bits and one exponent e: n * 2^(e - 15 - 9), float32 (H, W, 3), exact."""
    fields = [(words >> shift & 0x1FF).astype(np.float32) for shift in (0, 9, 18)]
    return np.ldexp(np.dstack(fields), (words >> 27).astype(np.int32)[..., np.newaxis] - 24)


def _small_float(bits: np.ndarray, mantissa: int) -> np.ndarray:
    """Exponent e, fraction f of m bits: 2^(e-15) * (1 + f/2^m); e = 0: 2^-14 * f/2^m; e = 31: infinity or NaN."""
    return (bits << (MANTISSA_OF_16 - mantissa)).astype(np.uint16).view(np.float16).astype(np.float32)
