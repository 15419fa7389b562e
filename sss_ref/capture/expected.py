"""What a file would hold if it were a buffer's: the oracle's numbers in each of the ways they are usually stored in."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from sss_ref.capture.resemblance import Columns, uncommon
from sss_ref.capture.surfaces import Unnamed
from sss_ref.dump.slots import Slot
from sss_ref.dump.srgb import srgb_encoded
from sss_ref.dump.whole import CODES
from sss_ref.passes.buffers import described
from sss_ref.view.views import View

MOST_PIXELS = 1024  # that two pictures are compared at
MOST_ROWS = 96  # of the grid on which it is seen where something is drawn
CONSTANT = 0.6  # how much must speak for a place of what is the same on all pixels that are drawn
MASK = 0.8  # ... of what is yes or no
LARGEST = {"unorm8": 255, "unorm16": 65535}

PLAIN: Mapping[str, Any] = {}


@dataclass(frozen=True, eq=False)
class Pixels:
    """The pixels of pictures of one size that are compared: rows and columns, row 0 at the bottom; a grid of all."""

    rows: np.ndarray
    columns: np.ndarray
    grid: tuple[np.ndarray, np.ndarray]

    @classmethod
    def among(cls, where: np.ndarray) -> "Pixels":
        """Some of the pixels of a mask, bool (H, W), spread over it."""
        found = np.flatnonzero(where) if where.any() else np.arange(where.size)
        chosen = found[np.linspace(0, len(found) - 1, min(MOST_PIXELS, len(found))).astype(int)]
        rows, columns = np.unravel_index(chosen, where.shape)
        steps = [np.linspace(0, count - 1, min(MOST_ROWS, count)).astype(int) for count in where.shape]
        across, up = np.meshgrid(steps[1], steps[0])
        return cls(rows, columns, (up.ravel(), across.ravel()))

    def of(self, picture: np.ndarray) -> np.ndarray:
        """The values of a picture (H, W) or (H, W, C), row 0 at the bottom: float64 (P, C)."""
        return np.asarray(picture[self.rows, self.columns].reshape(len(self.rows), -1), np.float64)

    def columns_of(self, picture: np.ndarray) -> Columns:
        """The same, with what comparing takes."""
        on_grid = picture[self.grid].reshape(len(self.grid[0]), -1)
        return Columns.of(self.of(picture), uncommon(on_grid))


@dataclass(frozen=True, eq=False)
class Reading:
    """Numbers that a file of a buffer may hold, and the keys of the mapping file that bring them into our form.

    storages: of the files that may hold them, empty for all.
    """

    expected: Columns
    keys: Mapping[str, Any] = field(default_factory=dict)
    storages: tuple[str, ...] = ()

    def fits(self, surface: Unnamed) -> bool:
        """Whether the surface may hold such numbers."""
        return not self.storages or surface.texels.storage in self.storages


@dataclass(frozen=True, eq=False)
class Sought:
    """A buffer that files are searched for: the oracle's, and the pixels at which it is compared."""

    slot: Slot
    buffer: np.ndarray
    pixels: Pixels
    camera: View

    @property
    def is_whole(self) -> bool:
        """Whether it holds numbers of triangles, or yes and no."""
        return self.slot.dtype.kind != "f"

    @property
    def is_blank(self) -> bool:
        """Whether it holds one value everywhere, by which nobody would know it."""
        return not (self.buffer != self.buffer.reshape(-1, self.slot.channels)[0]).any()

    @property
    def least(self) -> float:
        """How much must speak for a place of it: more for a constant, which has no order, and for masks, all alike."""
        if self.slot.dtype.kind == "u":
            return MASK
        return 0.0 if self.readings[0].expected.standard.any() else CONSTANT

    @cached_property
    def readings(self) -> list[Reading]:
        """The numbers themselves first, then other ways to store them."""
        picture = self.buffer.astype(np.float64).reshape(self.slot.height, self.slot.width, self.slot.channels)
        return [Reading(self.pixels.columns_of(held), keys, kinds) for held, keys, kinds in self._ways(picture)]

    def _ways(self, picture: np.ndarray) -> Iterator[tuple[np.ndarray, Mapping[str, Any], tuple[str, ...]]]:
        if self.slot.dtype.kind == "i":
            yield picture, PLAIN, ("float32", "float16", "int8", "int16", "int32", "uint8", "uint16", "uint32")
            for storage in CODES:
                yield np.where(picture < 0, 1.0, picture / LARGEST[storage]), PLAIN, (storage,)
            return
        yield picture, PLAIN, ()
        unit = described(self.slot.name).unit
        if self.slot.dtype.kind == "u":
            yield picture * LARGEST["unorm8"], {"encoding": "unorm8"}, ("uint8",)
        if unit.startswith("linear RGB"):
            yield srgb_encoded(np.clip(picture, 0, 1)), {"encoding": "srgb8"}, ("unorm8",)
        if unit.startswith("texture coordinates"):
            yield np.where(picture < 0, picture, picture * (1, -1) + (0, 1)), {"scale": [1, -1], "offset": [0, 1]}, ()
        if self.slot.is_window_depth and self.slot.view:
            yield from _depths(picture, self.slot.view)
        if self.slot.is_direction:
            yield picture * 0.5 + 0.5, {"normals": "n*.5+.5"}, ()
        if self.slot.is_spatial:
            yield from self._in_view(picture)

    def _in_view(self, picture: np.ndarray) -> Iterator[tuple[np.ndarray, Mapping[str, Any], tuple[str, ...]]]:
        turn = self.camera.view[:3, :3]
        start = 0.0 if self.slot.is_direction else np.asarray(self.camera.eye)
        turned = np.stack([((picture - start) * row).sum(axis=-1) for row in turn], axis=-1)
        yield turned, {"space": "view"}, ()
        if self.slot.is_direction:
            yield turned * 0.5 + 0.5, {"space": "view", "normals": "n*.5+.5"}, ()


def _depths(picture: np.ndarray, view: View) -> Iterator[tuple[np.ndarray, Mapping[str, Any], tuple[str, ...]]]:
    """Window depth the other way round, and the distance along the view axis."""
    yield 1 - picture, {"scale": -1, "offset": 1}, ()
    span = view.far - view.near
    along = view.near + picture * span if view.lens.is_parallel else view.far * view.near / (view.far - picture * span)
    yield along, {"depth": "view"}, ()


def sought(slots: Mapping[str, Slot], buffers: Mapping[str, np.ndarray], camera: View) -> dict[str, Sought]:
    """The buffers of a rendering that files may be, each compared where something is drawn; masks everywhere."""
    chosen: dict[tuple[Any, ...], Pixels] = {}
    found = {}
    for name, buffer in buffers.items():
        slot = slots[name]
        mask = slot.mask if slot.mask in buffers and slot.mask != name else ""
        key = (slot.width, slot.height, mask)
        if key not in chosen:
            chosen[key] = Pixels.among(_drawn(buffers[mask]) if mask else np.ones(buffer.shape[:2], bool))
        found[name] = Sought(slot, buffer, chosen[key], camera)
    return found


def _drawn(mask: np.ndarray) -> np.ndarray:
    return mask > 0 if mask.dtype == np.uint8 else mask >= 0
