"""The Zarr store of a batch: an array for each buffer, a chunk for each item, and which items are there."""

import hashlib
import shutil
from collections.abc import Mapping
from contextlib import suppress
from functools import cached_property
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final
from uuid import uuid4

import numpy as np

from sss_ref.batch.sweep_file import Sweep
from sss_ref.errors import DumpError, SceneError
from sss_ref.errors.wording import told
from sss_ref.passes.buffers import described

STORE: Final = "buffers.zarr"
NAMES: Final = "item_name"  # of the array whose chunks are written last
NAME_BYTES = 16
ALL_CHUNKS: Any = {"write_empty_chunks": True}  # of each array that is opened: the store does not remember it
AXES = ("item", "row", "column", "channel")
NOTE = "A chunk for each item, row 0 at the bottom. An item is complete where item_name, its folder's, is not zero."


def check_zarr(sweep: Sweep) -> None:
    """Raise SceneError where a sweep asks for Zarr and the extra is missing."""
    found = metadata.version("zarr") if find_spec("zarr") else "none"
    if "zarr" in sweep.outputs and not found.startswith("3."):
        remedy = "run python -m pip install 'sss_ref[zarr]'"
        raise SceneError(told("outputs: zarr", "the package zarr, version 3", found, remedy))


def numbering(sweep: Sweep) -> str:
    """SHA-256 of what says which item has which number; more rounds than before change none of them."""
    scene = Path(sweep.scene).name
    text = sweep.model_dump_json(include={"combine", "seed", "set", "vary"})
    return hashlib.sha256(f"sss_ref numbering 1\n{scene}\n{text}".encode()).hexdigest()


class ItemArrays:
    """The store of a batch, as a process sees it that renders items.

    Any number of processes write into it at once, whole chunks, each of which appears as a whole. Arrays are made by
    whoever renders the first item that has such a buffer.
    """

    def __init__(self, batch: Path, items: int) -> None:
        """batch: its folder. items: how many the sweep has."""
        self.folder, self.items = batch / STORE, items
        self._arrays: dict[str, Any] = {}

    def holds(self, item: int, name: str) -> bool:
        """Whether all chunks of the item with that number are those of the item with that name."""
        return bytes(self._names[item]) == bytes.fromhex(name)

    def write(self, item: int, name: str, buffers: Mapping[str, np.ndarray]) -> None:
        """Write an item's chunks. Raises DumpError where a buffer has another form than in other items, and OSError."""
        if any(self._names[item]) and not self.holds(item, name):
            self._names[item] = 0  # another picture's, of a scene that was changed since
        for buffer in buffers:
            self._array(buffer, buffers[buffer])[item] = buffers[buffer]
        self._names[item] = np.frombuffer(bytes.fromhex(name), np.uint8)

    @cached_property
    def _names(self) -> Any:
        import zarr

        zarr.open_group(self.folder, mode="a", attributes={"note": NOTE})
        return self._opened(NAMES, np.zeros(NAME_BYTES, np.uint8), {"fill_value": 0, "compressors": None})

    def _array(self, buffer: str, sample: np.ndarray) -> Any:
        """The array of a buffer that is like `sample`."""
        if buffer not in self._arrays:
            nothing = np.nan if sample.dtype.kind == "f" else 0 if sample.dtype.kind == "u" else -1
            about = {"fill_value": nothing, "attributes": {"unit": described(buffer).unit}}
            self._arrays[buffer] = self._opened(buffer, sample, about)
        found = self._arrays[buffer]
        if _form(found.shape[1:], found.dtype) != _form(sample.shape, sample.dtype):
            expected = f"{_form(found.shape[1:], found.dtype)}, as other items have"
            remedy = "vary no size, or leave out the output zarr"
            raise DumpError(told(str(self.folder / buffer), expected, _form(sample.shape, sample.dtype), remedy))
        return found

    def _opened(self, name: str, sample: np.ndarray, about: Mapping[str, Any]) -> Any:
        """An array of the store, made if there is none yet, and at least as long as the sweep."""
        import zarr

        path = self.folder / name
        if not path.is_dir():
            self._make(path, sample, about)
        array = zarr.open_array(path, mode="r+").with_config(ALL_CHUNKS)
        if array.shape[0] < self.items:
            array.resize((self.items, *sample.shape))
        return array

    def _make(self, path: Path, sample: np.ndarray, about: Mapping[str, Any]) -> None:
        """Make an array beside the store, and move it in unless another process was faster."""
        import zarr

        hidden = path.parents[1] / f".{STORE}.{path.name}.{uuid4().hex}"
        zarr.create_array(
            hidden,
            shape=(self.items, *sample.shape),
            chunks=(1, *sample.shape),
            dtype=sample.dtype.newbyteorder("<"),
            chunk_key_encoding={"name": "default", "separator": "."},  # a file for each chunk, without three folders
            dimension_names=AXES[: 1 + sample.ndim],
            **about,
        )
        with suppress(OSError):
            hidden.rename(path)
        shutil.rmtree(hidden, ignore_errors=True)


def _form(shape: tuple[int, ...], kind: np.dtype[Any]) -> str:
    return f"{' x '.join(map(str, shape))} of {kind.name}"
