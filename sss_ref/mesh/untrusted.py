"""What a mesh file may ask for, whoever made it: files of its own folder, and work in proportion to its bytes.

Every reader holds what a file declares against the file's size before it takes memory for it, and asks `OwnFolder` for
the files that a mesh refers to.
"""

import hashlib
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path, PureWindowsPath
from urllib.parse import unquote

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown, told
from sss_ref.mesh.words import UTF16_MARKS

BYTE_LIMIT = 2**30  # of the mesh file, and of all files together that it refers to
TEXT_LIMIT = 2**28  # of a mesh file in text, which takes some ten times its bytes to read
ELEMENT_LIMIT = 2**24  # vertices, and faces

COMPRESSED = {b"PK\3\4": "zip", b"\x1f\x8b": "gzip", b"BZh": "bzip2", b"\xfd7zXZ": "xz", b"(\xb5/\xfd": "zstd"}
URI = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")

References = dict[str, str | None]
"""What a mesh file refers to -> the SHA-256 of the file's content, "" if that was not read, None if there is none."""

_seen: ContextVar[References | None] = ContextVar("seen", default=None)


@contextmanager
def referred_to() -> Iterator[References]:
    """The references that are followed in the meantime."""
    references: References = {}
    token = _seen.set(references)
    try:
        yield references
    finally:
        _seen.reset(token)


def unchanged(mesh: Path, references: References) -> bool:
    """Whether the files that a mesh refers to are as they were."""
    folder = OwnFolder(mesh)
    try:
        return all(_state(folder, reference, was) == was for reference, was in references.items())
    except (MeshError, OSError):
        return False


def _state(folder: "OwnFolder", reference: str, was: str | None) -> str | None:
    """How a file is now, as far as `was` says how it was."""
    if not folder.holds(reference):
        return None
    return hashlib.sha256(folder.get(reference)).hexdigest() if was else ""


class OwnFolder:
    """The files that a mesh may refer to: those in its folder or below it."""

    def __init__(self, mesh: Path) -> None:
        self._mesh = mesh
        self._folder = mesh.parent.resolve()
        self._bytes_left = BYTE_LIMIT

    def get(self, reference: str) -> bytes:
        """The bytes of a referenced file. Raises MeshError if it is elsewhere, not there, or too large."""
        path = self._located(reference)
        if path is None:
            raise MeshError(told(str(self._mesh), f"a file {shown(reference)} beside it", "none", "put it there"))
        self._bytes_left -= path.stat().st_size
        if self._bytes_left < 0:
            raise self._refused(f"at most {BYTE_LIMIT} bytes in the files it refers to", reference, "simplify the mesh")
        content = path.read_bytes()
        self._see(reference, hashlib.sha256(content).hexdigest())
        return content

    def holds(self, reference: str) -> bool:
        """Whether there is such a file. Raises MeshError if it is elsewhere."""
        return self._located(reference) is not None

    def check(self, reference: str) -> None:
        """Raise MeshError if a file that is not read, whether it is there or not, is elsewhere."""
        self._located(reference)

    def _located(self, reference: str) -> Path | None:
        """The file meant by a reference: its name as it stands, or with %20 and the like decoded."""
        for name in (reference.strip(), unquote(reference).strip()):
            if leads_out(name) or not self._is_inside(name):
                raise self._refused("references to files in its own folder", reference, "copy the file there")
            if os.path.isfile(self._folder / name):  # unlike Path.is_file it takes any text
                self._see(reference, "")
                return self._folder / name
        self._see(reference, None)
        return None

    def _see(self, reference: str, state: str | None) -> None:
        """Note how a referenced file is, for `referred_to`; what was read of it is not forgotten."""
        seen = _seen.get()
        if seen is not None:
            seen[reference] = state or seen.get(reference) or state

    def _is_inside(self, name: str) -> bool:
        """Whether links lead a name out of the folder; a text that is no name of a file stays inside."""
        try:
            return (self._folder / name).resolve().is_relative_to(self._folder)
        except (OSError, ValueError):
            return True

    def _refused(self, expected: str, reference: str, remedy: str) -> MeshError:
        return MeshError(told(str(self._mesh), expected, shown(reference), remedy))


def leads_out(name: str) -> bool:
    r"""Whether a reference leaves its folder by its text alone, on any system: ../a, /a, C:a, \\server\a, http://a."""
    path = PureWindowsPath(name)
    return bool(path.anchor or ".." in path.parts or URI.match(name))


def check_packed(path: Path, data: bytes) -> None:
    """Raise MeshError if the bytes of a mesh file are compressed as a whole."""
    for magic, name in COMPRESSED.items():
        if data.startswith(magic):
            raise MeshError(told(str(path), "an uncompressed file", name, "unpack it"))


def check_text(path: Path, data: bytes) -> None:
    """Raise MeshError for more text than is read, or text of two bytes a letter."""
    if data.startswith(UTF16_MARKS):
        raise MeshError(told(str(path), "text in UTF-8", "text in UTF-16", "save it as UTF-8"))
    if len(data) > TEXT_LIMIT:
        expected = f"at most {TEXT_LIMIT} bytes of text"
        raise MeshError(told(str(path), expected, str(len(data)), "convert it to a binary format"))
