"""From the texels of a file to a buffer in our form: part, channels, rows, numbers, vectors, type."""

from dataclasses import dataclass, replace

import numpy as np

from sss_ref.dump.choice import chosen
from sss_ref.dump.depths import window_depth, window_loss
from sss_ref.dump.encoding import Encoding, decoded, scaled, storage_of
from sss_ref.dump.loss import loss_of
from sss_ref.dump.precision import encoding_of
from sss_ref.dump.slots import Slot
from sss_ref.dump.sources import Source
from sss_ref.dump.texels import StoredTexels
from sss_ref.dump.vectors import in_world, octahedral, unit_range
from sss_ref.dump.whole import unfit, whole_numbers, written_as_codes
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.view.views import View


@dataclass(frozen=True, eq=False)
class Converted:
    """A buffer in our form, how it was stored, and notes on what was passed over.

    outside: bool (H, W), where the file has no texels. empty: where it holds what its mapping calls the background.
    """

    data: np.ndarray
    encoding: Encoding
    notes: tuple[str, ...]
    outside: np.ndarray | None = None
    empty: np.ndarray | None = None


def converted(source: Source, slot: Slot, parts: tuple[StoredTexels, ...], camera: View) -> Converted:
    """The buffer that a file holds. Raises DumpError for what does not fit."""
    count = 2 if source.table.normals == "octahedral" else slot.channels
    _check_keys(source, slot, count)
    texels, channels = chosen(source, parts, count)
    texels, outside = _sized(source, slot, texels)
    storage = _storage(source, slot, texels)
    stored = decoded(_upright(source, texels, channels), channels, storage, source.at("encoding"))
    encoding = encoding_of(source.table, storage, texels.loss, stored)
    values = scaled(stored, source.table.scale, source.table.offset)
    data = _typed(_vectors(values, source, slot, camera), slot, source, storage)
    if source.table.depth != "window" and slot.view:
        data = window_depth(data, source.table.depth, slot.view)
        loss = window_loss(encoding.loss or loss_of(storage), data, slot.view)
        encoding = replace(encoding, loss=loss, rounded_from=source.table.rounded_from or "float32")
    shaped = np.ascontiguousarray(data[..., 0] if slot.channels == 1 else data)
    notes = (*texels.notes, *_notes(source, slot, texels, channels, storage))
    outside = outside[::-1] if outside is not None and source.origin == "top" else outside
    return Converted(shaped, encoding, notes, outside, _empty(source, stored))


def _check_keys(source: Source, slot: Slot, count: int) -> None:
    """Raise DumpError for a key that this buffer or file cannot have, or lacks."""
    table = source.table
    if source.origin is None:
        raise DumpError(told(source.at("origin"), '"top" or "bottom" for a raw file', "nothing", "add it"))
    if table.space == "view" and not slot.is_spatial:
        expected = f'"world", as {slot.name} has no space'
        raise DumpError(told(source.at("space"), expected, '"view"', "remove it"))
    if table.normals != "xyz" and not slot.is_direction:
        expected = f'"xyz", as {slot.name} is no normal'
        raise DumpError(told(source.at("normals"), expected, f'"{table.normals}"', "remove it"))
    if table.depth != "window" and not (slot.is_window_depth and slot.view):
        expected = f'"window", as {slot.name} is no depth'
        raise DumpError(told(source.at("depth"), expected, f'"{table.depth}"', "remove it"))
    if table.background is not None and not slot.mask:
        expected = f"nothing, as all of {slot.name} is drawn"
        raise DumpError(told(source.at("background"), expected, str(table.background), "remove it"))
    for key in ("scale", "offset"):
        given = getattr(table, key)
        if isinstance(given, tuple) and len(given) != count:
            raise DumpError(told(source.at(key), f"one number or {count}", str(len(given)), "one for each channel"))


def _sized(source: Source, slot: Slot, texels: StoredTexels) -> tuple[StoredTexels, np.ndarray | None]:
    """The texels in the size of the buffer, in their frame if that has it, and where there are none.

    Parts of one EXR file have one display window, so a part without is taken as it is.
    """
    size, frame = texels.data.shape[1::-1], texels.frame
    if frame and (frame.width, frame.height) == (slot.width, slot.height):
        return texels.placed()
    if size != (slot.width, slot.height):
        expected = f"{slot.width} x {slot.height} pixels, as {slot.target} of the scene"
        came = f"{size[0]} x {size[1]} {f'{frame}, ' if frame else ''}of {slot.name}"
        raise DumpError(told(str(source.path), expected, came, "dump it in that size or change the scene"))
    return texels, None


def _storage(source: Source, slot: Slot, texels: StoredTexels) -> str:
    """What the texels stand for: as the mapping says, or the format; a picture of numbers holds numbers, not shares."""
    wanted: str | None = source.table.encoding
    if wanted is None and slot.dtype.kind == "i" and source.table.scale == 1.0:
        wanted = written_as_codes(texels)
    return storage_of(texels.storage, wanted, source.at("encoding"))


def _upright(source: Source, texels: StoredTexels, channels: tuple[str, ...]) -> np.ndarray:
    """The channels of the buffer, row 0 at the bottom."""
    picked = texels.data[..., [texels.channels.index(name) for name in channels]]
    return picked[::-1] if source.origin == "top" else picked


def _empty(source: Source, stored: np.ndarray) -> np.ndarray | None:
    """Where all channels hold what the mapping calls the background."""
    if source.table.background is None:
        return None
    return (stored.astype(np.float64) == float(np.float32(source.table.background))).all(axis=-1)


def _vectors(values: np.ndarray, source: Source, slot: Slot, camera: View) -> np.ndarray:
    """Directions taken out of their encoding, and all vectors in world space."""
    if source.table.normals == "n*.5+.5":
        values = unit_range(values)
    elif source.table.normals == "octahedral":
        values = octahedral(values)
    return in_world(values, camera, slot.is_direction) if source.table.space == "view" else values


def _typed(values: np.ndarray, slot: Slot, source: Source, storage: str) -> np.ndarray:
    """The values in the buffer's type. Raises DumpError where one has no equal there."""
    if slot.dtype.kind == "f":
        if values.dtype.kind != "f":
            expected, remedy = "floats, or a byte's share of 1", 'set encoding = "unorm8" or dump floats'
            raise DumpError(told(source.at("encoding"), f"{expected} for {slot.name}", "integers", remedy))
        return values.astype(np.float32, copy=False)
    if slot.dtype.kind == "i":
        return whole_numbers(values, slot, source, storage)
    is_held = (values == 0) | (values == 1)
    if values.dtype != slot.dtype and not is_held.all():
        raise DumpError(unfit(values, is_held, "0 or 1", slot, source))
    return values.astype(slot.dtype)


def _notes(source: Source, slot: Slot, texels: StoredTexels, channels: tuple[str, ...], storage: str) -> list[str]:
    notes = []
    if set(texels.channels) - set(channels):
        notes.append(f"channels {', '.join(channels)} of {', '.join(texels.channels)}")
    if slot.is_window_depth and storage == "float16":
        notes.append("half floats have 11 bits of a depth, and no texture of depths has so few: export it in more")
    if source.table.space == "view":
        notes.append("turned from view space to world space")
    if source.table.normals != "xyz":
        notes.append("its encoding has no zero vector, so the background says nothing")
    if source.table.depth != "window":
        notes.append(f"window depth computed from a distance ({source.table.depth}), nearly as exact as that")
    return notes
