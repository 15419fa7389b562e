"""From the texels of a file to a buffer in our form: part, channels, rows, numbers, vectors, type."""

import numpy as np

from sss_ref.dump.encoding import Encoding, decoded, scaled, storage_of
from sss_ref.dump.sources import Source
from sss_ref.dump.texels import StoredTexels
from sss_ref.dump.vectors import in_world, octahedral, unit_range
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.scene.forms import Form
from sss_ref.view.views import View

USUAL_NAMES = {1: ("R", "Y", "Z"), 2: ("RG", "UV", "XY"), 3: ("RGB", "XYZ")}  # by count
EXACT_BELOW = 2.0**31  # what int32 can hold; float32 holds far fewer, but all it holds are exact

Converted = tuple[np.ndarray, Encoding, tuple[str, ...]]


def converted(source: Source, form: Form, parts: tuple[StoredTexels, ...], camera: View) -> Converted:
    """The buffer, how it was stored, and notes on what was passed over. Raises DumpError for what does not fit."""
    _check_keys(source, form)
    table = source.table
    count = 2 if table.normals == "octahedral" else form.channels
    texels, channels = _chosen(source, parts, count)
    _check_size(source, form, texels)
    storage = storage_of(texels.storage, table.encoding, source.at("encoding"))
    picked = texels.data[..., [texels.channels.index(name) for name in channels]]
    upright = picked[::-1] if source.origin == "top" else picked
    values = scaled(decoded(upright, channels, storage, source.at("encoding")), table.scale, table.offset)
    data = _typed(_vectors(values, source, form, camera), form, source)
    shaped = data[..., 0] if form.channels == 1 else data
    return np.ascontiguousarray(shaped), Encoding(storage, **table.stored), _notes(source, texels, channels)


def _check_keys(source: Source, form: Form) -> None:
    """Raise DumpError for a key that this buffer or file cannot have, or lacks."""
    table = source.table
    if source.origin is None:
        raise DumpError(told(source.at("origin"), '"top" or "bottom" for a raw file', "nothing", "add it"))
    if table.space == "view" and not form.is_spatial:
        expected = f'"world", as {form.name} has no space'
        raise DumpError(told(source.at("space"), expected, '"view"', "remove it"))
    if table.normals != "xyz" and not form.is_direction:
        expected = f'"xyz", as {form.name} is no normal'
        raise DumpError(told(source.at("normals"), expected, f'"{table.normals}"', "remove it"))


def _chosen(source: Source, parts: tuple[StoredTexels, ...], count: int) -> tuple[StoredTexels, tuple[str, ...]]:
    """The part that is the buffer's, and the names of its channels."""
    candidates = _parts_named(source, parts)
    for texels in candidates:
        channels = source.table.channels or _usual_channels(texels.channels, count)
        if channels and set(channels) <= set(texels.channels):
            if len(channels) == count:
                return texels, channels
            remedy = "name as many as the buffer has"
            raise DumpError(told(source.at("channels"), f"{count} channels", ", ".join(channels), remedy))
    there = ", ".join(name for texels in candidates for name in texels.channels)
    wanted = ", ".join(source.table.channels) if source.table.channels else f"{count} channels with usual names"
    raise DumpError(told(source.at("channels"), f"{wanted} in {source.path.name}", there, "name those of the buffer"))


def _parts_named(source: Source, parts: tuple[StoredTexels, ...]) -> list[StoredTexels]:
    """The part that was asked for, or the only one, or the one with the buffer's name (in one piece per type)."""
    names = list(dict.fromkeys(texels.part for texels in parts))
    wanted = source.table.part
    if wanted is None:
        wanted = names[0] if len(names) == 1 else source.name
    elif isinstance(wanted, int) and str(wanted) not in names and 0 <= wanted < len(names):
        wanted = names[wanted]
    if str(wanted) not in names:
        expected = f"the part {wanted} in {source.path.name}"
        raise DumpError(told(source.at("part"), expected, ", ".join(names) or "none", "name one of these"))
    return [texels for texels in parts if texels.part == str(wanted)]


def _usual_channels(there: tuple[str, ...], count: int) -> tuple[str, ...] | None:
    """The channels that a buffer of so many is commonly written to; None where the names say nothing."""
    by_letter = {name.upper(): name for name in there}
    for letters in USUAL_NAMES[count]:
        if set(letters) <= by_letter.keys():
            return tuple(by_letter[letter] for letter in letters)
    return there if len(there) == count == 1 else None


def _check_size(source: Source, form: Form, texels: StoredTexels) -> None:
    height, width = texels.data.shape[:2]
    if (width, height) != (form.width, form.height):
        expected = f"{form.width} x {form.height} pixels, as {form.target} of the scene"
        came = f"{width} x {height} of {form.name}"
        raise DumpError(told(str(source.path), expected, came, "dump it in that size or change the scene"))


def _vectors(values: np.ndarray, source: Source, form: Form, camera: View) -> np.ndarray:
    """Directions taken out of their encoding, and all vectors in world space."""
    if source.table.normals == "n*.5+.5":
        values = unit_range(values)
    elif source.table.normals == "octahedral":
        values = octahedral(values)
    return in_world(values, camera, form.is_direction) if source.table.space == "view" else values


def _typed(values: np.ndarray, form: Form, source: Source) -> np.ndarray:
    """The values in the buffer's type. Raises DumpError where one has no equal there."""
    if form.dtype.kind == "f":
        if values.dtype.kind != "f":
            expected, remedy = "floats, or a byte's share of 1", 'set encoding = "unorm8" or dump floats'
            raise DumpError(told(source.at("encoding"), f"{expected} for {form.name}", "integers", remedy))
        return values.astype(np.float32, copy=False)
    if form.dtype.kind == "u":
        is_held, expected = (values == 0) | (values == 1), "0 or 1"
    else:
        is_held, expected = (np.abs(values) < EXACT_BELOW) & (np.rint(values) == values), "whole numbers"
    if values.dtype != form.dtype and not is_held.all():
        row, column = np.argwhere(~is_held)[0][:2].tolist()
        came = f"{values[row, column, 0]!s} at pixel {column},{row} (column,row; row 0 at the bottom)"
        raise DumpError(told(str(source.path), f"{expected} in {form.name}", came, "check encoding, scale and offset"))
    return values.astype(form.dtype)


def _notes(source: Source, texels: StoredTexels, channels: tuple[str, ...]) -> tuple[str, ...]:
    notes = []
    if set(texels.channels) - set(channels):
        notes.append(f"channels {', '.join(channels)} of {', '.join(texels.channels)}")
    if source.table.space == "view":
        notes.append("turned from view space to world space")
    if source.table.normals != "xyz":
        notes.append("its encoding has no zero vector, so the background says nothing")
    return tuple(notes)
