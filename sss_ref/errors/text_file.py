"""Text files that users hand over or name: regular ones of a bounded size, TOML in them; what is wrong in one line."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from stat import S_ISREG
from typing import Any

from sss_ref.errors import SssRefError
from sss_ref.errors.whole_file import Put, whole_file
from sss_ref.errors.wording import told

BYTE_LIMIT = 2**20  # of any text; none of ours comes near
MOST_PARTS = 32  # of a dotted key: Python's TOML takes memory by the square of their number
PART = r"""(?:"[^"\n]*+"|'[^'\n]*+'|[\w-]++)"""
LONG_KEY = re.compile(rf"(?<![\w-]){PART}(?:[ \t]*+\.[ \t]*+{PART}){{{MOST_PARTS},}}")
PLACE = re.compile(r"\((at line \d+, column \d+|at end of document)\)")


def check_regular(path: Path, expected: str, error_class: type[SssRefError]) -> int:
    """The bytes of a file that may be opened without waiting for ever: a regular one. Raises `error_class`."""
    try:
        found = path.stat()
    except OSError as error:
        raise error_class(told(str(path), expected, error.strerror or "none", "check the path")) from None
    except ValueError:  # a path with a zero byte
        raise error_class(told(str(path), expected, "no name of a file", "check the path")) from None
    if not S_ISREG(found.st_mode):
        raise error_class(told(str(path), expected, "no regular file", "copy its content to one"))
    return found.st_size


def text_of(path: Path, expected: str, error_class: type[SssRefError]) -> str:
    """The text of a file. Raises `error_class` for what is no regular file, too large, or not UTF-8.

    expected: what the file should be, as the message calls it. Devices and pipes are refused before they are opened.
    """
    size = check_regular(path, expected, error_class)
    if size > BYTE_LIMIT:
        wanted = f"{expected}, of at most {BYTE_LIMIT} bytes"
        raise error_class(told(str(path), wanted, f"{size} bytes", "check the path"))
    try:
        return path.read_bytes().decode("utf-8")
    except OSError as error:
        raise error_class(told(str(path), expected, error.strerror or "none", "check the path")) from None
    except UnicodeDecodeError as error:
        came = f"a byte that is no UTF-8 at byte {error.start}"
        raise error_class(told(str(path), f"{expected} in UTF-8", came, "save it as UTF-8")) from None


def write_text(path: Path, text: str, error_class: type[SssRefError], put: Put = Path.replace) -> Path:
    """Write a text file as a whole; returns its path. Raises `error_class` where it cannot be written.

    put: gives it its name; where that raises FileExistsError, so does this.
    """
    try:
        with whole_file(path, put) as hidden:
            hidden.write_text(text, encoding="utf-8", newline="")
    except FileExistsError:
        raise
    except OSError as error:
        came = error.strerror or "none"
        raise error_class(told(str(path), "a file that can be written", came, "choose another")) from None
    return path


def made_folder(folder: Path, error_class: type[SssRefError]) -> Path:
    """A folder to write into, which is made if need be. Raises `error_class`."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        came = error.strerror or "none"
        raise error_class(told(str(folder), "a folder to write into", came, "choose another")) from None
    return folder


def write_texts(folder: Path, texts: Mapping[str, str], error_class: type[SssRefError]) -> None:
    """Write text files, name -> content, into a folder, as `made_folder` and `write_text` do."""
    made_folder(folder, error_class)
    for name, text in texts.items():
        write_text(folder / name, text, error_class)


def toml_of(path: Path, expected: str, error_class: type[SssRefError]) -> dict[str, Any]:
    """The tables of a TOML file, its keys unchecked. Raises `error_class` as `text_of` does, and for no TOML."""
    text = text_of(path, expected, error_class)
    try:
        return toml_in(text)
    except tomllib.TOMLDecodeError as error:
        place = PLACE.search(str(error))
        came = f"none {place[1]}" if place else "none"
        raise error_class(told(str(path), "valid TOML", came, "correct that place")) from None
    except ValueError:  # a date or a number that Python cannot hold
        raise error_class(told(str(path), "valid TOML", "a date or number out of range", "correct it")) from None
    except RecursionError:
        raise error_class(told(str(path), "valid TOML", "brackets or keys nested without end", "nest less")) from None


def toml_in(text: str) -> dict[str, Any]:
    """The tables of a text. Raises TOMLDecodeError, ValueError for a number that Python cannot hold, RecursionError."""
    if LONG_KEY.search(text):
        raise RecursionError
    return tomllib.loads(text)
