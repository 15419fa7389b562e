"""What is wrong with a scene file, told one line per problem: where, what was expected, what came, what to do."""

import difflib
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from pydantic_core import ErrorDetails, PydanticCustomError

KeyPath = tuple[str | int, ...]

LONGEST_EXPECTED, LONGEST_CAME = 500, 400  # characters

# What pydantic finds by itself: its error type, what was expected, what to do.
FOUND_BY_TYPE = {
    "float_type": ("a number", "write it without quotes, such as 1.5"),
    "finite_number": ("a finite number", "nan and inf are not accepted"),
    "int_type": ("a whole number", "write it without quotes or decimal point, such as 1024"),
    "string_type": ("a text", "put it in double quotes"),
    "bool_type": ("true or false", "write it without quotes"),
    "tuple_type": ("an array", "put the values in brackets, separated by commas"),
    "list_type": ("an array", "put the values in brackets, separated by commas"),
    "too_long": ("{max_length} values", "remove the others"),
    "literal_error": ("{expected}", "choose one of these"),
    "union_tag_invalid": ("{expected_tags}", "choose one of these"),
    "union_tag_not_found": ("a type", 'add type = "orbit", "look_at", "free" or "orthographic"'),
    "missing": ("a value", "add it"),
    "dict_type": ("a table", "give its keys, each with a value"),
    "model_type": ("a table", "give its keys, each with a value"),
    "model_attributes_type": ("a table", "give its keys, each with a value"),
}

# Where a value may have one of several forms, pydantic inserts the form's name after these keys.
ANY = -1  # the place of every element of an array
CHOICES: tuple[KeyPath, ...] = (
    ("camera",),
    ("lights", ANY),
    ("mesh", "color"),
    ("blur", "kernel"),
    *(
        (*table, key)
        for table in (("translucency",), ("layers", ANY, "translucency"))
        for key in ("x", "y", "exponent", "scale", "d_min", "gaussians")
    ),
)


def unmet(expected: str, remedy: str, came: str | None = None) -> PydanticCustomError:
    """The error a validator raises: what it expected and what to do; `described` adds the rest.

    came: what to say instead of the value.
    """
    context = {"expected": expected, "remedy": remedy, "came": came}
    return PydanticCustomError("unmet", "expected {expected}; {remedy}", context)


def unmet_at(key: KeyPath, expected: str, came: str, remedy: str) -> PydanticCustomError:
    """The error of a validator that has found a problem of several keys together: told under the one that is given."""
    context = {"key": key, "expected": expected, "came": came, "remedy": remedy}
    return PydanticCustomError("unmet", "expected {expected}, got {came}; {remedy}", context)


def told(where: str, expected: str, came: str, remedy: str) -> str:
    """One problem as the user reads it: in one line, whatever came, and nothing that a terminal would carry out."""
    return printable(f"{where}: expected {cut(expected, LONGEST_EXPECTED)}, got {cut(came, LONGEST_CAME)}; {remedy}")


def printable(text: str) -> str:
    """A text with what cannot be printed, ends of lines too, spelt as Python does."""
    return "".join(each if each.isprintable() else repr(each)[1:-1] for each in text)


def cut(text: str, length: int = 60) -> str:
    """A text that may be long, cut to so many characters."""
    return text if len(text) <= length else f"{text[: length - 3]}..."


def gibibytes(size: int) -> str:
    """An amount of memory as the user reads it."""
    return f"{size / 2**30:.3g} GiB"


def described(error: ErrorDetails, known: Iterable[str]) -> tuple[KeyPath, str]:
    """The key path of a validation error, and the problem without its file.

    known: the keys of the table the error is in, for the nearest name of an unknown one.
    """
    context = error.get("ctx", {})
    path = context.get("key") or key_path(error["loc"])
    if error["type"] == "extra_forbidden":
        return path, told(written(path), "a known key", "this one", nearest(str(path[-1]), known))
    expected, remedy = _expectation(error)
    if error["type"] == "union_tag_invalid":
        path, came = _choice(path, context["discriminator"], error["input"])
        return path, told(written(path), expected, came, remedy)
    came = "nothing" if error["type"] == "missing" else context.get("came") or shown(error["input"])
    return path, told(written(path), expected, came, remedy)


def key_path(location: Sequence[str | int]) -> KeyPath:
    """Pydantic's location without the names of alternative forms."""
    for keys in CHOICES:
        if tuple(ANY if isinstance(part, int) else part for part in location[: len(keys)]) == keys:
            return (*location[: len(keys)], *location[len(keys) + 1 :])
    return tuple(location)


def written(path: KeyPath) -> str:
    """A key path as the user would write it: lights[0].position."""
    text = "".join(f"[{part}]" if isinstance(part, int) else f".{cut(part)}" for part in path)
    return text.removeprefix(".") or "scene"


def shown(value: Any) -> str:
    """A value as TOML would show it, cut to a line's length."""
    try:
        text = json.dumps(value, default=str)
    except (TypeError, ValueError, RecursionError):  # a key that is no text, an integer of thousands of digits, a cycle
        text = f"a value of type {type(value).__name__}"
    return cut(text)


def _expectation(error: ErrorDetails) -> tuple[str, str]:
    context = error.get("ctx", {})
    if error["type"] == "unmet":
        return context["expected"], context["remedy"]
    expected, remedy = FOUND_BY_TYPE.get(error["type"], (error["msg"], "correct it"))
    if "expected_tags" in context:
        *others, last = context["expected_tags"].split(", ")
        context = {**context, "expected_tags": f"{', '.join(others)} or {last}"}
    return expected.format(**context).replace("'", '"'), remedy


def _choice(path: KeyPath, discriminator: str, table: Mapping[str, Any]) -> tuple[KeyPath, str]:
    """Where the key stands by which a table chooses its form, and what it says; the whole table if none alone does."""
    keys = [key for key in (discriminator.strip("'"), "type") if key in table]
    return ((*path, keys[0]), shown(table[keys[0]])) if keys else (path, shown(table))


def nearest(key: str, known: Iterable[str]) -> str:
    """What to do about an unknown key: take the known one that is nearest, or none."""
    known = sorted(known)
    near = difflib.get_close_matches(key, known, n=1)
    return f"did you mean {near[0]}?" if near else f"remove it (known here: {', '.join(known)})"
