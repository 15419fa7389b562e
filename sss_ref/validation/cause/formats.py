"""Formats of textures, recognised from the values: all of them are numbers that the format has."""

from collections.abc import Iterator

import numpy as np

from sss_ref.dump.held import HELD, NEARLY
from sss_ref.dump.loss import SHARED_MANTISSA, loss_of, shared_exponent
from sss_ref.validation.accept.rebased import Check

FORMATS = {  # storage -> what it is called, narrow ones first
    "unorm8": "8-bit unorm",
    "srgb8": "sRGB8",
    "rgb10a2": "RGB10A2",
    "unorm16": "16-bit unorm",
    "r11g11b10f": "R11G11B10F",
    "rgb9e5": "RGB9E5",
    "float16": "float16",
}
OF_COLOURS = ("rgb10a2", "r11g11b10f", "rgb9e5")  # those with three channels


def formats(check: Check) -> Iterator[tuple[str, np.ndarray]]:
    """The formats whose numbers the compared pixels hold and no others, narrow ones first, and where they explain them.

    Explained are pixels within a step of what they should hold, cut off at the ends of the format's range.
    """
    got, expected = np.atleast_3d(check.got).astype(np.float64), np.atleast_3d(check.expected).astype(np.float64)
    here = got[check.where]
    for storage, name in FORMATS.items():
        if (storage not in OF_COLOURS or got.shape[2] == 3) and np.isfinite(here).all():
            with np.errstate(over="ignore"):
                same = np.abs(HELD[storage](here) - here) <= np.abs(here) * NEARLY
            if same.all():
                text = f'it was stored as {name}: declare encoding = "{storage}"'
                yield text, _within_a_step(storage, got, expected, check)


def _within_a_step(storage: str, got: np.ndarray, expected: np.ndarray, check: Check) -> np.ndarray:
    """Bool (H, W): where what was got is a neighbour of what was expected."""
    is_shared = storage == "rgb9e5"
    loss = shared_exponent(got) if is_shared else loss_of(storage)
    step = got.max(axis=-1, keepdims=True) * SHARED_MANTISSA if is_shared else loss.step(got)
    near = np.abs(got - np.clip(expected, loss.low, loss.high)) <= step + np.atleast_3d(check.reach)
    return np.logical_and.reduce(near, axis=-1)
