"""What a mesh file may ask for, whoever made it: files of its own folder, and work in proportion to its bytes.

Every reader holds what a file declares against the file's size before it takes memory for it, and asks `OwnFolder` for
the files that a mesh refers to.
"""

import os
import re
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
        return path.read_bytes()

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
                return self._folder / name
        return None

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
