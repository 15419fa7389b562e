"""Formats of textures, recognised from the values: all of them are numbers that the format has."""

from collections.abc import Callable, Iterator

import numpy as np

from sss_ref.dump.loss import SHARED_MANTISSA, loss_of
from sss_ref.dump.srgb import srgb_decoded, srgb_encoded
from sss_ref.validation.accept.rebased import Check

NEARLY = 2.0**-22  # relative: two ways from a code to a float32 may round differently
LARGEST_SHARED = 65408.0
Held = Callable[[np.ndarray], np.ndarray]


def formats(check: Check) -> Iterator[tuple[str, np.ndarray]]:
    """The formats whose numbers the compared pixels hold and no others, narrow ones first, and where they explain them.

    Explained are pixels within a step of what they should hold, cut off at the ends of the format's range.
    """
    got, expected = np.atleast_3d(check.got).astype(np.float64), np.atleast_3d(check.expected).astype(np.float64)
    here = got[check.where]
    for name, (held, storages) in FORMATS.items():
        if len(storages) in (1, got.shape[2]) and np.isfinite(here).all():
            with np.errstate(over="ignore"):
                same = np.abs(held(here) - here) <= np.abs(here) * NEARLY
            if same.all():
                yield f"it was stored as {name}", _within_a_step(name, storages, got, expected, check)


def _within_a_step(
    name: str, storages: tuple[str, ...], got: np.ndarray, expected: np.ndarray, check: Check
) -> np.ndarray:
    """Bool (H, W): where what was got is a neighbour of what was expected."""
    losses = [loss_of(storage) for storage in (storages * got.shape[2])[: got.shape[2]]]
    ends = np.array([(each.low, each.high) for each in losses]).T
    step = np.stack([each.step(got[..., k]) for k, each in enumerate(losses)], axis=-1)
    if name == "RGB9E5":
        ends, step = np.array([[0.0], [LARGEST_SHARED]]), got.max(axis=-1, keepdims=True) * SHARED_MANTISSA
    near = np.abs(got - np.clip(expected, *ends)) <= step + np.atleast_3d(check.reach)
    return np.logical_and.reduce(near, axis=-1)


def _floats(*bits: int) -> Held:
    """Floats without a sign, five bits of exponent and so many of mantissa, for each channel."""

    def held(values: np.ndarray) -> np.ndarray:
        _, exponent = np.frexp(values)
        step = np.ldexp(1.0, np.maximum(exponent - 1, -14) - np.array(bits))
        return np.maximum(np.rint(values / step) * step, 0.0)

    return held


def _shared(values: np.ndarray) -> np.ndarray:
    """Nine bits of each channel below the exponent of the largest."""
    _, exponent = np.frexp(values.max(axis=-1, keepdims=True, initial=0.0))
    step = np.ldexp(1.0, np.maximum(exponent, -15) - 9)
    return np.clip(np.rint(values / step) * step, 0.0, LARGEST_SHARED)


def _codes(largest: int) -> Held:
    return lambda values: np.rint(np.clip(values, 0, 1) * largest) / largest


def _srgb_codes(values: np.ndarray) -> np.ndarray:
    return srgb_decoded(_codes(255)(srgb_encoded(values)))


def _halves(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float16).astype(np.float64)


FORMATS: dict[str, tuple[Held, tuple[str, ...]]] = {
    "8-bit unorm": (_codes(255), ("unorm8",)),
    "sRGB8": (_srgb_codes, ("srgb8",)),
    "RGB10A2": (_codes(1023), ("unorm10",) * 3),
    "16-bit unorm": (_codes(65535), ("unorm16",)),
    "R11G11B10F": (_floats(6, 6, 5), ("float11", "float11", "float10")),
    "RGB9E5": (_shared, ("float9",) * 3),
    "float16": (_halves, ("float16",)),
}
