"""The file of a witness: JSON, of which all is checked when it is read; docs/how_to/validate.md describes its keys."""

from pathlib import Path
from typing import Annotated, Any, Final, Literal

from pydantic import Field, ValidationError

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of, write_text
from sss_ref.errors.wording import described, told
from sss_ref.scene_file.quantities import Table

FORMAT: Final = "sss_ref witness 1"
PLAIN = "float32"  # a storage that loses nothing
Extent = Annotated[tuple[Annotated[int, Field(ge=1, le=2**31 - 1)], ...], Field(min_length=1, max_length=2)]
Storage = str | dict[str, float]


class StageRecord(Table):
    """As `StageTold`."""

    name: str
    source: str
    kinds: dict[str, str] = Field(default_factory=dict)
    rays: tuple[str, ...] = ()


class ValueRecord(Table):
    """A value that is known no better than by its ends."""

    value: str
    low: str
    high: str


class ElementsRecord(Table):
    """The elements that may be read of a texture, whose size is (width, height), or of an array, (length).

    at: their places, as `blocks_text` writes them, or the name of a parameter that is read at the same ones. bits: the
    elements in that order. low, high: their ends, where they are known no better. span: as in `Texels`.
    """

    size: Extent
    at: str
    bits: str
    low: str = ""
    high: str = ""
    span: float = 0.0


Read = str | ValueRecord | ElementsRecord


class WitnessRecord(Table):
    """The whole file; bits are written as `bits_text` says."""

    format: Literal["sss_ref witness 1"]
    rules: int
    stage: StageRecord
    output: str
    buffer: str
    in_pass: str
    at: tuple[int, int]
    device: str | None = None
    profile: dict[str, Any]
    stored: Storage = PLAIN
    rounded: Storage = PLAIN
    reads: dict[str, Read]
    got: str
    expected: str
    low: str
    high: str
    why: tuple[str, ...] = ()


def write_record(record: WitnessRecord, path: Path) -> Path:
    """Write the file; returns its path. Raises DumpError."""
    return write_text(path, record.model_dump_json(exclude_defaults=True) + "\n", DumpError)


def read_record(path: Path) -> WitnessRecord:
    """The record in a file. Raises DumpError, which lists all that is wrong with it."""
    text = text_of(path, "a witness", DumpError)
    try:
        return WitnessRecord.model_validate_json(text)
    except ValidationError as error:
        known = WitnessRecord.model_fields
        problems = (described(each, known)[1] for each in error.errors() if each["type"] != "json_invalid")
        told_all = [f"{path}: {problem}" for problem in problems]
        no_json = told(str(path), "a witness in JSON", "none", "write it with validate --witness")
        raise DumpError("\n".join(told_all) or no_json) from None
