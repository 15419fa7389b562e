"""What can happen to a buffer between the shader that writes it and the file that is read."""

from collections.abc import Iterator

import numpy as np

from sss_ref.dump.srgb import srgb_decoded, srgb_encoded
from sss_ref.validation.accept.rebased import RASTERIZER, Check
from sss_ref.validation.cause.formats import formats
from sss_ref.validation.cause.hypothesis import INPUT, SETTING, Charge
from sss_ref.validation.verdict.outcomes import distance


def changes_on_the_way(check: Check) -> Iterator[tuple[Charge, np.ndarray, np.ndarray]]:
    """Every such mishap, where it explains what was got, bool (H, W), and where that can be told."""
    flipped = check.where & check.where[::-1]
    yield Charge("its rows are upside down", SETTING), within(check, check.got[::-1], check.expected), flipped
    if check.expected.dtype == np.float32:
        changed = _other_depths if check.stage == RASTERIZER else _changed
        for charge, expected in changed(check.expected):
            yield charge, within(check, check.got, expected), check.where
        yield from ((charge, within(check, check.got, masked), check.where) for charge, masked in _masked(check))
        yield from ((Charge(text, SETTING), holds, check.where) for text, holds in formats(check))


def _masked(check: Check) -> Iterator[tuple[Charge, np.ndarray]]:
    """A channel that holds the same all over, as one does that a colour mask leaves out."""
    for channel in range(check.got.shape[2] if check.got.ndim == 3 else 0):
        held = check.got[..., channel]
        if (held == held[0, 0]).all():
            masked = check.expected.copy()
            masked[..., channel] = held
            yield Charge(f"its channel {channel} is not written, and is {held[0, 0]:g} all over", SETTING), masked


def within(check: Check, got: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """Bool (H, W): where two versions of a buffer lie within its reach of each other."""
    near = distance(np.atleast_3d(got), np.atleast_3d(expected)) <= np.atleast_3d(check.reach)
    return np.logical_and.reduce(near, axis=-1)


def _other_depths(expected: np.ndarray) -> Iterator[tuple[Charge, np.ndarray]]:
    """A depth of the other convention of clip space, and one that falls.

    Taken is from -w to w, as the matrices of a scene are made: a z from 0 to w is another matrix's, while one that is
    right and taken from 0 to w is drawn in another state.
    """
    made = "its z was made for the other convention: from 0 to w, where -w to w is taken"
    yield Charge(made, INPUT), expected * 0.5 + 0.5
    taken = "its z was made from -w to w, where the other convention is taken, 0 to w"
    yield Charge(taken, SETTING), expected * 2 - 1
    yield Charge("it is reversed, 1 near and 0 far: choose such a profile", SETTING), 1 - expected


def _changed(expected: np.ndarray) -> Iterator[tuple[Charge, np.ndarray]]:
    """A float buffer after each mishap."""
    yield from ((Charge(text, SETTING), changed) for text, changed in _stored_otherwise(expected))


def _stored_otherwise(expected: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    unit = np.clip(expected, 0, 1)
    yield "it was cut off at 0 and 1", unit
    yield "it is sRGB-encoded", srgb_encoded(expected)
    yield "it is sRGB-decoded", srgb_decoded(expected)
    yield "its sign is turned", -expected
    yield "it is n*.5+.5", expected * 0.5 + 0.5
    if expected.ndim == 3:
        yield "its channels are in reverse order", expected[..., ::-1]
    if expected.shape[2:] == (2,):
        yield "its v is measured from the top", np.stack([expected[..., 0], 1 - expected[..., 1]], axis=-1)
