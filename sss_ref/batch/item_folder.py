"""The folder of an item: named by what it is, there as a whole or not at all, with a record of itself."""

import hashlib
from pathlib import Path
from typing import Any, Final, Literal

from pydantic import ValidationError

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of
from sss_ref.errors.wording import told
from sss_ref.rendering.result import Result
from sss_ref.results.manifest import Record, Sha256, package_version, scene_hash
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.scene import Scene

RECORD: Final = "item.json"
NAME_DIGITS = 32  # hexadecimal, of an item's name; the first two are the name of the folder around it


class ItemRecord(Record):
    """item.json: what was rendered, by which rules, and what came out."""

    format: Literal["sss_ref item 1"] = "sss_ref item 1"
    package_version: str
    rules_version: int
    settings: dict[str, Any]
    """Every key of the scene."""
    inputs: dict[str, Sha256]
    """Array of the mesh, or texels -> hash after decoding."""
    buffers: dict[str, Sha256]
    """Kept buffer -> hash, rule A5."""
    seconds: float
    """Of rendering alone: neither the scene's loading nor the files' writing."""


def item_name(scene: Scene, inputs: dict[str, str]) -> str:
    """The name of a scene's item: a hash of the rules, of every key of the scene and of what it reads."""
    lines = [
        f"sss_ref item 1\n{RULES_VERSION}\n{scene_hash(scene)}",
        *(f"{key} {inputs[key]}" for key in sorted(inputs)),
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:NAME_DIGITS]


def item_folder(batch: Path, name: str) -> Path:
    """Where the item of that name is; few enough of them in one folder for any file system."""
    return batch / "items" / name[:2] / name


def record_of(result: Result, inputs: dict[str, str], seconds: float) -> ItemRecord:
    """What is recorded of a rendering."""
    return ItemRecord(
        package_version=package_version(),
        rules_version=RULES_VERSION,
        settings=result.scene.settings.model_dump(mode="json"),
        inputs=inputs,
        buffers=result.hashes,
        seconds=round(seconds, 6),
    )


def read_record(folder: Path) -> ItemRecord | None:
    """The record of a complete item; None where there is no such folder. Raises DumpError for a damaged one."""
    if not folder.is_dir():
        return None
    text = text_of(folder / RECORD, "the record of an item", DumpError)
    try:
        return ItemRecord.model_validate_json(text)
    except ValidationError:
        remedy = "delete the folder and it is rendered again"
        raise DumpError(told(str(folder / RECORD), "what sss-ref batch writes", "something else", remedy)) from None
