"""Wavefront OBJ: vertices, faces and the materials of faces, in the file's order.

Names of objects and groups and the grouping for smoothing are passed over. Points, lines, curves and surfaces are no
faces; the notes say how many there were. Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1.
"""

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.errors.wording import shown, told
from sss_ref.mesh.materials import Material
from sss_ref.mesh.mtl import MaterialLibrary, read_libraries
from sss_ref.mesh.polygons import Attribute, Polygons, counted
from sss_ref.mesh.untrusted import OwnFolder, check_text
from sss_ref.mesh.words import NUMBER, Words, named, plain, wholes

IntArray = NDArray[np.int64]

CONTINUED = re.compile(rb"\\[ \t]*\n")
REFERENCES = re.compile(rb"[+-]?\d+(?:/(?:[+-]?\d+)?){0,2}")  # v, v/vt, v//vn, v/vt/vn
ABSENT = -(2**62)  # a reference that a corner does not have
PASSED_OVER = {b"p": "points", b"l": "lines", b"curv": "curves", b"surf": "surfaces", b"call": "calls of other files"}
KNOWN = frozenset(  # the other statements of the manual, its superseded ones too
    b"vp curv2 mtllib maplib usemtl usemap g s mg o cstype deg bmat step parm trim hole scrv sp end con bevel c_interp "
    b"d_interp lod shadow_obj trace_obj ctech stech csh bsp bzp cdc cdp res".split()
)
AGAIN = "export the mesh again"


def read_obj(path: Path, data: bytes) -> Polygons:
    """The polygons of an OBJ file. Raises MeshError that names the line for faces that are none."""
    check_text(path, data)
    return _ObjReader(path, plain(data)).polygons(OwnFolder(path))


def _joined(text: bytes) -> bytes:
    """The text with blanks for a backslash at a line's end and the end, so that places stay; comments do not go on."""

    def blanks(found: re.Match[bytes]) -> bytes:
        start = text.rfind(b"\n", 0, found.start()) + 1
        return found[0] if b"#" in text[start : found.start()] else b" " * len(found[0])

    return CONTINUED.sub(blanks, text) if b"\\" in text else text


@dataclass(frozen=True, eq=False)
class _Faces:
    """The `f` lines: how many corners each has, and what the corners refer to, counted from 0."""

    heads: IntArray  # (F,): the word f of each
    sizes: IntArray  # (F,)
    corners: IntArray  # (C,): the word of each corner
    references: IntArray  # (C, 3): v, vt and vn; ABSENT where there is none


