"""Values of text files and of trees of tables with something changed at random."""

import copy
import json
import re

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
NUMBERS = (
    *("0", "1", "-1", "2", "-0.0", "0.5", "3", "4", "255", "256", "65535", "65536", "2147483647", "2147483648"),
    *("-2147483649", "4294967295", "4294967296", "9223372036854775807", "9223372036854775808", "1e38", "3.5e38"),
    *("1e-46", "-1e308", "1e309", "nan", "-nan", "inf", "-inf", "1e", "--1", "0x10", "1_0", "٣", "1,5", "", "9" * 5000),
)
VALUES = (
    *(None, True, False, 0, 1, -1, 2, 3, 0.5, -0.0, 1e-46, 1e38, 3.5e38, 1e308, float("nan"), float("inf")),
    *(
        255,
        2**31 - 1,
        2**31,
        2**32,
        2**53 + 1,
        2**63,
        10**30,
        "",
        "a",
        "\x00",
        "\x1b[2J",
        "ä\u2028",
        "../a",
        "x" * 5000,
    ),
    *([], {}, [1], [0, 0, 0], [1e38, 1e38, 1e38], [[]], {"a": 1}, {"type": "look_at"}, [{}], "NaN", "1"),
)
DEPTH = 3000  # of brackets in brackets


def picked(rng, values):
    """One of several values, each as likely."""
    return values[rng.randrange(len(values))]


def line_lost(rng, text):
    """A line is missing."""
    return _lines_changed(rng, text, lambda lines, at: lines.pop(at))


def line_twice(rng, text):
    """A line is there twice."""
    return _lines_changed(rng, text, lambda lines, at: lines.insert(at, lines[at]))


def line_moved(rng, text):
    """A line stands elsewhere."""
    return _lines_changed(rng, text, lambda lines, at: lines.insert(rng.randrange(len(lines)), lines.pop(at)))


def lines_joined(rng, text):
    """Two lines are one."""
    return _lines_changed(rng, text, lambda lines, at: lines.__setitem__(at, lines[at].rstrip("\n")))


def number_replaced(rng, text):
    """A number has an extreme value, or is none."""
    return _match_replaced(rng, NUMBER, text, lambda match: picked(rng, NUMBERS))


def number_lost(rng, text):
    """A number is missing."""
    return _match_replaced(rng, NUMBER, text, lambda match: "")


def word_swapped(rng, text):
    """A word gives way to another of the file."""
    words = WORD.findall(text) or ["a"]
    return _match_replaced(rng, WORD, text, lambda match: picked(rng, words))


def word_misspelt(rng, text):
    """A word lacks a letter, or has one in another case."""
    return _match_replaced(
        rng, WORD, text, lambda match: picked(rng, (match[0][1:], match[0][:-1], match[0].swapcase()))
    )


def _lines_changed(rng, text, change):
    lines = text.splitlines(keepends=True) or [""]
    change(lines, rng.randrange(len(lines)))
    return "".join(lines)


def _match_replaced(rng, pattern, text, replacement):
    matches = list(pattern.finditer(text))
    if not matches:
        return text
    match = picked(rng, matches)
    return text[: match.start()] + replacement(match) + text[match.end() :]


TEXT_CHANGES = (
    *(line_lost, line_twice, line_moved, lines_joined),
    *(number_replaced, number_replaced, number_replaced, number_lost, word_swapped, word_misspelt),
)


def tree_changed(rng, tree):
    """A copy of tables and arrays with one place changed: lost, doubled, renamed, swapped, or of another value."""
    changed = copy.deepcopy(tree)
    places = list(_places(changed))
    if not places:
        return changed
    inside, key = picked(rng, places)
    other, other_key = picked(rng, places)
    kind = rng.randrange(8)
    if kind == 0:
        del inside[key]
    elif kind == 1:
        inside[key] = copy.deepcopy(other[other_key])
    elif kind == 2 and isinstance(inside, list):
        inside.insert(key, copy.deepcopy(inside[key]))
    elif kind == 2:
        inside[picked(rng, (f"{key}s", key[:-1], key.upper(), "type", "extensions"))] = inside.pop(key)
    elif kind == 3 and isinstance(inside[key], int | float):
        inside[key] = picked(rng, (inside[key] + 1, inside[key] - 1, -inside[key], inside[key] * 2, 0))
    elif kind == 4 and isinstance(inside[key], list):
        inside[key] = inside[key] * picked(rng, (2, 3, 1000))
    else:
        inside[key] = copy.deepcopy(picked(rng, VALUES))
    return changed


def _places(tree):
    """Where something stands in it: a table or an array, and the key."""
    keys = list(tree) if isinstance(tree, dict) else range(len(tree)) if isinstance(tree, list) else ()
    for key in keys:
        yield tree, key
        yield from _places(tree[key])


def toml_text(tables):
    """Tables as TOML, each value of the top in one line; what TOML has no word for is written as JSON has it."""
    return "".join(f"{json.dumps(str(key))} = {_toml(value)}\n" for key, value in tables.items())


def _toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {_toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return repr(value) if isinstance(value, float) else json.dumps(value, ensure_ascii=False)


def nested(rng, text):
    """Brackets in brackets at some place."""
    at, bracket = rng.randrange(len(text) + 1), picked(rng, ("[", "{", '{"a":', "(", "[["))
    return text[:at] + bracket * DEPTH + text[at:]
