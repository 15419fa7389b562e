"""The rows of a PLY file, element after element.

The numbers of a file in text are brought into binary form first, each as 8 bytes, so that there is one way to walk
them. Rows that are all of the same size, as they are without lists or with triangles alone, are one table; others are
followed one by one, since where a row begins only the lists before it say.
"""

import struct
from collections.abc import Collection
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.mesh.part import refused
from sss_ref.mesh.ply_header import PlyElement, PlyHeader
from sss_ref.mesh.polygons import counted
from sss_ref.mesh.words import Words, floats, plain

IntArray = NDArray[np.int64]


class Column(NamedTuple):
    """A property of all rows."""

    values: NDArray[Any]  # (N,), or of lists all of their numbers, row after row
    sizes: IntArray | None = None  # (N,) of lists: how many numbers each has


class _Field(NamedTuple):
    """A property as it lies in a row."""

    name: str
    kind: np.dtype[Any]
    counted: np.dtype[Any] | None  # of a list: the type of its length


class Rows:
    """The rows behind a header, read in the order of its elements."""

    def __init__(self, path: Path, header: PlyHeader, data: bytes) -> None:
        self._path, self._header = path, header
        self._at = 0
        if header.order:
            self._data = data[header.size :]
            self._found, enough = f"{len(self._data)} bytes", len(self._data)
        else:
            text = plain(data[header.size :])
            words = Words.of(text, comments=False)
            self._data = floats(words.only(np.ones(len(words), bool)), len(words)).tobytes()
            enough = len(words.heads)
            self._found = f"{enough} lines" if enough < header.declared else f"{len(words)} numbers"
        if header.declared > enough:  # an element takes at least one byte or line
            raise self._cut_short()

    def _cut_short(self) -> MeshError:
        expected = f"the {self._header.declared} elements it declares"
        return refused(self._path, expected, self._found, "export the mesh again")

    @property
    def left(self) -> str:
        """What stands behind the last element that was read; empty for nothing."""
        left = len(self._data) - self._at
        if not left:
            return ""
        return f"{left} bytes" if self._header.order else f"{left // 8} numbers"

    def _fields(self, element: PlyElement) -> list[_Field]:
        return [
            _Field(each.name, self._kind(each.kind), None if each.counted is None else self._kind(each.counted))
            for each in element.properties
        ]

    def _kind(self, name: str) -> np.dtype[Any]:
        return np.dtype(self._header.order + name if self._header.order else "f8")

    def read(self, element: PlyElement, wanted: Collection[str]) -> dict[str, Column]:
        """The columns of these names of the next element. Raises MeshError where the file ends before it does."""
        fields = self._fields(element)
        least = sum((field.counted or field.kind).itemsize for field in fields)
        if element.count * least > len(self._data) - self._at:
            raise self._cut_short()
        table = self._table(fields, element.count) if element.count else None
        return self._row_by_row(fields, element.count, wanted) if table is None else table

    def _table(self, fields: list[_Field], count: int) -> dict[str, Column] | None:
        """The columns of rows whose lists are all as long as the first row's; None where they are not."""
        places, at = [], self._at
        for field in fields:
            length = None
            if field.counted is not None:
                length, at = self._length(at, field.counted), at + field.counted.itemsize
            places.append((field, length, at))
            at += field.kind.itemsize * (1 if length is None else length)
        step = at - self._at
        if self._at + step * count > len(self._data):
            return None
        if not all(self._is_everywhere(length, field, start, (count, step)) for field, length, start in places):
            return None
        self._at += step * count
        return {field.name: self._strided(length, field, start, (count, step)) for field, length, start in places}

    def _is_everywhere(self, length: int | None, field: _Field, start: int, rows: tuple[int, int]) -> bool:
        """Whether the lists of all rows (how many, bytes of each) have this length; `start` is behind the first."""
        if field.counted is None:
            return True
        lengths = np.ndarray(rows[0], field.counted, self._data, start - field.counted.itemsize, rows[1])
        return bool((lengths == length).all())

    def _strided(self, length: int | None, field: _Field, start: int, rows: tuple[int, int]) -> Column:
        shape = (rows[0], 1 if length is None else length)
        values = np.ndarray(shape, field.kind, self._data, start, (rows[1], field.kind.itemsize))
        return Column(values.reshape(-1), None if length is None else np.full(rows[0], length))

    def _length(self, at: int, kind: np.dtype[Any]) -> int:
        """The length of the list that begins at a place."""
        if at + kind.itemsize > len(self._data):
            raise self._cut_short()
        (length,) = struct.unpack_from(kind.byteorder.replace("|", "=") + kind.char, self._data, at)
        if not 0 <= length <= len(self._data) or length != int(length):
            raise self._cut_short()
        return int(length)

    def _row_by_row(self, fields: list[_Field], count: int, wanted: Collection[str]) -> dict[str, Column]:
        names = [field.name for field in fields if field.name in wanted]
        kept = {name: (np.empty(count, np.int64), np.ones(count, np.int64)) for name in names}
        walk = [(field, *kept.get(field.name, (None, None))) for field in fields]
        at = self._at
        for row in range(count):
            for field, starts, sizes in walk:
                length = 1
                if field.counted is not None:
                    length, at = self._length(at, field.counted), at + field.counted.itemsize
                if starts is not None:
                    starts[row], sizes[row] = at, length
                at += length * field.kind.itemsize
            if at > len(self._data):
                raise self._cut_short()
        self._at = at
        return {
            field.name: Column(self._gathered(field.kind, starts, sizes), None if field.counted is None else sizes)
            for field, starts, sizes in walk
            if starts is not None
        }

    def _gathered(self, kind: np.dtype[Any], starts: IntArray, sizes: IntArray) -> NDArray[Any]:
        """The numbers of lists that begin at `starts` (N,) and have `sizes` (N,)."""
        places = np.repeat(starts, sizes) + counted(sizes) * kind.itemsize
        letters = np.frombuffer(self._data, np.uint8)[places[:, np.newaxis] + np.arange(kind.itemsize)]
        return letters.view(kind)[:, 0]
