"""What can happen to a buffer between the shader that writes it and the file that is read."""

from collections.abc import Iterator

import numpy as np

from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.verdict.outcomes import distance


def changes_on_the_way(check: Check) -> Iterator[tuple[str, float]]:
    """Every such mishap, and the share of the compared pixels that it explains."""
    flipped = check.where & check.where[::-1]
    yield "its rows are upside down", _share(within(check, check.got[::-1], check.expected), flipped)
    if check.expected.dtype == np.float32:
        for text, expected in _changed(check.expected):
            yield text, _share(within(check, check.got, expected), check.where)


def within(check: Check, got: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """Bool (H, W): where two versions of a buffer lie within its reach of each other."""
    near = distance(np.atleast_3d(got), np.atleast_3d(expected)) <= np.atleast_3d(check.reach)
    return np.logical_and.reduce(near, axis=-1)


def _share(holds: np.ndarray, where: np.ndarray) -> float:
    return float(holds[where].mean()) if where.any() else 0.0


def _changed(expected: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """A float buffer after each mishap."""
    unit = np.clip(expected, 0, 1)
    with np.errstate(over="ignore"):
        yield "it was stored as float16", expected.astype(np.float16).astype(np.float32)
    yield "it was stored as 8-bit unorm", np.rint(unit * 255) / 255
    yield "it was stored as 16-bit unorm", np.rint(unit * 65535) / 65535
    yield "it was cut off at 0 and 1", unit
    yield "it is sRGB-encoded", _srgb(expected)
    yield "it is sRGB-decoded", _linear(expected)
    yield "its sign is turned", -expected
    yield "it is n*.5+.5", expected * 0.5 + 0.5
    if expected.ndim == 3:
        yield "its channels are in reverse order", expected[..., ::-1]
    if expected.shape[2:] == (2,):
        yield "its v is measured from the top", np.stack([expected[..., 0], 1 - expected[..., 1]], axis=-1)


def _srgb(linear: np.ndarray) -> np.ndarray:
    v = np.clip(linear.astype(np.float64), 0, None)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def _linear(encoded: np.ndarray) -> np.ndarray:
    v = np.clip(encoded.astype(np.float64), 0, None)
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)
