"""The folder of a batch, and batch.json in it, which says what every item has: two sweeps may share a folder."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Final, Literal
from uuid import uuid4

from pydantic import ValidationError

from sss_ref.batch.item_arrays import numbering
from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of
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
        write_whole(folder / BATCH, wanted.model_dump_json(indent=2, exclude_none=True) + "\n", _put_first)
    found = _read(folder / BATCH)  # that of another process where two begin at once
    if found != wanted:
        raise DumpError(told(str(folder), *_difference(found, wanted), "choose another folder"))
    return folder


def write_whole(path: Path, text: str, put: Callable[[Path, Path], object] = Path.replace) -> None:
    """Write a text file that is there as a whole or not at all. put: gives it its name. Raises DumpError."""
    try:
        hidden = path.with_name(f".{path.name}.{uuid4().hex}")
        hidden.write_text(text, encoding="utf-8", newline="")
        put(hidden, path)
    except OSError as error:
        raise DumpError(f"{path}: cannot be written ({error.strerror}); choose another folder") from None


def _put_first(hidden: Path, path: Path) -> None:
    """Give a file its name unless another process has put one there."""
    try:
        os.link(hidden, path)
    except FileExistsError:
        pass
    except OSError:  # a file system without links
        hidden.replace(path)
    hidden.unlink(missing_ok=True)


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
