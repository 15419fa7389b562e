"""The folder of a batch, and batch.json in it, which says what every item has: two sweeps may share a folder."""

from contextlib import suppress
from pathlib import Path
from typing import Final, Literal

from pydantic import ValidationError

from sss_ref.batch.item_arrays import numbering
from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of, write_text
from sss_ref.errors.whole_file import put_new
from sss_ref.errors.wording import told
from sss_ref.results.manifest import Record, Sha256
from sss_ref.results.whole_folder import writable

BATCH: Final = "batch.json"


class BatchRecord(Record):
    """batch.json."""

    format: Literal["sss_ref batch 1"] = "sss_ref batch 1"
    outputs: list[str]
    keep: list[str]
    numbering: Sha256 | None = None
    """Of the sweep that numbers the items of a Zarr store; None where there is none."""


def claim(folder: Path, sweep: Sweep) -> Path:
    """Make a folder that of a batch, or go on with one; returns the absolute path.

    Raises DumpError where it has other files, or items with other outputs or buffers, or a Zarr store of another sweep.
    """
    folder = writable(folder, lambda found: (found / BATCH).is_file(), "an earlier batch")
    numbered = numbering(sweep) if "zarr" in sweep.outputs else None
    wanted = BatchRecord(outputs=sorted(sweep.outputs), keep=sorted(sweep.keep), numbering=numbered)
    if not (folder / BATCH).is_file():
        folder.mkdir(parents=True, exist_ok=True)
        with suppress(FileExistsError):  # another process was first
            text = wanted.model_dump_json(indent=2, exclude_none=True) + "\n"
            write_text(folder / BATCH, text, DumpError, put_new)
    found = _read(folder / BATCH)
    if found != wanted:
        raise DumpError(told(str(folder), *_difference(found, wanted), "choose another folder"))
    return folder


def _difference(found: BatchRecord, wanted: BatchRecord) -> tuple[str, str]:
    """What was expected of a batch for a folder, and what came."""
    if (found.outputs, found.keep) == (wanted.outputs, wanted.keep):
        return "the sweep that has numbered the items of the Zarr store there", "another one"
    expected, came = (f"outputs {each.outputs} and keep {each.keep}" for each in (found, wanted))
    return f"{expected}, as the items there have", came


def _read(path: Path) -> BatchRecord:
    text = text_of(path, "the record of a batch", DumpError)
    try:
        return BatchRecord.model_validate_json(text)
    except ValidationError:
        raise DumpError(
            told(str(path), "what sss-ref batch writes", "something else", "choose another folder")
        ) from None
