"""The mapping file: which file holds which buffer, and how. Every key is explained here and nowhere else.

origin = "top"
[buffers.normal_world]
file = "gbuffer.exr"
channels = ["normal.x", "normal.y", "normal.z"]
space = "view"
"""

import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo, field_validator

from sss_ref.dump.encoding import Encoding, Storage
from sss_ref.dump.files import RAW, SUFFIXES
from sss_ref.errors import DumpError
from sss_ref.errors.wording import described, told, unmet
from sss_ref.scene_file.quantities import Number, Size, Table, requiring

BYTE_LIMIT = 2**20  # of a mapping file
NEEDS_MAPPING = "[height, width] or [height, width, channels]"


def _single_letters(value: Any) -> Any:
    """A text stands for channels of one letter each."""
    return tuple(value) if isinstance(value, str) else value


Origin = Literal["top", "bottom"]
Part = Annotated[Any, requiring(lambda part: type(part) in (str, int), "a part's name or number", "choose one part")]
ChannelNames = Annotated[tuple[str, ...], Field(strict=False), BeforeValidator(_single_letters)]
Shape = Annotated[
    tuple[Size, ...], Field(strict=False), requiring(lambda shape: len(shape) in (2, 3), NEEDS_MAPPING, "give these")
]
Factor = Annotated[Number, requiring(bool, "a number that is not zero", "give the factor that undoes the storage")]


class BufferTable(Table):
    """[buffers.NAME]: the file of one buffer, and what the file does not say of itself."""

    file: str
    """A file of any known format, relative to the mapping file."""
    part: Part | None = None
    """Of EXR the part's name, of TIFF the page's number. Without it: the only part, or the one named as the buffer."""
    channels: ChannelNames | None = None
    """The channels that are the buffer's, in its order: "RGB", "BGR", ["normal.x", "normal.y", "normal.z"]."""
    shape: Shape | None = None
    """Of a raw file: [height, width] or [height, width, channels]."""
    dtype: Literal["float32", "float16", "uint8", "uint16", "int32", "uint32"] | None = None
    """Of a raw file: the type of an element, little-endian."""
    origin: Origin | None = None
    """Which row the file begins with. Without it that of the whole mapping; else bottom for NPY, top for pictures."""
    encoding: Storage | None = None
    """What the numbers stand for, where the file leaves it open. See `Encoding`."""
    scale: Factor = 1.0
    """value = stored * scale + offset."""
    offset: Number = 0.0
    """See scale."""
    rounded_from: Storage | None = None
    """The storage of the texture, if the file has fewer bits than it: what read the texture had all of them."""
    space: Literal["world", "view"] = "world"
    """The space of a position or normal."""
    normals: Literal["xyz", "n*.5+.5", "octahedral"] = "xyz"
    """How a normal is stored: as it is, moved to 0..1, or as an octahedral map with components from -1 to 1."""

    @field_validator("file")
    @classmethod
    def _is_known(cls, file: str) -> str:
        if Path(file).suffix.lower() not in SUFFIXES:
            raise unmet(f"a file name ending in {', '.join(SUFFIXES)}", "convert the file")
        return file

    @field_validator("shape", "dtype")
    @classmethod
    def _belongs_to_raw(cls, value: Any, info: ValidationInfo) -> Any:
        is_raw = Path(info.data.get("file", "")).suffix.lower() in RAW
        if is_raw and value is None:
            raise unmet(f"the {info.field_name} of a raw file", "add it", "nothing")
        if not is_raw and value is not None and "file" in info.data:
            raise unmet(f"no {info.field_name} for a file that gives its own", "remove it")
        return value

    @property
    def stored(self) -> dict[str, Any]:
        """The keys that `Encoding` keeps, apart from the storage."""
        return self.model_dump(include=Encoding.__dataclass_fields__.keys() - {"storage"})


class MappingFile(Table):
    """The whole file."""

    origin: Origin | None = None
    """Which row the files begin with whose tables do not say so."""
    device: str | None = None
    """What drew the buffers, such as its GL_RENDERER; told in the report."""
    buffers: Annotated[dict[str, BufferTable], requiring(bool, "a table [buffers.NAME]", "add one")]
    """One table for each buffer, by its name."""


def read_mapping(path: Path) -> MappingFile:
    """The tables of a mapping file. Raises one DumpError for all that is wrong with them."""
    try:
        return MappingFile.model_validate(_parsed(path))
    except ValidationError as error:
        problems = [described(details, _known(details["loc"]))[1] for details in error.errors()]
        raise DumpError("\n".join(f"{path}: {problem}" for problem in problems)) from None


def _known(location: tuple[str | int, ...]) -> Iterable[str]:
    """The keys of the table that an error is in."""
    return MappingFile.model_fields if len(location) == 1 else BufferTable.model_fields


def _parsed(path: Path) -> dict[str, Any]:
    try:
        if path.stat().st_size > BYTE_LIMIT:
            raise DumpError(told(str(path), f"a mapping file of at most {BYTE_LIMIT} bytes", "more", "check the path"))
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise DumpError(
            told(str(path), "a folder of buffers or a mapping file", error.strerror or "none", "check the path")
        ) from None
    except (ValueError, RecursionError) as error:  # not UTF-8, not TOML, or nested without end
        raise DumpError(told(str(path), "valid TOML", str(error), "correct that place")) from None
