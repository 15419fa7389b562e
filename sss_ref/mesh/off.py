"""OFF: polygons, and with prefixes normals and UVs of the vertices (Geomview manual, "OFF Files").

Line breaks are free, but that a face's colour goes on to the end of its line. So vertices and faces are read line by
line where each stands on its own, and number by number where not.

MeshLab has the prefixes in another order, N, C, ST, and then writes the colour of a vertex before its normal
(findings/meshlab_off_order.sh).
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors.wording import shown
from sss_ref.mesh.part import refused, whole
from sss_ref.mesh.polygons import Attribute, Polygons, counted
from sss_ref.mesh.untrusted import ELEMENT_LIMIT, check_text
from sss_ref.mesh.words import Words, named, plain

IntArray = NDArray[np.int64]
FloatArray = NDArray[np.float64]

KEYWORD = re.compile(rb"(?P<uv>ST)?(?P<color>C)?(?P<normal>N)?(?P<other>4?n?)(?:OFF|off)")
MESHLABS = re.compile(rb"(?P<normal>N)?(?P<color>C)?(?P<uv>ST)?(?P<other>)OFF")
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


@dataclass(frozen=True)
class _Prefixes:
    """What vertices have besides a position."""

    uv: bool
    color: bool
    normal: bool
    color_first: bool  # whether a colour comes before the normal

    @property
    def least(self) -> int:
        """The fewest numbers of a vertex: a colour has three or four."""
        return 3 + 3 * self.normal + 3 * self.color + 2 * self.uv


def read_off(path: Path, data: bytes) -> Polygons:
    """The polygons of an OFF file. Raises MeshError for one that is none, or binary, or not of 3 dimensions."""
    check_text(path, data)
    words, has = _behind_keyword(path, Words.of(plain(data)))
    numbers = _Numbers(words, words.floats(np.ones(len(words), bool)))
    vertices, faces, at = _counts(path, numbers)
    stride = _stride(numbers, at, vertices, has.least + has.color, has.least)
    behind = at + stride * vertices
    starts = _faces(numbers, behind, faces) if behind <= len(numbers) else None
    if starts is None:
        came = f"{len(numbers.lines(at)[0])} lines"
        raise refused(path, f"the {vertices + faces} elements it declares", came, AGAIN)
    sizes = whole(path, numbers.values[starts[:-1]], "as counts of corners")
    corner = whole(path, numbers.values[np.repeat(starts[:-1] + 1, sizes) + counted(sizes)], "as vertex indices")
    table = numbers.values[at:behind].reshape(vertices, stride)
    color = stride - 3 - 3 * has.normal - 2 * has.uv
    normal, uv = 3 + color * has.color_first, 3 + 3 * has.normal + color * has.color
    return Polygons(
        table[:, :3],
        sizes,
        corner,
        Attribute(table[:, uv : uv + 2], corner) if has.uv else None,
        Attribute(table[:, normal : normal + 3], corner) if has.normal else None,
        notes=tuple(_not_used(numbers, starts, color > 0, bool((np.diff(starts) > sizes + 1).any()))),
    )


def _not_used(numbers: _Numbers, starts: IntArray, of_vertices: bool, of_faces: bool) -> Iterator[str]:
    """Notes on colours, of vertices and of faces, and on what stands behind the last face."""
    owners = [owner for owner, has_any in (("vertices", of_vertices), ("faces", of_faces)) if has_any]
    if owners:
        yield f"colours of {' and '.join(owners)} are not used"
    left = len(numbers) - int(starts[-1])
    if left:
        yield f"{left} numbers behind the last face it declares are not used"


def _behind_keyword(path: Path, words: Words) -> tuple[Words, _Prefixes]:
    """The words without the keyword, which may be missing, and what it says of the vertices."""
    start = int(words.starts[0]) if len(words) else 0
    keyword = KEYWORD.match(words.text, start) or MESHLABS.match(words.text, start)
    if keyword:
        if keyword["other"]:
            raise refused(path, "positions of 3 numbers", f"the keyword {keyword[0].decode()}", AGAIN)
        words = Words.of(b" " * keyword.end() + words.text[keyword.end() :])
    if len(words) and words[0].upper().startswith(b"BINARY"):
        raise refused(path, "an off file in text", "a binary one", "convert it to text or to a binary ply file")
    has = {name: bool(keyword and keyword[name]) for name in ("uv", "color", "normal")}
    return words, _Prefixes(**has, color_first=bool(keyword and keyword.re is MESHLABS))


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


def _faces(numbers: _Numbers, at: int, faces: int) -> IntArray | None:
    """Where each face from number `at` on begins, and where the last ends (F + 1,); None where the file ends before."""
    lines, counts = numbers.lines(at)
    starts, counts = lines[:faces], counts[:faces]
    given = numbers.values[starts]
    if len(starts) == faces and (faces == 0 or starts[0] == at) and (given >= 0).all() and (given < counts).all():
        return np.append(lines, len(numbers))[: faces + 1]
    walked = _walked(numbers, at, faces, colors=False)
    if walked is None or walked[-1] != len(numbers):
        walked = _walked(numbers, at, faces, colors=True)
    return walked


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
