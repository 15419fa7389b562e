"""Files that are whole or not taken: behind a hash of its own, one that is damaged is told and made again."""

import hashlib
import logging
import os
import shutil
from contextlib import suppress
from pathlib import Path

DIGEST = 32  # bytes of SHA-256 before the content of a file


def kept(path: Path) -> bytes | None:
    """What was kept in a file; None if there is none, or a damaged one, which is said: it will be replaced."""
    if not os.path.lexists(path):
        return None
    try:
        if not path.is_file():
            _clear(path)
            came = "a folder or a device"
        else:
            content = path.read_bytes()
            if content[:DIGEST] == _digest(path, content[DIGEST:]):
                return content[DIGEST:]
            came = "a damaged one"
    except OSError as error:
        came = error.strerror or "one that cannot be read"
    refused(path, "a whole file", came)
    return None


def keep(path: Path, content: bytes) -> None:
    """Keep something in a file, which is there as a whole or not at all."""
    part = path.with_suffix(f".{os.getpid()}.part")
    try:
        part.write_bytes(_digest(path, content) + content)
        part.replace(path)
    except OSError as error:
        with suppress(OSError):
            part.unlink()
        _say(path, "a file that can be written", error.strerror or "none", "the next process compiles again")


def refused(path: Path, expected: str, came: str) -> None:
    """Say that what a file holds is not taken."""
    _say(path, expected, came, "it is compiled and written again")


def _digest(path: Path, content: bytes) -> bytes:
    """The hash of a file's content and of its name, so that one under another's name is none."""
    return hashlib.sha256(path.name.encode() + b"\0" + content).digest()


def _clear(path: Path) -> None:
    """Remove what no file can be written over."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink()


def _say(path: Path, expected: str, came: str, remedy: str) -> None:
    logging.getLogger("sss_ref").warning("%s: expected %s, got %s; %s", path, expected, came, remedy)
