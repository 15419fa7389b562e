"""What a reader's function comes to: a value of the right kind, or a hint about what it is instead."""

import inspect
import linecache
import traceback
from collections.abc import Callable
from types import GeneratorType
from typing import Any

import numpy as np

from sss_ref.course.checks.kinds import Kind, described


class NotYet(Exception):
    """What is still wrong with an answer, in a sentence or two that do not give the answer away."""


class NotChecked(Exception):
    """What this machine lacks to check an answer."""


def verdict(check: Callable[[Any], None], answer: Any) -> None:
    """Print what a check finds, so that a notebook runs on whatever the answer."""
    try:
        check(answer)
    except NotYet as hint:
        print("Not yet:", hint)
    except NotChecked as reason:
        print("Not checked:", reason)
    else:
        print("Right.")


def near(value: Any, expected: Any) -> bool:
    """Whether two numbers, or the numbers of two arrays, agree to five digits: an answer need not round as we do."""
    return np.shape(value) == np.shape(expected) and bool(np.allclose(value, expected, rtol=1e-5, atol=1e-7))


def called(answer: Any, kind: Kind, *given: Any) -> Any:
    """What a reader's function gives for some arguments, as a value of a kind.

    Raises NotYet where it is no function, does not take them, stops with an error, or gives something else.
    """
    check_function(answer, len(given))
    value = outcome(answer, *given)
    if value is None:
        raise NotYet("your function gives nothing back. Does every way through it end with `return`?")
    if isinstance(value, GeneratorType):
        raise NotYet("your function gives its values one by one: it says `yield` where it should say `return`.")
    read = kind.read(value)
    if read is None:
        raise NotYet(f"your function gives {described(value)}, where {kind.words} is expected.")
    if kind.numeric and not np.isfinite(read).all():
        raise NotYet("your function gives nan or infinity: a division by 0, or the root of a negative number?")
    return read


def check_function(answer: Any, count: int) -> None:
    """Raise NotYet unless an answer is a function of so many arguments."""
    if not callable(answer):
        raise NotYet(f"what is checked is {described(answer)}, not a function: give its name alone, without brackets.")
    try:
        inspect.signature(answer).bind(*range(count))
    except (TypeError, ValueError):
        many = f"{count} arguments" if count != 1 else "one argument"
        raise NotYet(f"your function is called with {many}, which it does not take: keep its `def` line.") from None


def outcome(answer: Callable[..., Any], *given: Any) -> Any:
    """What a function returns; raises NotYet, with the line, where it stops with an error."""
    try:
        with np.errstate(all="ignore"):
            return answer(*given)
    except (Exception, SystemExit) as error:
        said = " ".join(str(error).split())
        raise NotYet(f"your function stops with {type(error).__name__}{_where(error, answer)}: {said or '-'}") from None


def _where(error: BaseException, answer: Callable[..., Any]) -> str:
    """The last line of the reader's that ran, as ' in `line`'; nothing where its source is not known."""
    file = getattr(getattr(answer, "__code__", None), "co_filename", None)
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    line = linecache.getline(own[-1].filename, own[-1].lineno or 0).strip() if own else ""
    return f" in `{line}`" if line else ""
