"""Draws that a test, a mask, a rectangle, a viewport or blending changed as a whole, seen from the buffer alone."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from sss_ref.validation.accept.case import Case
from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.cause.hypothesis import SETTING, Charge
from sss_ref.validation.cause.on_the_way import within
from sss_ref.validation.clock import Limit

FARTHEST = 8  # pixels by which a picture may lie off
CLOSE = 2.0**-16  # relative, of what is blended
Tried = Iterator[tuple[Charge, np.ndarray]]  # and the pixels that it explains, bool (H, W)


def cropped(case: Case, check: Check, limit: Limit) -> Tried:
    """What cuts a draw off, moves it by whole pixels or mixes it with what was there. limit: the time for a search."""
    shown = _shown(case, check)
    if shown.any():
        clear = np.asarray(case.oracle.scene.clear(check.buffer))
        yield _inside_rectangle(check, shown)
        yield from _nearer_than(case, check, shown)
        yield from _moved(check, clear, limit)
        yield from _blended(check, clear)


def undrawn(case: Case, check: Check) -> Tried:
    """That there is nothing of a draw, wherever the buffer holds what it is cleared to and no more."""
    if not (shown := _shown(case, check)).any():
        yield Charge("nothing is drawn: a test that nothing passes, or a mask", SETTING), ~shown


def _shown(case: Case, check: Check) -> np.ndarray:
    """Bool (H, W): where the buffer holds something else than what it is cleared to."""
    clear = np.asarray(case.oracle.scene.clear(check.buffer))
    shown: np.ndarray = np.logical_or.reduce(np.atleast_3d(check.got) != clear, axis=-1)
    return shown


def _inside_rectangle(check: Check, shown: np.ndarray) -> tuple[Charge, np.ndarray]:
    """The rectangle beyond which nothing is drawn."""
    (rows, columns), inside = np.nonzero(shown), np.zeros_like(shown)
    (bottom, top), (left, right) = (rows.min(), rows.max()), (columns.min(), columns.max())
    inside[bottom : top + 1, left : right + 1] = True
    text = f"nothing is drawn but in columns {left} to {right} and rows {bottom} to {top}: a scissor, or a viewport"
    return Charge(text, SETTING), ~inside | within(check, check.got, check.expected)


def _nearer_than(case: Case, check: Check, shown: np.ndarray) -> Tried:
    """The depth from which on nothing is drawn, between that of the last pixel shown and the first that is not."""
    depth = case.oracle.buffers.get(case.oracle.scene.method[check.pass_name].draw.depth)
    left_out = check.where & ~shown
    if depth is not None and (check.where & shown).any() and left_out.any():
        limit = float(depth[check.where & shown].max())
        text = f"nothing is drawn farther than depth {limit:.4g}: the depths were cleared to that"
        yield Charge(text, SETTING), np.where(shown, within(check, check.got, check.expected), depth >= limit)


def _moved(check: Check, clear: np.ndarray, limit: Limit) -> Tried:
    """The whole pixels by which the picture lies off that bring most of it back in place."""
    best, most = (0, 0), -1
    farthest = (min(FARTHEST, pixels - 1) for pixels in check.where.shape)
    offsets = product(*(range(-most, most + 1) for most in farthest))
    for up, right in limit.within("offsets by whole pixels", offsets):
        held = int((check.got == _shifted(check.expected, up, right, clear)).sum())
        best, most = ((up, right), held) if held > most else (best, most)
    if best != (0, 0):
        text = f"the picture lies {_offset(*best)}: a viewport"
        yield Charge(text, SETTING), within(check, check.got, _shifted(check.expected, *best, clear))


def _offset(up: int, right: int) -> str:
    """Whole pixels, in words."""
    sides = (right, "right" if right > 0 else "left"), (up, "up" if up > 0 else "down")
    return " and ".join(f"{abs(by)} pixel{'s' * (abs(by) > 1)} too far {side}" for by, side in sides if by)


def _blended(check: Check, clear: np.ndarray) -> Tried:
    """What blending makes of a triangle that is drawn onto what a buffer is cleared to."""
    if check.expected.dtype == np.float32:
        with np.errstate(over="ignore"):
            mixed = {"added to": check.expected + clear, "subtracted from": clear - check.expected}
            mixed["multiplied with"] = check.expected * clear
        for told, buffer in mixed.items():
            charge = Charge(f"it is {told} what the target is cleared to: blending", SETTING)
            with np.errstate(invalid="ignore", over="ignore"):
                near = np.abs(check.got - buffer) <= np.abs(buffer) * CLOSE + check.reach
            yield charge, np.logical_and.reduce(np.atleast_3d(near), axis=-1)


def _shifted(picture: np.ndarray, up: int, right: int, clear: np.ndarray) -> np.ndarray:
    """A picture moved by whole pixels; what comes in from beyond its edge is cleared."""
    height, width = picture.shape[:2]
    moved = np.empty_like(picture)
    moved[...] = clear
    to = slice(max(up, 0), height + min(up, 0)), slice(max(right, 0), width + min(right, 0))
    of = slice(max(-up, 0), height + min(-up, 0)), slice(max(-right, 0), width + min(-right, 0))
    moved[to] = picture[of]
    return moved
