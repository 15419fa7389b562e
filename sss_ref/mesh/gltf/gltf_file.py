"""Opening a glTF or GLB file: its JSON, and the binary chunk of a GLB file."""

import json
import struct
from pathlib import Path
from typing import Any, NamedTuple

from sss_ref.mesh.gltf.gltf_document import AGAIN, GltfDocument
from sss_ref.mesh.gltf.understood import check_understood, refuse_first_version
from sss_ref.mesh.part import refused
from sss_ref.mesh.untrusted import check_packed, check_text

HEADER, CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")


class GltfFile(NamedTuple):
    """A file whose entries have not been looked at."""

    document: GltfDocument
    binary: bytes | None  # of a GLB file, what buffers[0] may hold
    notes: tuple[str, ...]


def opened(path: Path) -> GltfFile:
    """A file as its first bytes say, whatever its name; raises MeshError for what is no glTF 2.0."""
    data = path.read_bytes()
    check_packed(path, data)
    text, binary, notes = _chunks(path, data) if data[:4] == b"glTF" else (data, None, ())
    check_text(path, text)
    content = _parsed(path, text)
    refuse_first_version(path, content)
    document = GltfDocument(path, content)
    check_understood(document)
    return GltfFile(document, binary, notes)


def _chunks(path: Path, data: bytes) -> tuple[bytes, bytes | None, tuple[str, ...]]:
    """The JSON and binary chunk of a GLB file, and a note about bytes behind its end (glTF 2.0, 4.4)."""
    _, version, size = HEADER.unpack(data[:12].ljust(12, b"\0"))
    if version != 2:
        came = f"version {version}" + ", of glTF 1.0" * (version == 1)
        raise refused(path, "version 2 of GLB, for glTF 2.0", came, "convert it to glTF 2.0")
    if size > len(data):
        raise refused(path, f"the {size} bytes it declares", str(len(data)), "copy or export it again")
    chunks, offset = [], HEADER.size
    while offset + CHUNK.size <= size:
        length, kind = CHUNK.unpack_from(data, offset)
        offset += CHUNK.size + length
        if offset > size:
            raise refused(path, f"a chunk of {length} bytes", f"{size - offset + length} before the end", AGAIN)
        chunks.append((kind, data[offset - length : offset]))
    if not chunks or chunks[0][0] != b"JSON":
        raise refused(path, "a GLB file that begins with JSON", "another chunk or none", AGAIN)
    binary = next((content for kind, content in chunks[1:] if kind == b"BIN\0"), None)
    left = len(data) - size
    return chunks[0][1], binary, (f"{left} bytes behind the file's declared end are not used",) if left else ()


def _parsed(path: Path, text: bytes) -> dict[str, Any]:
    try:
        content = json.loads(text.decode("utf-8-sig"), parse_constant=_no_number, object_pairs_hook=_object)
    except UnicodeDecodeError:
        came = "bytes that are not UTF-8"
    except json.JSONDecodeError as error:
        came = f"JSON that breaks off at line {error.lineno}, column {error.colno}"
    except RecursionError:
        came = "JSON that is nested too deep"
    except ValueError as error:
        came = f"JSON with {error}" if isinstance(error, _Unwanted) else "JSON with a number of too many digits"
    else:
        if isinstance(content, dict):
            return content
        came = "JSON that is no object"
    raise refused(path, "a valid glTF document", came, AGAIN) from None


class _Unwanted(ValueError):
    """What Python's reader takes and JSON does not have, or glTF forbids."""


def _no_number(name: str) -> None:
    raise _Unwanted(f"the number {name}")


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result = dict(pairs)
    if len(result) < len(pairs):
        names = [name for name, _ in pairs]
        raise _Unwanted(f"the key {json.dumps(next(name for name in names if names.count(name) > 1))[:60]} twice")
    return result
