"""Files that are dropped into the page: kept in a folder of their own until the viewer ends, and read as any mesh."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sss_ref.errors import MeshError, SceneError
from sss_ref.errors.wording import shown, told
from sss_ref.scene_file.shipped import MESH_SUFFIXES, mesh_names

BESIDE = (".mtl", ".bin", ".png", ".jpg", ".jpeg")  # what a mesh file may refer to
SIZE_LIMIT = 2**26  # bytes of a dropped file
MOST_FILES = 64
FILE_KEYS = ("path", "texture", "normal_map", "specular_map")  # of [mesh] and [[layers]]


@dataclass
class DroppedFile:
    """A file that is arriving. adopt: whether a first scene for it is wanted."""

    name: str
    size: int
    adopt: bool
    content: bytearray = field(default_factory=bytearray)

    @property
    def is_whole(self) -> bool:
        """Whether all of it is there."""
        return len(self.content) == self.size

    def add(self, part: bytes) -> None:
        """Take the next bytes. Raises MeshError for more than were announced."""
        if len(self.content) + len(part) > self.size:
            raise MeshError(told(self.name, f"{self.size} bytes as announced", "more", "drop it again"))
        self.content += part


@dataclass(frozen=True)
class DroppedFiles:
    """The dropped files, by name, in a folder; one of the same name replaces the earlier."""

    folder: Path

    def announced(self, name: str, size: int, adopt: bool) -> DroppedFile:
        """A file that will arrive. Raises MeshError for one that is refused by its name or size."""
        known = (*MESH_SUFFIXES, *BESIDE)
        if Path(name).name != name or name.startswith(".") or Path(name).suffix.lower() not in known:
            raise MeshError(told(shown(name), f"a file ending in {', '.join(known)}", "another", "convert the mesh"))
        if not 0 < size <= SIZE_LIMIT:
            raise MeshError(told(name, f"1 to {SIZE_LIMIT} bytes", str(size), "simplify the mesh"))
        if name not in self.names() and len(self.names()) >= MOST_FILES:
            raise MeshError(told(name, f"at most {MOST_FILES} dropped files", "one more", "start the viewer again"))
        return DroppedFile(name, size, adopt)

    def keep(self, file: DroppedFile) -> Path:
        """Write a whole file into the folder."""
        path = self.folder / file.name
        path.write_bytes(file.content)
        return path

    def names(self) -> list[str]:
        """The names of the files that are there, sorted."""
        return sorted(os.listdir(self.folder))

    def located(self, data: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
        """A scene whose dropped files are named by their place.

        given: the scene that the viewer was started with. Raises SceneError for the name of any other file than those
        it names, shipped meshes and dropped files: the page may not read what is on this machine.
        """
        known = {value for _, _, value in _files(given)}
        found = dict(data)
        for table, key, value in _files(data):
            if value in self.names():
                path = str(self.folder / value)
            elif value in known or (key == "path" and value in mesh_names()):
                continue
            else:
                where = ".".join((*map(str, table), key))
                raise SceneError(told(where, "a shipped mesh or a dropped file", shown(value), "drop it into the page"))
            found = _with(found, (*table, key), path)
        return found

    def by_name(self, values: dict[str, Any]) -> dict[str, Any]:
        """A scene whose files in the folder are named as the page does."""
        for table, key, value in [*_files(values)]:
            values = _with(values, (*table, key), self.named(value))
        return values

    def named(self, text: str) -> str:
        """A message that calls the files what the page does."""
        return text.replace(f"{self.folder}{os.sep}", "")


def _files(data: Mapping[str, Any]) -> Iterator[tuple[tuple[str | int, ...], str, str]]:
    """Table, key and value of every file that a scene names."""
    layers = data.get("layers")
    tables: dict[tuple[str | int, ...], Any] = {("mesh",): data.get("mesh")}
    tables |= {("layers", number): each for number, each in enumerate(layers if isinstance(layers, list) else [])}
    for path, table in tables.items():
        for key in FILE_KEYS:
            if isinstance(table, Mapping) and isinstance(table.get(key), str):
                yield path, key, table[key]


def _with(data: Any, path: tuple[str | int, ...], value: Any) -> Any:
    """A copy of tables and arrays with another value at `path`."""
    if not path:
        return value
    head, *rest = path
    if isinstance(head, int):
        return [_with(each, tuple(rest), value) if number == head else each for number, each in enumerate(data)]
    return {**data, head: _with(data[head], tuple(rest), value)}
