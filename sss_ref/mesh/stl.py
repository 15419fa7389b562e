"""STL, in text and binary: triangles without shared vertices (3D Systems, StereoLithography Interface Specification).

The normals of facets are not used: they say nothing that the corners do not, and many programs write zeros.
"""

from pathlib import Path

import numpy as np

from sss_ref.mesh.part import refused
from sss_ref.mesh.polygons import Polygons
from sss_ref.mesh.untrusted import check_text
from sss_ref.mesh.words import UTF16_MARKS, Mask, Words, plain

HEADER = 84  # bytes: 80 of any kind and the number of facets
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
AGAIN = "export the mesh again"


def read_stl(path: Path, data: bytes) -> Polygons:
    """The triangles of an STL file, of all its solids. Raises MeshError where the file ends too early."""
    return _in_text(path, data) if _is_text(data) else _in_binary(path, data)


def _is_text(data: bytes) -> bool:
    """Binary headers may begin with "solid" too, but the number of facets behind them has a byte that is zero."""
    if data.startswith(UTF16_MARKS):
        return True
    start = plain(data[:1024]).lstrip().lower()
    return start.startswith((b"solid", b"facet")) and b"\0" not in data[HEADER - 4 : HEADER]


def _in_binary(path: Path, data: bytes) -> Polygons:
    declared = int.from_bytes(data[80:HEADER], "little")
    behind = len(data) - HEADER - declared * FACET.itemsize
    if behind < 0 and len(data) >= HEADER:
        came = f"{len(data) - HEADER} bytes"
        raise refused(path, f"the {declared} triangles it declares, of {FACET.itemsize} bytes each", came, AGAIN)
    if behind > 0 and not declared:
        raise refused(path, "at least one triangle", f"a file that declares 0 triangles, {behind} bytes follow", AGAIN)
    facets = np.frombuffer(data, FACET, declared, HEADER) if behind >= 0 else np.zeros(0, FACET)
    notes = (f"it declares {declared} triangles, {behind} bytes follow: they are not used",) if behind > 0 else ()
    points = facets["corners"].reshape(-1, 3).astype(np.float64)
    return Polygons(points, np.full(len(facets), 3), np.arange(len(points)), notes=notes)


def _in_text(path: Path, data: bytes) -> Polygons:
    """Lines may break anywhere but behind `solid` and a name; only vertices and the ends of their loops are read."""
    check_text(path, data)
    words = Words.of(plain(data), comments=False)
    name = np.zeros(len(words), bool)
    for line in np.flatnonzero(_begins_or_ends_a_solid(words)):
        name[words.heads[line] : words.heads[line] + words.counts[line]] = True
    among = np.flatnonzero(~name)
    vertices, ends = among[words.are(b"vertex", among)], among[words.are(b"endloop", among)]
    numbers = np.zeros(len(words) + 3, bool)
    for offset in (1, 2, 3):
        numbers[vertices + offset] = True
    numbers = numbers[:-3]
    if np.count_nonzero(numbers) < 3 * len(vertices):
        raise refused(path, "three numbers for each vertex", "a file that ends before", AGAIN)
    points = words.floats(numbers).reshape(-1, 3)
    sizes = np.diff(np.searchsorted(vertices, ends), prepend=0)
    wrong = np.flatnonzero(sizes < 3)
    if len(wrong) or sizes.sum() < len(vertices):
        facet, came = (int(wrong[0]), int(sizes[wrong[0]])) if len(wrong) else (len(ends), len(vertices) - sizes.sum())
        raise refused(path, "three vertices and endloop in every facet", f"{came} vertices in facet {facet}", AGAIN)
    return Polygons(points, sizes, np.arange(len(points)))


def _begins_or_ends_a_solid(words: Words) -> Mask:
    """Which lines are `solid`, `endsolid` or `end solid`, whose other words are a name."""
    heads = words.heads
    second = np.minimum(heads + 1, len(words) - 1)
    end = words.are(b"end", heads) & words.are(b"solid", second)
    return words.are(b"solid", heads) | words.are(b"endsolid", heads) | end
