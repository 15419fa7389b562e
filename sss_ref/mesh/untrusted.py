"""What a mesh file may ask for, whoever made it: files of its own folder, and work in proportion to its bytes.

trimesh believes what a file declares. So declared counts are held against the file's size before trimesh sees it, and
the files that trimesh asks for on the mesh's behalf pass through `OwnFolder`.
"""

import re
from pathlib import Path, PureWindowsPath
from urllib.parse import unquote

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown, told

BYTE_LIMIT = 2**30  # of the mesh file, and of all files together that it refers to
TEXT_LIMIT = 2**28  # of a mesh file in text, which takes up to a hundred times its bytes to read
ELEMENT_LIMIT = 2**24  # vertices, and faces

COMPRESSED = {b"PK\3\4": "zip", b"\x1f\x8b": "gzip", b"BZh": "bzip2", b"\xfd7zXZ": "xz", b"(\xb5/\xfd": "zstd"}
URI = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")
PLY_ELEMENT = re.compile(rb"^[ \t]*element[ \t]+\S+[ \t]+(\S+)", re.MULTILINE)
OFF_COMMENT = re.compile(rb"#.*")


class OwnFolder:
    """The files that a mesh refers to, for trimesh to ask for: those in the mesh's folder or below it.

    trimesh passes over what goes wrong with materials and images, so the first refusal is kept for the caller.
    """

    def __init__(self, mesh: Path) -> None:
        self.refusal: MeshError | None = None
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

    __getitem__ = get

    def _located(self, reference: str) -> Path | None:
        """The file meant by a reference: its name as it stands, or with %20 and the like decoded."""
        for name in (reference.strip(), unquote(reference).strip()):
            if leads_out(name) or not (self._folder / name).resolve().is_relative_to(self._folder):
                raise self._refused("references to files in its own folder", reference, "copy the file there")
            if (self._folder / name).is_file():
                return self._folder / name
        return None

    def _refused(self, expected: str, reference: str, remedy: str) -> MeshError:
        error = MeshError(told(str(self._mesh), expected, shown(reference), remedy))
        self.refusal = self.refusal or error
        return error


def leads_out(name: str) -> bool:
    r"""Whether a reference leaves its folder by its text alone, on any system: ../a, /a, C:a, \\server\a, http://a."""
    path = PureWindowsPath(name)
    return bool(path.anchor or ".." in path.parts or URI.match(name))


def check_declarations(path: Path, data: bytes) -> None:
    """Raise MeshError if the bytes of a mesh file are compressed, or declare more than follows or than is allowed."""
    for magic, name in COMPRESSED.items():
        if data.startswith(magic):
            raise MeshError(told(str(path), "an uncompressed file", name, "unpack it"))
    match path.suffix.lower():
        case ".ply":
            _check_ply(path, data)
        case ".off":
            _check_off(path, data)
        case ".obj":
            check_text(path, data)
        case ".stl" if b"endsolid" in data[-256:]:
            check_text(path, data)


def check_text(path: Path, data: bytes) -> None:
    """Raise MeshError for more text than is read."""
    if len(data) > TEXT_LIMIT:
        expected = f"at most {TEXT_LIMIT} bytes of text"
        raise MeshError(told(str(path), expected, str(len(data)), "convert it to a binary format"))


def _check_ply(path: Path, data: bytes) -> None:
    header, _, rows = data.partition(b"end_header")
    if b"ascii" not in b"".join(header.splitlines()[1:2]).lower():
        return _check_counts(path, PLY_ELEMENT.findall(header), len(rows), "bytes")
    check_text(path, data)
    _check_counts(path, PLY_ELEMENT.findall(header), len(rows.strip().splitlines()), "lines")


def _check_off(path: Path, data: bytes) -> None:
    check_text(path, data)
    lines = [line for line in OFF_COMMENT.sub(b"", data).partition(b"OFF")[2].splitlines() if line.strip()]
    _check_counts(path, lines[0].split()[:2] if lines else [], len(lines) - 1, "lines")


def _check_counts(path: Path, counts: list[bytes], available: int, unit: str) -> None:
    """Hold declared counts of elements against what follows the header; an element takes at least one `unit`."""
    for count in counts:
        if not count.isdigit() or len(count) > 18 or int(count) > ELEMENT_LIMIT:
            expected = f"element counts from 0 to {ELEMENT_LIMIT}"
            raise MeshError(told(str(path), expected, shown(count.decode(errors="replace")), "simplify the mesh"))
    declared = sum(map(int, counts))
    if declared > available:
        came = f"{available} {unit}"
        raise MeshError(told(str(path), f"the {declared} elements it declares", came, "export the mesh again"))
