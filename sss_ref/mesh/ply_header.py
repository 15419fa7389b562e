"""The header of a PLY file: its form, its elements in their order, and the properties of each."""

from dataclasses import dataclass
from pathlib import Path

from sss_ref.errors.wording import shown
from sss_ref.mesh.part import refused
from sss_ref.mesh.untrusted import ELEMENT_LIMIT
from sss_ref.mesh.words import UTF8_MARK, named

TYPES = {
    **{"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"},
    **{"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"},
    **{"float": "f4", "double": "f8", "float32": "f4", "float64": "f8"},
    **{"int64": "i8", "uint64": "u8"},  # not of the specification
}
FORMS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
HEADER_LIMIT = 2**20  # bytes
AGAIN = "export the mesh again"


@dataclass(frozen=True)
class PlyProperty:
    """A number of each row of an element, or a list of numbers."""

    name: str
    kind: str  # NumPy's name of the type, without the order of bytes
    counted: str | None = None  # of a list: the type of its length


@dataclass(frozen=True)
class PlyElement:
    """A table of the file."""

    name: str
    count: int
    properties: tuple[PlyProperty, ...]


@dataclass(frozen=True)
class PlyHeader:
    """What is known before the first row."""

    order: str  # of bytes, "<" or ">"; "" for text
    elements: tuple[PlyElement, ...]
    size: int  # bytes up to the first row

    @property
    def declared(self) -> int:
        """Rows of all elements."""
        return sum(element.count for element in self.elements)


def parsed(path: Path, data: bytes) -> PlyHeader:
    r"""The header of a file's bytes. Lines end as the first one does, with \n, \r\n or \r. Raises MeshError."""
    start = len(UTF8_MARK) if data.startswith(UTF8_MARK) else 0
    if data[start : start + 3] != b"ply" or data[start + 3 : start + 4] not in (b"\n", b"\r", b" ", b"\t"):
        raise refused(path, "a valid ply file", "one that does not begin with the line ply", AGAIN)
    head = data[start : start + HEADER_LIMIT]
    line_end = b"\n" if b"\n" in head.partition(b"end_header")[0] else b"\r"
    order, elements, at = None, list[PlyElement](), start
    for number, line in enumerate(head.split(line_end), 1):
        at += len(line) + 1
        match [named(word) for word in line.split()]:
            case ["end_header"] if order is not None:
                return PlyHeader(order, tuple(elements), at)
            case ["ply"] | [] | ["comment" | "obj_info", *_]:
                continue
            case ["format", form, *_] if form.lower() in FORMS:
                order = FORMS[form.lower()]
            case ["element", name, count]:
                elements.append(PlyElement(name, _count(path, count), ()))
            case ["property", *words] if elements and (read := _property(words)):
                last = elements.pop()
                elements.append(PlyElement(last.name, last.count, (*last.properties, read)))
            case _:
                came = f"{shown(named(line.strip()))} in line {number}"
                raise refused(path, "a ply header: format, element and property lines", came, AGAIN)
    raise refused(path, "a ply header that ends with end_header", "none", AGAIN)


def _property(words: list[str]) -> PlyProperty | None:
    match words:
        case ["list", counted, kind, name] if counted in TYPES and kind in TYPES and TYPES[counted][0] != "f":
            return PlyProperty(name, TYPES[kind], TYPES[counted])
        case [kind, name] if kind in TYPES:
            return PlyProperty(name, TYPES[kind])
    return None


def _count(path: Path, count: str) -> int:
    if not (count.isascii() and count.isdigit()) or len(count) > 18 or int(count) > ELEMENT_LIMIT:
        raise refused(path, f"element counts from 0 to {ELEMENT_LIMIT}", shown(count), "simplify the mesh")
    return int(count)
