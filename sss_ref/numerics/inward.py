"""The numbers of a buffer's type that lie in an interval, and those no farther from a number than a reach."""

import numpy as np

SIGN = np.int64(1) << 31
INT32 = np.iinfo(np.int32)


def float32_within(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The least and the largest float32 between float64 ends; the least above the largest where there is none."""
    with np.errstate(over="ignore"):
        least, most = low.astype(np.float32), high.astype(np.float32)
    least = np.where(least < low, np.nextafter(least, np.float32(np.inf)), least)
    return least, np.where(most > high, np.nextafter(most, np.float32(-np.inf)), most)


def no_farther(middle: np.ndarray, reach: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The least and the largest number whose distance from the middle, in float64, is at most the reach.

    middle: float32, int32, or uint8 that is 0 or 1; the ends have its type and shape. reach: float64 of that shape.
    """
    if middle.dtype.kind != "f":
        least, most = (0, 1) if middle.dtype == np.uint8 else (INT32.min, INT32.max)
        ends = (np.clip(middle + way * np.floor(reach), least, most).astype(middle.dtype) for way in (-1, 1))
        low, high = ends
        return low, high
    return _farthest(middle, reach, -1), _farthest(middle, reach, 1)


def ordered(numbers: np.ndarray) -> np.ndarray:
    """Numbers as integers, int64, in the same order and without gaps: of floats their bits, -0 and 0 as one."""
    if numbers.dtype.kind != "f":
        return numbers.astype(np.int64)
    bits = np.ascontiguousarray(numbers).view(np.int32).astype(np.int64)
    return np.where(bits < 0, -SIGN - bits, bits)


def _farthest(middle: np.ndarray, reach: np.ndarray, side: int) -> np.ndarray:
    """Bisected, as the distance is rounded too: near 0 many float32 are as far from 1."""
    end = np.where(np.isinf(reach) & np.isfinite(middle), np.float32(side * np.inf), middle)
    open_ones = (reach > 0) & np.isfinite(reach)
    exact, most = middle[open_ones].astype(np.float64), reach[open_ones]
    start = ordered(middle[open_ones])
    near, far = np.zeros_like(start), ordered(np.full(start.shape, np.inf, np.float32)) - side * start
    while (far - near > 1).any():
        between = (near + far) // 2
        within = np.abs(exact - _numbers(start + side * between).astype(np.float64)) <= most
        near, far = np.where(within, between, near), np.where(within, far, between)
    end[open_ones] = _numbers(start + side * near)
    return end


def _numbers(places: np.ndarray) -> np.ndarray:
    """The float32 that integers stand for, as `ordered` gives them."""
    return np.where(places < 0, -SIGN - places, places).astype(np.int32).view(np.float32)
