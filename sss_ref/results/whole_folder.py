"""Folders that appear whole or not at all, and never in the place of somebody else's files."""

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from sss_ref.errors import DumpError


def writable(folder: Path, is_ours: Callable[[Path], bool], ours: str) -> Path:
    """The absolute path of a folder that can be written. Raises DumpError where it cannot.

    is_ours: whether a folder with files in it may be replaced; ours: what such a folder is called.
    """
    folder = folder.resolve()
    if folder.exists() and not (folder.is_dir() and (not any(folder.iterdir()) or is_ours(folder))):
        raise DumpError(f"{folder}: expected a new folder, an empty one or {ours}, got other files; move them")
    parent = next(parent for parent in folder.parents if parent.exists())
    if not (parent.is_dir() and os.access(parent, os.W_OK)):
        raise DumpError(f"{folder}: expected a place to write to, got {parent}; choose another folder")
    return folder


@contextmanager
def appearing(folder: Path) -> Iterator[Path]:
    """A hidden folder beside `folder` to write into; it takes its place at the end, or vanishes if writing fails."""
    part = folder.with_name(f".{folder.name}.{os.getpid()}.part")
    try:
        part.mkdir(parents=True)
        yield part
        _put(part, folder)
    except (OSError, RuntimeError) as error:  # OpenEXR raises the latter
        reason = getattr(error, "strerror", None) or error
        raise DumpError(f"{folder}: cannot be written ({reason}); choose another folder") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _put(part: Path, folder: Path) -> None:
    """Rename `part` to `folder`, whose own content, if any, is moved aside first and deleted last."""
    if not folder.exists():
        part.rename(folder)
        return
    old = part.with_suffix(".old")
    folder.rename(old)
    try:
        part.rename(folder)
    except OSError:
        old.rename(folder)
        raise
    shutil.rmtree(old, ignore_errors=True)
