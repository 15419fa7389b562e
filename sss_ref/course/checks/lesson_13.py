"""The exercises of lesson 13: the method, written by the reader in NumPy."""

import difflib
import inspect
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, check_function, outcome
from sss_ref.course.checks.kinds import described
from sss_ref.course.project import as_buffer, judged, oracle, readable


def own_stored_distance(answer: Any) -> None:
    """A port: what the shadow map stores where a fragment falls on it."""
    _held(answer, "stored_distance", "Which texel holds the fragment, and what is said where the map holds nothing?")


def own_directly_lit(answer: Any) -> None:
    """A port: whether the light reaches a fragment, with the bias of lesson 2."""
    _held(answer, "directly_lit", "Does it face the light, and how far behind the stored surface may it lie?")


def own_phong(answer: Any) -> None:
    """A port: Phong's three terms."""
    _held(answer, "phong", "Look at one term at a time: set the weights of the others to 0 in your mind.")


def own_thickness(answer: Any) -> None:
    """A port: the way of the light inside the body."""
    _held(answer, "thickness", "Where did the light enter, and how far is it from there?")


def own_translucency(answer: Any) -> None:
    """A port: what the thickness leaves of the light."""
    _held(answer, "translucency", "Three cases: lit directly, outside the map, and through the body.")


def own_lit(answer: Any) -> None:
    """A port: the light that is reflected and the light that came through."""
    _held(answer, "lit", "What is left of Phong in the shadow, and what does light need that enters from behind?")


def own_scattered(answer: Any) -> None:
    """A port: the thirteen taps."""
    _held(answer, "scattered", "Try it on a single white pixel: where do the taps go, and what lies between pixels?")


def own_image(answer: Any) -> None:
    """A port: the model before its background."""
    _held(answer, "image", "What does a pixel show that the model does not cover?")


def _held(answer: Any, buffer: str, hint: str) -> None:
    """Raise NotYet unless a function gives a buffer that a right processor may have drawn."""
    value = _pictured(outcome(answer, *_arguments(answer, buffer)), buffer)
    if not np.isfinite(value[oracle()["coverage"] != 0]).all():
        raise NotYet("your picture has nan or infinity on the model: a division by 0, or a negative root?")
    verdict = judged(buffer, as_buffer(buffer, value))
    wrong = verdict.compared - verdict.within
    if wrong:
        raise NotYet(f"`{buffer}` is out of reach at {wrong} of {verdict.compared} pixels. {hint}")


def _arguments(answer: Any, buffer: str) -> list[Any]:
    """What a function reads, by the names of its parameters."""
    if not callable(answer):
        check_function(answer, 0)
    known = readable(buffer)
    names = list(inspect.signature(answer).parameters)
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(name, known, n=1)
            what = f"did you mean `{near[0]}`?" if near else "name the buffers before it, or uniforms."
            raise NotYet(f"nothing is called `{name}` before `{buffer}` is written: {what}")
    return [known[name].copy() if isinstance(known[name], np.ndarray) else known[name] for name in names]


def _pictured(value: Any, buffer: str) -> np.ndarray:
    """What a function gave as an array of the buffer's shape."""
    shape = oracle()[buffer].shape
    if value is None:
        raise NotYet("your function gives nothing back. Does every way through it end with `return`?")
    if not isinstance(value, np.ndarray) or value.shape != shape or value.dtype.kind not in "fiub":
        raise NotYet(f"your function gives {described(value)}, where numbers of shape {shape} are expected.")
    return value
