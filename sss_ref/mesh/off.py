"""OFF: polygons, and with prefixes normals and UVs of the vertices (Geomview manual, "OFF Files").

Line breaks are free, but that a face's colour goes on to the end of its line. So vertices and faces are read line by
line where each stands on its own, and number by number where not.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors.wording import shown
from sss_ref.mesh.part import refused
from sss_ref.mesh.polygons import Attribute, Polygons, counted
from sss_ref.mesh.untrusted import ELEMENT_LIMIT, check_text
from sss_ref.mesh.words import Words, named, plain

IntArray = NDArray[np.int64]
FloatArray = NDArray[np.float64]

KEYWORD = re.compile(rb"(ST)?(C)?(N)?(4)?(n)?(?:OFF|off)")
AGAIN = "export the mesh again"


@dataclass(frozen=True, eq=False)
class _Numbers:
    """All numbers behind the keyword, and where lines break."""

    words: Words
    values: FloatArray  # (N,); NaN for words that are none

    def __len__(self) -> int:
        return len(self.values)

    def lines(self, at: int) -> tuple[IntArray, IntArray]:
        """Of the lines from number `at` on: where they begin, and how many numbers they have."""
        heads = self.words.heads
        first = int(np.searchsorted(heads, at))
        return heads[first:], self.words.counts[first:]

    def line_end(self, at: int) -> int:
        """The first number on a later line than number `at`."""
        return int(np.searchsorted(self.words.line, self.words.line[at], side="right"))


def read_off(path: Path, data: bytes) -> Polygons:
    """The polygons of an OFF file. Raises MeshError for one that is none, or binary, or not of 3 dimensions."""
    check_text(path, data)
    words, (texture, color, normal) = _behind_keyword(path, Words.of(plain(data)))
    numbers = _Numbers(words, words.floats(np.ones(len(words), bool)))
    vertices, faces, at = _counts(path, numbers)
    width = 3 + 3 * normal + 3 * color + 2 * texture
    stride = _stride(numbers, at, vertices, width + color, width)
    behind = at + stride * vertices
    found = _faces(numbers, behind, faces) if behind <= len(numbers) else None
    if found is None:
        came = f"{len(numbers.lines(at)[0])} lines"
        raise refused(path, f"the {vertices + faces} elements it declares", came, AGAIN)
    sizes, corner = found[0], _whole(path, found[1])
    table = numbers.values[at:behind].reshape(vertices, stride)
    uv = 3 + 3 * normal + color * (stride - 3 - 3 * normal - 2 * texture)
    return Polygons(
        table[:, :3],
        sizes,
        corner,
        Attribute(table[:, uv : uv + 2], corner) if texture else None,
        Attribute(table[:, 3:6], corner) if normal else None,
    )


def _behind_keyword(path: Path, words: Words) -> tuple[Words, tuple[bool, bool, bool]]:
    """The words without the keyword, which may be missing, and whether vertices have UVs, colours and normals."""
    start = int(words.starts[0]) if len(words) else 0
    keyword = KEYWORD.match(words.text, start)
    if keyword:
        if keyword[4] or keyword[5]:
            raise refused(path, "positions of 3 numbers", f"the keyword {keyword[0].decode()}", AGAIN)
        words = Words.of(b" " * keyword.end() + words.text[keyword.end() :])
    if len(words) and words[0].upper().startswith(b"BINARY"):
        raise refused(path, "an off file in text", "a binary one", "convert it to text or to a binary ply file")
    return words, (bool(keyword and keyword[1]), bool(keyword and keyword[2]), bool(keyword and keyword[3]))


def _counts(path: Path, numbers: _Numbers) -> tuple[int, int, int]:
    """The numbers of vertices and faces, and where the vertices begin; the number of edges may be missing."""
    _, counts = numbers.lines(0)
    given = [named(numbers.words[k]) for k in range(min(2, len(numbers)))]
    if len(given) < 2 or np.isnan(numbers.values[:2]).all():
        came = shown(given[0]) if given else "nothing"
        raise refused(path, "a valid off file: OFF, then the numbers of vertices, faces and edges", came, AGAIN)
    for count in given:
        if not (count.isascii() and count.isdigit()) or len(count) > 18 or int(count) > ELEMENT_LIMIT:
            raise refused(path, f"element counts from 0 to {ELEMENT_LIMIT}", shown(count), "simplify the mesh")
    without_edges = counts[0] == 2 and not (len(counts) > 1 and counts[1] == 1)
    return int(given[0]), int(given[1]), 2 if without_edges else 3


def _stride(numbers: _Numbers, at: int, vertices: int, width: int, least: int) -> int:
    """How many numbers each vertex has: those of its line where every line has as many, else `width`."""
    starts, counts = numbers.lines(at)
    lines = counts[:vertices]
    regular = len(lines) == vertices > 0 and starts[0] == at and (lines == lines[0]).all() and lines[0] >= least
    return int(lines[0]) if regular else width


def _faces(numbers: _Numbers, at: int, faces: int) -> tuple[IntArray, FloatArray] | None:
    """The sizes (F,) and corners (K,) of the faces from number `at` on; None where the file ends before they do."""
    starts, counts = numbers.lines(at)
    starts, counts = starts[:faces], counts[:faces]
    given = numbers.values[starts]
    if not (len(starts) == faces and (faces == 0 or starts[0] == at) and (given >= 0).all() and (given < counts).all()):
        walked = _walked(numbers, at, faces, colors=False)
        if walked is None or walked[-1] != len(numbers):
            walked = _walked(numbers, at, faces, colors=True)
        if walked is None:
            return None
        starts = walked[:-1]
    sizes = numbers.values[starts].astype(np.int64)
    return sizes, numbers.values[np.repeat(starts + 1, sizes) + counted(sizes)]


def _walked(numbers: _Numbers, at: int, faces: int, colors: bool) -> IntArray | None:
    """Where each face begins, and where the last ends (F + 1,); colors: each ends with its line."""
    starts = np.empty(faces + 1, np.int64)
    for face in range(faces):
        starts[face] = at
        size = numbers.values[at] if at < len(numbers) else -1.0
        if not 0 <= size < len(numbers) - at:
            return None
        at += int(size)
        at = numbers.line_end(at) if colors else at + 1
    starts[faces] = at
    return starts


def _whole(path: Path, corner: FloatArray) -> IntArray:
    if not (corner == np.rint(corner)).all():
        raise refused(path, "whole numbers as vertex indices", "others", AGAIN)
    return corner.astype(np.int64)
