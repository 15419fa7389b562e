"""Folders that appear whole or not at all, and never in the place of somebody else's files."""

import errno
import os
import random
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.results.exchange import exchanged

HIDDEN = ".part"  # how the names of folders end that are being written
LOCK = ".lock"  # how the names of the files beside them end that their writers hold
OLD = "old"  # how the name of an earlier result begins that is set aside there
ATTEMPTS, PAUSE = 200, 0.01  # to take a name that others take at the same time; seconds at most between two of them
IN_BETWEEN = (errno.ENOTEMPTY, errno.EEXIST, errno.ENOENT)  # what renaming says where another writer was faster


def writable(folder: Path, is_ours: Callable[[Path], bool], ours: str) -> Path:
    """The absolute path of a folder that can be written. Raises DumpError where it cannot.

    is_ours: whether a folder with files in it may be replaced; ours: what such a folder is called.
    """
    try:
        folder = folder.resolve()
        str(folder).encode()  # OpenEXR takes no other name, nor does JSON
        return _checked(folder, is_ours, ours)
    except OSError as error:
        raise DumpError(f"{folder}: cannot be written ({error.strerror}); choose another folder") from None
    except UnicodeEncodeError:
        raise DumpError(told(str(folder), "a name in UTF-8", "another", "choose another folder")) from None


def _checked(folder: Path, is_ours: Callable[[Path], bool], ours: str) -> Path:
    """The same absolute path if it can be written. Raises DumpError, and OSError where it cannot be looked at."""
    if folder.exists() and not (folder.is_dir() and (not any(folder.iterdir()) or is_ours(folder))):
        raise DumpError(f"{folder}: expected a new folder, an empty one or {ours}, got other files; move them")
    parent = next(parent for parent in folder.parents if parent.exists())
    if not (parent.is_dir() and os.access(parent, os.W_OK)):
        raise DumpError(f"{folder}: expected a place to write to, got {parent}; choose another folder")
    return folder


@contextmanager
def appearing(folder: Path, place: Path | None = None) -> Iterator[Path]:
    """A hidden folder to write into; it takes the place of `folder` at the end, or vanishes if writing fails.

    place: the folder that it is in meanwhile, on the same file system; that of `folder` unless told otherwise.
    Several writers do not disturb each other: the last one stays. What a killed one has left behind goes with the next.
    """
    try:
        place = place or folder.parent
        for needed in (folder.parent, place):
            needed.mkdir(parents=True, exist_ok=True)
        _remove_leftovers(folder, place)
        with _own_lock(folder, place) as lock:
            hidden = lock.with_suffix(HIDDEN)
            try:
                part = hidden / "content"
                part.mkdir(parents=True)
                yield part
                _put(part, folder)
            finally:
                shutil.rmtree(hidden, ignore_errors=True)
    except (OSError, RuntimeError) as error:  # OpenEXR raises the latter
        reason = getattr(error, "strerror", None) or "not all of it was taken"
        raise DumpError(f"{folder}: cannot be written ({reason}); choose another folder") from error


def _put(part: Path, folder: Path) -> None:
    """Let `part` stand under the name `folder`; what stood there comes to stand under that of `part`, to be deleted.

    Where the system cannot exchange two folders, the name leads to nothing for the moment between two renames.
    """
    for attempt in range(ATTEMPTS):
        try:
            if not folder.exists():
                part.rename(folder)
            elif not exchanged(part, folder):
                _put_by_two_renames(part, folder, part.with_name(f"{OLD}{attempt}"))
            return
        except OSError as error:
            if error.errno not in IN_BETWEEN:
                raise
            time.sleep(random.random() * PAUSE)
    raise OSError(errno.EBUSY, "other programs keep writing it")


def _put_by_two_renames(part: Path, folder: Path, old: Path) -> None:
    folder.rename(old)
    try:
        part.rename(folder)
    except OSError:
        if not folder.exists():
            old.rename(folder)
        raise


def _remove_leftovers(folder: Path, place: Path) -> None:
    """Remove what writers that are no more have left: their locks are free. An earlier result is put back."""
    begun = [name for name in os.listdir(place) if name.startswith(f".{folder.name}.") and name.endswith(LOCK)]
    for lock in (place / name for name in begun):
        hidden = lock.with_suffix(HIDDEN)
        try:
            with lock.open("r+") as file:
                _hold(file)
                for old in hidden.glob(f"{OLD}*"):
                    if not folder.exists():
                        old.rename(folder)
                shutil.rmtree(hidden, ignore_errors=True)
                lock.unlink(missing_ok=True)
        except OSError:
            continue  # somebody is writing, or has just finished


@contextmanager
def _own_lock(folder: Path, place: Path) -> Iterator[Path]:
    """A file for `folder` that this writer holds until the end; free again when the process ends, however it ends.

    One that was taken for a leftover before it was held is given up for another.
    """
    while True:
        number, name = tempfile.mkstemp(prefix=f".{folder.name}.", suffix=LOCK, dir=place)
        with os.fdopen(number, "r+") as file:
            try:
                _hold(file)
                if not os.path.samestat(os.fstat(file.fileno()), os.stat(name)):
                    continue
            except OSError:
                continue
            try:
                yield Path(name)
            finally:
                with suppress(OSError):  # where an open file cannot go, the next writer removes it
                    Path(name).unlink()
            return


def _hold(file: IO[str]) -> None:
    """Lock an open file. Raises OSError if another has it."""
    if sys.platform == "win32":
        import msvcrt

        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
