"""The mapping file: which file holds which buffer, and how. Every key is explained here and nowhere else.

origin = "top"
[buffers.normal_world]
file = "gbuffer.exr"
channels = ["normal.x", "normal.y", "normal.z"]
space = "view"
"""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo, WrapValidator, field_validator

from sss_ref.dump.depths import DepthKind
from sss_ref.dump.encoding import Encoding, Storage
from sss_ref.dump.files import RAW, SUFFIXES
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import toml_of
from sss_ref.errors.wording import described, unmet
from sss_ref.scene_file.quantities import Number, Size, Table, requiring

EXPECTED = "a folder of buffers or a mapping file"
LONGEST_NAME = 1000
NEEDS_MAPPING = "[height, width] or [height, width, channels]"


def _each(value: Any, check: Callable[[Any], Any]) -> Any:
    """One number, or one for each channel."""
    return tuple(check(each) for each in value) if isinstance(value, list | tuple) and value else check(value)


def _single_letters(value: Any) -> Any:
    """A text stands for channels of one letter each."""
    return tuple(value) if isinstance(value, str) else value


Origin = Literal["top", "bottom"]
Part = Annotated[Any, requiring(lambda part: type(part) in (str, int), "a part's name or number", "choose one part")]
ChannelNames = Annotated[tuple[str, ...], Field(strict=False), BeforeValidator(_single_letters)]
Shape = Annotated[
    tuple[Size, ...], Field(strict=False), requiring(lambda shape: len(shape) in (2, 3), NEEDS_MAPPING, "give these")
]
NotZero = Annotated[Number, requiring(bool, "a number that is not zero", "give the factor that undoes the storage")]
Factor = Annotated[NotZero, WrapValidator(_each)]
Summand = Annotated[Number, WrapValidator(_each)]


class BufferTable(Table):
    """[buffers.NAME]: the file of one buffer, and what the file does not say of itself."""

    file: str
    """A file of any known format, relative to the mapping file."""
    part: Part | None = None
    """Of EXR a part, or a layer by what its channels' names begin with ("ViewLayer.Position" of ViewLayer.Position.X);
    of TIFF the page's number. Without it: the layer or the part named as the buffer, or the only part."""
    channels: ChannelNames | None = None
    """The channels that are the buffer's, in its order: "RGB", "BGR", ["normal.x", "normal.y", "normal.z"]. In files
    that do not name them, all but EXR, the letters of "XYZW", "STPQ" and "UV" are places, as those of "RGBA" are."""
    shape: Shape | None = None
    """Of a raw file: [height, width] or [height, width, channels]."""
    dtype: Literal["float32", "float16", "uint8", "uint16", "uint32", "int8", "int16", "int32"] | None = None
    """Of a raw file: the type of an element, little-endian."""
    origin: Origin | None = None
    """Which row the file begins with. Without it that of the whole mapping; else bottom for NPY, top for pictures."""
    encoding: Storage | None = None
    """What the numbers stand for, where the file leaves it open. See `Encoding`."""
    scale: Factor = 1.0
    """value = stored * scale + offset: a number, or one for each channel; [1, -1] with offset [0, 1] is (u, 1 - v)."""
    offset: Summand = 0.0
    """See scale."""
    background: Number | None = None
    """What the file holds, in all channels and before scale and offset, where nothing is drawn. It may be a value as
    well, as 0 is the first triangle: it counts where the dump's coverage is 0, or the scene's if the dump has none."""
    rounded_from: Storage | None = None
    """The storage of the texture, if the file has fewer bits than it: what read the texture had all of them."""
    space: Literal["world", "view"] = "world"
    """The space of a position or normal."""
    normals: Literal["xyz", "n*.5+.5", "octahedral"] = "xyz"
    """How a normal is stored: as it is, moved to 0..1, or as an octahedral map with components from -1 to 1."""
    depth: DepthKind = "window"
    """What a depth is: the window's, or a distance along the view axis, along the pixel's ray from the eye, or along
    that ray from the near plane. What lies beyond the far plane is nothing."""

    @field_validator("file")
    @classmethod
    def _is_known(cls, file: str) -> str:
        if Path(file).suffix.lower() not in SUFFIXES:
            raise unmet(f"a file name ending in {', '.join(SUFFIXES)}", "convert the file")
        if len(file) > LONGEST_NAME:
            raise unmet(f"a file name of at most {LONGEST_NAME} characters", "move the file nearer")
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
    def is_plain(self) -> bool:
        """Whether the numbers of the file are those of the buffer, apart from their signs."""
        scales = self.scale if isinstance(self.scale, tuple) else (self.scale,)
        turned = any(abs(scale) != 1 for scale in scales)
        return not turned and (self.offset, self.space, self.normals) == (0.0, "world", "xyz")

    @property
    def stored(self) -> dict[str, Any]:
        """The keys that `Encoding` keeps, apart from the storage."""
        return {name: getattr(self, name) for name in Encoding.__dataclass_fields__ if name not in ("storage", "loss")}


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
        return MappingFile.model_validate(toml_of(path, EXPECTED, DumpError))
    except ValidationError as error:
        problems = [described(details, _known(details["loc"]))[1] for details in error.errors()]
        raise DumpError("\n".join(f"{path}: {problem}" for problem in problems)) from None


def _known(location: tuple[str | int, ...]) -> Iterable[str]:
    """The keys of the table that an error is in."""
    return MappingFile.model_fields if len(location) == 1 else BufferTable.model_fields
