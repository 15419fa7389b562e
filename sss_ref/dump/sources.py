"""Where each buffer of a dump comes from: a mapping file says so, or the names of the files in a folder do."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from sss_ref.dump.files import BOTTOM_FIRST, RAW, READERS
from sss_ref.dump.mapping import BufferTable, Origin, read_mapping
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told


@dataclass(frozen=True)
class Source:
    """The file of one buffer; origin: the row it begins with, None for a raw file of which nobody said."""

    name: str
    path: Path
    table: BufferTable
    origin: Origin | None
    mapping: Path | None = None

    def at(self, key: str) -> str:
        """What an error message calls a key of this buffer: as in the mapping file, or else just its file."""
        return f"{self.mapping}: buffers.{self.name}.{key}" if self.mapping else str(self.path)


@dataclass(frozen=True)
class Sources:
    """All of a dump, what was passed over, and what drew it, if a mapping file says so."""

    found: tuple[Source, ...]
    notes: tuple[str, ...] = ()
    device: str | None = None


def sources_of(path: Path, origin: Origin | None = None) -> Sources:
    """The sources that a mapping file names, or the files of a folder, whatever their names. Raises DumpError.

    origin: the row that files begin with of which the mapping does not say it.
    """
    if path.is_dir():
        return _of_folder(path / "buffers" if (path / "buffers").is_dir() else path, origin)
    mapping = read_mapping(path)
    found = []
    for name, table in mapping.buffers.items():
        file = path.parent / table.file
        found.append(Source(name, file, table, table.origin or mapping.origin or origin or _first_row(file), path))
    return Sources(tuple(found), device=mapping.device)


def known_only(sources: Sources, names: Iterable[str]) -> Sources:
    """The sources whose buffers have one of these names; what else lies in a folder is passed over with a note.

    Raises one DumpError for every buffer that two files claim, and for raw files, which need a mapping.
    """
    names = set(names)
    found = tuple(source for source in sources.found if source.mapping or source.name in names)
    notes = (f"{s.path}: ignored, {s.name} is no buffer of this scene" for s in sources.found if s not in found)
    problems = []
    for source in found:
        files = [other.path.name for other in found if other.name == source.name]
        if len(files) > 1 and source.path.name == files[-1]:
            expected = f"one file for the buffer {source.name}"
            problems.append(told(str(source.path.parent), expected, ", ".join(files), "remove all but one"))
        if source.mapping is None and source.path.suffix.lower() in RAW:
            problems.append(told(str(source.path), "a file that gives its shape", "raw bytes", "write a mapping file"))
    if problems:
        raise DumpError("\n".join(problems))
    return Sources(found, (*sources.notes, *notes), sources.device)


def _of_folder(folder: Path, origin: Origin | None) -> Sources:
    """Every file of a folder with a known suffix as the buffer that its name says."""
    try:
        files = sorted(path for path in folder.iterdir() if path.is_file())
    except OSError as error:
        raise DumpError(told(str(folder), "a folder", error.strerror or str(error), "check the path")) from None
    known = [path for path in files if path.suffix.lower() in (*READERS, *RAW)]
    notes = tuple(f"{path}: ignored, its format is not known" for path in files if path not in known)
    return Sources(tuple(Source(p.stem, p, _table_of(p), origin or _first_row(p)) for p in known), notes)


def _table_of(path: Path) -> BufferTable:
    """What a mapping file would say of a file without peculiarities; a raw file is refused later."""
    return BufferTable.model_construct(file=path.name)


def _first_row(path: Path) -> Origin | None:
    if path.suffix.lower() in RAW:
        return None
    return "bottom" if path.suffix.lower() in BOTTOM_FIRST else "top"
