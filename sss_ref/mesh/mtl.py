"""Wavefront MTL: of each material its diffuse colour Kd, and what its picture map_Kd asks for."""

import re
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field

import numpy as np

from sss_ref.errors.wording import shown
from sss_ref.mesh.materials import Material, Rgb
from sss_ref.mesh.untrusted import OwnFolder
from sss_ref.mesh.words import NUMBER, Words, named, plain

SEVERAL = re.compile(r"\S.*?\.mtl(?=\s|$)", re.IGNORECASE)
COMMENT = re.compile(r"\s*#.*")
OPTION_NUMBERS = {"-s": 3, "-o": 3, "-t": 3, "-mm": 2}  # at most; every other option has one value


@dataclass(frozen=True)
class MaterialLibrary:
    """The materials of all libraries that an OBJ file names."""

    materials: dict[str, Material] = field(default_factory=dict)
    options: dict[str, str] = field(default_factory=dict)  # name of a material -> what its map_Kd asks for
    notes: tuple[str, ...] = ()
    read: tuple[str, ...] = ()  # the files

    def material(self, raw: bytes) -> Material:
        """The material of a name as it stands in a file: as a whole or, if there is no such one, up to a #."""
        name = named(raw)
        for each in (name, COMMENT.sub("", name)):
            if each in self.materials:
                return self.materials[each]
        return Material(COMMENT.sub("", name))

    def notes_on(self, used: Collection[Material]) -> tuple[str, ...]:
        """What the user should know of the materials that faces have."""
        asked = [(each.name, self.options[each.name]) for each in used if each.name in self.options]
        options = tuple(f"material {shown(name)}: map_Kd {what} is not applied" for name, what in asked)
        return self.notes + options + self._missing([each.name for each in used if each.name])

    def _missing(self, names: list[str]) -> tuple[str, ...]:
        """A note on materials that the libraries do not have, if there is any library."""
        missing = [name for name in names if name not in self.materials] if self.read else []
        if not missing:
            return ()
        return (f"material {shown(missing[0])} is not in {', '.join(self.read)} ({len(missing)} in all)",)


def read_libraries(lines: list[bytes], folder: OwnFolder) -> MaterialLibrary:
    """The materials of what the `mtllib` lines name; the first of a name counts. A note says which file is not there.

    Raises MeshError for files elsewhere: libraries, and the pictures that libraries name.
    """
    materials: dict[str, Material] = {}
    options: dict[str, str] = {}
    notes, read = [], []
    for name in dict.fromkeys(name for line in lines for name in _files(named(line), folder)):
        if not folder.holds(name):
            notes.append(f"materials of {shown(name)} not used: there is no such file beside the mesh")
            continue
        read.append(name)
        for material, asked in _materials(folder.get(name), folder):
            if material.name not in materials:
                materials[material.name] = material
                options |= {material.name: asked} if asked else {}
    return MaterialLibrary(materials, options, tuple(notes), tuple(read))


def _files(line: str, folder: OwnFolder) -> list[str]:
    """The files that a line names: one, blanks in its name or not, or several that end with .mtl."""
    if folder.holds(line):
        return [line]
    line = COMMENT.sub("", line)
    return [line] if folder.holds(line) else SEVERAL.findall(line) or line.split()


def _materials(data: bytes, folder: OwnFolder) -> Iterable[tuple[Material, str]]:
    """The materials of one library, and what their pictures ask for."""
    words = Words.of(plain(data))
    name, color, picture = None, None, None
    for head, count in [*zip(words.heads.tolist(), words.counts.tolist(), strict=True), (None, 0)]:
        word = words[head].lower() if head is not None else b"newmtl"
        if word == b"newmtl":
            if name is not None:
                yield Material(name, color, picture is not None), picture or ""
            name, color, picture = (named(words.rest(head)) if head is not None else None), None, None
        elif word == b"kd":
            color = _color([words[head + 1 + k] for k in range(min(count - 1, 3))])
        elif word == b"map_kd":
            picture = _asked(named(words.rest(head)), folder)


def _color(numbers: list[bytes]) -> Rgb | None:
    """One number is grey. None for what is no colour, such as a spectrum in a file of its own."""
    if not numbers or not all(map(NUMBER.fullmatch, numbers)):
        return None
    parts = np.array(numbers * 3 if len(numbers) == 1 else numbers).astype(np.float64)
    if len(parts) < 3 or not ((parts >= 0) & (parts <= np.finfo(np.float32).max)).all():
        return None
    red, green, blue = parts.tolist()
    return red, green, blue


def _asked(line: str, folder: OwnFolder) -> str:
    """The options of a map_Kd line that change the picture; its file must be in the folder."""
    words = line.split()
    at = 0
    while at < len(words) and words[at].startswith("-") and not NUMBER.fullmatch(words[at].encode()):
        most, start = OPTION_NUMBERS.get(words[at], 1), at
        at += 1
        while at < len(words) and at - start <= most and (most == 1 or NUMBER.fullmatch(words[at].encode())):
            at += 1
    if words[at:]:
        folder.check(" ".join(words[at:]))
    return " ".join(words[:at])