class _ObjReader:
    """An OBJ file's words, sorted by the first word of their lines."""

    def __init__(self, path: Path, text: bytes) -> None:
        self.path, self.text = path, text
        self.words = words = Words.of(_joined(text))
        heads, counts = words.heads, words.counts
        self._is = {name: words.are(name, heads) for name in (b"v", b"vt", b"vn", b"f", b"fo")}
        self._is[b"f"] |= self._is.pop(b"fo")
        self._counts = counts
        self.others = heads[~np.any(list(self._is.values()), axis=0)]

    def polygons(self, folder: OwnFolder) -> Polygons:
        positions, uvs, normals = self._points(b"v", 3), self._points(b"vt", 2), self._points(b"vn", 3)
        faces = self._faces(len(positions))
        v, vt, vn = faces.references.T
        self._check_points(positions, v)
        material, materials, notes = self._materials(faces, folder)
        return Polygons(
            positions,
            faces.sizes,
            v,
            Attribute(uvs, vt) if len(uvs) or (vt != ABSENT).any() else None,
            Attribute(normals, vn) if len(normals) or (vn != ABSENT).any() else None,
            material,
            materials,
            (*notes, *self._passed_over(), *self._weights(), *self._colors()),
        )

    def _points(self, kind: bytes, width: int) -> NDArray[np.float64]:
        """The first numbers of all lines of a kind (N, width), NaN for what is missing or is none.

        Of a UV the second number may be missing, which is 0. What stands behind is passed over: the weight or the
        colour of a vertex, a third texture coordinate.
        """
        heads, counts = self.words.heads[self._is[kind]], self._counts[self._is[kind]] - 1
        taken = np.minimum(counts, width)
        table = np.full((len(heads), width), np.nan)
        if kind == b"vt":
            table[counts > 0, 1] = 0
        row, column = np.repeat(np.arange(len(heads)), taken), counted(taken)
        chosen = np.zeros(len(self.words), bool)
        chosen[heads[row] + 1 + column] = True
        table[row, column] = self.words.floats(chosen)
        return table

    def _check_points(self, positions: NDArray[np.float64], used: IntArray) -> None:
        """Raise MeshError for the first used vertex with fewer than three numbers."""
        bad = used[np.isnan(positions[used]).any(axis=1)]
        for number in np.unique(bad)[:1]:
            head = int(self.words.heads[self._is[b"v"]][number])
            given = self.words.rest(head).split()[:3]
            if len(given) < 3 or not all(map(NUMBER.fullmatch, given)):
                raise MeshError(told(str(self.path), "positions of 3 numbers", self._shown(head), AGAIN))

    def _passed_over(self) -> Iterator[str]:
        """Notes on what is no face, and on lines that begin with no word of OBJ: may be something of them was meant."""
        heads = {int(head): self.words[head] for head in self.others}
        counts = Counter(PASSED_OVER[word] for word in heads.values() if word in PASSED_OVER)
        yield from (f"passed over, for only faces are drawn: {what} ({count})" for what, count in counts.items())
        unknown = [head for head, word in heads.items() if word not in PASSED_OVER and word.lower() not in KNOWN]
        if unknown:
            count = f"({len(unknown)} in all)"
            yield f"passed over, for OBJ has no such statement: {self._shown(unknown[0])} {count}"

    def _colors(self) -> tuple[str, ...]:
        """A note on vertices of six or more numbers: colours, which MeshLab, ZBrush and scanners write there."""
        count = int(np.count_nonzero(self._counts[self._is[b"v"]] > 6))
        return (f"the colours of {count} vertices are not used",) if count else ()

    def _weights(self) -> tuple[str, ...]:
        """A note on vertices of four numbers: the last is a weight, of which only free-form surfaces make use."""
        heads = self.words.heads[self._is[b"v"]][self._counts[self._is[b"v"]] == 5]
        chosen = np.zeros(len(self.words), bool)
        chosen[heads + 4] = True
        count = int(np.count_nonzero(self.words.floats(chosen) != 1))
        return (f"the weights w of {count} vertices are not used: only free-form surfaces have any",) if count else ()

    def _faces(self, last: int) -> _Faces:
        """The faces. Raises MeshError for the first with too few corners, or one that is none of `last` vertices."""
        rows = self._is[b"f"]
        heads, sizes = self.words.heads[rows], self._counts[rows] - 1
        corners = np.repeat(heads, sizes) + 1 + counted(sizes)
        references = self._references(corners)
        for kind, column in zip((b"v", b"vt", b"vn"), references.T, strict=True):
            so_far = np.repeat(np.cumsum(self._is[kind])[rows], sizes)
            backwards = (column < 0) & (column != ABSENT)
            column[backwards] += so_far[backwards]
            column[~backwards & (column != ABSENT)] -= 1
        faces = _Faces(heads, sizes, corners, references)
        self._check(faces, last)
        return faces

    def _references(self, corners: IntArray) -> IntArray:
        """What the words of corners refer to as the file counts (C, 3); v is 0 where a word is no reference."""
        chosen = np.zeros(len(self.words), bool)
        chosen[corners] = True
        slashes = _slashes(self.words, corners)
        numbers = wholes(_filled(self.words.only(chosen)), len(corners) + int(slashes.sum()), otherwise=0)
        first = np.cumsum(slashes + 1) - (slashes + 1)
        result = np.full((len(corners), 3), ABSENT)
        for column in range(3):
            given = slashes >= column
            result[given, column] = numbers[first[given] + column]
        result[slashes > 2, 0] = 0
        return result

    def _check(self, faces: _Faces, last: int) -> None:
        """Raise MeshError for the first face with too few corners, or one that is not there."""
        few = faces.sizes < 3
        v = faces.references[:, 0]
        missing = (v < 0) | (v >= last)
        face = np.repeat(np.arange(len(faces.sizes)), faces.sizes)
        few[face[missing]] = True
        if not few.any():
            return
        number = int(np.flatnonzero(few)[0])
        head = faces.heads[number]
        came = self._shown(head)
        words = [self.words[corner] for corner in faces.corners[face == number]]
        if faces.sizes[number] >= 3 and all(REFERENCES.fullmatch(w) and w.split(b"/")[0].strip(b"+-0") for w in words):
            raise MeshError(told(str(self.path), f"faces of the vertices 1 to {last} that the file has", came, AGAIN))
        raise MeshError(told(str(self.path), "faces of at least three vertices, numbered from 1", came, AGAIN))

    def _shown(self, head: int) -> str:
        """A line as an error shows it, with its number in the file."""
        line = self.text.count(b"\n", 0, int(self.words.starts[head])) + 1
        return f"{shown(named(self.words[head] + b' ' + self.words.rest(head)))} in line {line}"

    def _materials(
        self, faces: _Faces, folder: OwnFolder
    ) -> tuple[NDArray[np.int32], tuple[Material, ...], tuple[str, ...]]:
        """The number of each face's material, the materials that faces have, in their order, and notes."""
        uses = [head for head in self.others if self.words[head] == b"usemtl"]
        names = [b"", *(self.words.rest(head) for head in uses)]
        switch = np.searchsorted(np.array(uses, np.int64), faces.heads)
        used = dict.fromkeys(names[number] for number in np.unique(switch))
        library = self._library(folder)
        found = {name: library.material(name) for name in used}
        materials = tuple(dict.fromkeys(found.values()))
        place = np.array([materials.index(found[name]) if name in found else -1 for name in names], np.int32)
        return place[switch], materials, library.notes_on(found.values())

    def _library(self, folder: OwnFolder) -> MaterialLibrary:
        named_libraries = [self.words.rest(head) for head in self.others if self.words[head] == b"mtllib"]
        return read_libraries(named_libraries, folder)


def _filled(text: bytes) -> bytes:
    """Corners with blanks for slashes: 0 where v is missing, ABSENT where vt or vn is."""
    text = b" " + text + b" "
    if b"/" in text:
        text = text.replace(b" /", b" 0/").replace(b"/ ", b"/%d " % ABSENT)
        while b"//" in text:
            text = text.replace(b"//", b"/%d/" % ABSENT)
        text = text.replace(b"/", b" ")
    return text


def _slashes(words: Words, corners: IntArray) -> IntArray:
    """How many slashes each of these words has (C,)."""
    places = np.flatnonzero(np.frombuffer(words.text, np.uint8) == 47)
    return np.searchsorted(places, words.ends[corners]) - np.searchsorted(places, words.starts[corners])
