"""Exercises whose answer is a stage: read by the language's own front end, and run beside the right one."""

import difflib
import re
from collections.abc import Mapping
from types import FunctionType
from typing import Any

import numpy as np

from sss_ref.course.checks.answers import NotYet, near, outcome
from sss_ref.course.checks.kinds import described
from sss_ref.errors import StageError
from sss_ref.language import Stage, stage
from sss_ref.language.typing_rules import type_name

SOURCE = "an exercise"
PLACE = re.compile(r"^.*?:(\d+): (?:in \w+: )?")  # what a message of the front end begins with


def compared(answer: Any, right: Stage, given: Mapping[str, Any], hint: str, exact: bool = False) -> None:
    """Raise NotYet unless a written stage gives what the right one does on some fragments.

    given: each name that it may read -> values, one for all fragments or one for each. hint: where to look.
    exact: in every bit; else to five digits.
    """
    written = stage_of(answer)
    _check_names(written, right, given)
    got = outcome(written, *(given[name] for name in written.parameters))
    expected = right(*(given[name] for name in right.parameters))
    for name in right.outputs:
        mine, theirs = (_rows(each._asdict()[name]) for each in (got, expected))
        wrong = np.flatnonzero(_apart(mine, theirs, exact))
        if wrong.size:
            how = "has other bits" if exact else "is wrong"
            raise NotYet(f"`{name}` {how} at {wrong.size} of {len(theirs)} fragments. {hint}")


def stage_of(answer: Any) -> Stage:
    """A reader's function as a stage; raises NotYet, with the line, where it is not in the language."""
    if isinstance(answer, Stage):
        return answer
    if not isinstance(answer, FunctionType) or answer.__name__ == "<lambda>":
        raise NotYet(f"what is checked is {described(answer)}: write the stage as a function with `def` and types.")
    try:
        return stage(SOURCE)(answer)
    except StageError as error:
        raise NotYet(PLACE.sub(r"line \1: ", str(error)) + ".") from None
    except Exception as error:  # of the signature's types, or of no source
        said = f"{type(error).__name__}: {error}"
        raise NotYet(f"that cannot be read as a stage: {said}. Is its first line as it was?") from None


def _check_names(written: Stage, right: Stage, given: Mapping[str, Any]) -> None:
    for name, kind in right.outputs.items():
        if written.outputs.get(name) != kind:
            struct = right.result_struct.__name__
            raise NotYet(f"the stage has to give {struct}, whose `{name}` is a {type_name(kind)}: keep its `def` line.")
    for name, kind in written.parameters.items():
        if name not in given:
            near_name = difflib.get_close_matches(name, given, n=1)
            what = (
                f"did you mean `{near_name[0]}`?" if near_name else f"there are {', '.join(sorted(right.parameters))}."
            )
            raise NotYet(f"nothing is called `{name}`: {what}")
        if name in right.parameters and right.parameters[name] != kind:
            raise NotYet(f"`{name}` is a {type_name(right.parameters[name])}, not a {type_name(kind)}.")


def _rows(value: Any) -> np.ndarray:
    """What a stage gives for N fragments as an array (N, components)."""
    parts = [*value] if hasattr(value, "count") and not isinstance(value, (np.ndarray, np.generic)) else [value]
    return np.stack(np.broadcast_arrays(*parts), axis=-1).reshape(-1, len(parts))


def _apart(mine: np.ndarray, theirs: np.ndarray, exact: bool) -> np.ndarray:
    """Which fragments differ."""
    mine = np.broadcast_to(mine, theirs.shape)
    if exact:
        return np.asarray((mine != theirs).any(axis=-1))
    return ~np.array([near(a.astype(float), b.astype(float)) for a, b in zip(mine, theirs, strict=True)])
