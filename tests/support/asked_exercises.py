"""What the exercises ask of an answer, and what they say to one that is a little off; as a program it prints both.

python tests/support/asked_exercises.py > tests/course/exercises.txt
"""

import contextlib
import functools
import io
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from exercise_answers import kind_of, solutions

from sss_ref.course import checks
from sss_ref.course.checks.fragments import fragments
from sss_ref.language.types import Array, Texture, components

MANY = 9  # names given, of more only what their values are in the mean
SHOWN = 16  # calls of an answer; of more only how many there are, and what they were called with in all


EXERCISES = {check.__name__: (check, answer) for check, answer in solutions().items() if kind_of(check) != "port"}


def parts() -> list[str]:
    """The names of all parts: the fragments, and each exercise but those that are compared with a rendering."""
    return ["fragments", *EXERCISES]


def part(name: str) -> str:
    """What an exercise asks, and what it says to what is a hundredth too much or too little."""
    if name == "fragments":
        return "\n".join(["[fragments]", *(f"{each}: {brief(value)}" for each, value in fragments(5).items())])
    check, solution = EXERCISES[name]
    off = [said(check, scaled(solution, factor)) for factor in (1.01, 0.99)] if kind_of(check) == "line" else []
    return "\n".join([f"[{name}]", *asked(check, solution), *off])


def asked(check: Callable[[Any], None], solution: Any) -> Iterator[str]:
    """The calls of a solution while it is checked, and what it is compared with."""
    module, calls = import_module(check.__module__), []
    with pytest.MonkeyPatch.context() as patched:
        for name in ("called", "compared", "compared_glsl"):
            if hasattr(module, name):
                patched.setattr(module, name, functools.partial(noted, calls, name, getattr(module, name)))
        check(solution)
    yield from (f"{name} {', '.join(given)}" for name, given, _ in calls[:SHOWN])
    if len(calls) > SHOWN:
        yield f"{len(calls)} in all, of {sum(total for *_, total in calls):.6g}"


def noted(calls: list[Any], name: str, original: Callable[..., Any], answer: Any, *given: Any, **named: Any) -> Any:
    """A call of an answer, which goes on unless it would draw."""
    shown = [brief(each) for each in (*given, *named.values())]
    calls.append(
        (name, shown, sum(float(np.sum(each)) for each in given if isinstance(each, int | float | np.ndarray)))
    )
    return None if name == "compared_glsl" else original(answer, *given, **named)


def scaled(solution: Callable[..., Any], factor: float) -> Callable[..., Any]:
    """A solution whose numbers are larger or smaller."""

    @functools.wraps(solution)
    def answer(*given: Any) -> Any:
        value = solution(*given)
        return value if isinstance(value, bool | np.bool_ | dict | str | list | tuple) else value * factor

    return answer


def said(check: Callable[[Any], None], answer: Any) -> str:
    """What a reader is told."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        checks.verdict(check, answer)
    return printed.getvalue().strip()


def brief(value: Any) -> str:
    """A value in a few words: of many numbers the mean and how far they spread."""
    if isinstance(value, dict) and len(value) > MANY:
        return f"{len(value)} names, {np.mean([np.mean(components(each)) for each in value.values()]):.6g}"
    if isinstance(value, dict):
        return "; ".join(f"{name}: {brief(each)}" for name, each in value.items())
    if isinstance(value, Texture | Array):
        return brief(value.data)
    if isinstance(value, str | bool | np.bool_ | type(None)):
        return repr(value)
    if isinstance(value, list | tuple) and not hasattr(value, "x"):
        return f"[{', '.join(map(brief, value))}]"
    if hasattr(value, "words"):
        return value.words
    if hasattr(value, "python"):
        return value.name
    numbers = np.asarray(components(value), np.float64)
    if numbers.size <= 4:
        return " ".join(f"{each:.6g}" for each in numbers.flat)
    return f"{' x '.join(map(str, numbers.shape))} of {numbers.mean():.6g} +- {numbers.std():.6g}"


if __name__ == "__main__":
    print("\n\n".join(map(part, parts())))
