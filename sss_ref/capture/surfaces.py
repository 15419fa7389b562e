"""The pictures of a folder whose names say nothing: every surface of every file that can be read."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.dump.encoding import decoded
from sss_ref.dump.files import BOTTOM_FIRST, RAW, READERS, parts_of
from sss_ref.dump.loss import loss_of
from sss_ref.dump.mapping import Origin
from sss_ref.dump.texels import StoredTexels
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told

HALF_A_STEP = 0.51  # of the steps between a storage's numbers, and a little for the way to it


@dataclass(frozen=True, eq=False)
class Unnamed:
    """A picture: its file, the channels of it that belong together, and what is known of it beside its texels.

    part: what the mapping file calls it, None where the file has one alone. labels: of a capture, what it is called.
    is_spare: whether it counts only where no other is the buffer, as the depths do that a draw tests against.
    given: keys of the mapping file that say what the file does not.
    """

    path: Path
    texels: StoredTexels
    part: str | None = None
    labels: tuple[str, ...] = ()
    is_spare: bool = False
    given: Mapping[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return self.path.name if self.part is None else f"{self.path.name} ({self.part}: {', '.join(self.channels)})"

    @property
    def channels(self) -> tuple[str, ...]:
        """Their names in the file."""
        return self.texels.channels

    @property
    def size(self) -> tuple[int, int]:
        """Width and height."""
        height, width = self.texels.data.shape[:2]
        return width, height

    @cached_property
    def values(self) -> np.ndarray:
        """The numbers that the texels stand for, (H, W, C), rows in the order of the file; NaN and infinity as 0."""
        numbers = decoded(self.texels.data, self.channels, self.texels.storage, str(self.path)).astype(np.float64)
        return np.where(np.isfinite(numbers), numbers, 0.0)

    @cached_property
    def tolerance(self) -> np.ndarray:
        """How far the values may be from what was drawn, for what their storage rounds away; of their shape."""
        return HALF_A_STEP * (self.texels.loss or loss_of(self.texels.storage)).step(self.values)

    @cached_property
    def content(self) -> tuple[bytes, ...]:
        """What two surfaces with the same numbers have in common, whichever way their rows run and channels go."""
        upright, turned = (
            tuple(sorted(sha256(rows[..., k].tobytes()).digest() for k in range(rows.shape[2])))
            for rows in (self.values, self.values[::-1])
        )
        return min(upright, turned)

    @cached_property
    def is_blank(self) -> bool:
        """Whether every texel is the same."""
        return not (self.values != self.values[0, 0]).any()

    @cached_property
    def is_even(self) -> bool:
        """Whether it is the same upside down."""
        return bool((self.values == self.values[::-1]).all())

    @cached_property
    def opacity(self) -> int | None:
        """The alpha of a colour, if it only says where something is drawn, being 0 or 1; None of other pictures."""
        alpha = self.channels.index("A") if len(self.channels) == len("RGBA") and "A" in self.channels else None
        return alpha if alpha is not None and np.isin(self.values[..., alpha], (0.0, 1.0)).all() else None

    @property
    def usual_origin(self) -> Origin:
        """The row that files of its kind begin with."""
        return "bottom" if self.path.suffix.lower() in BOTTOM_FIRST else "top"

    def keys(self, channels: tuple[int, ...], origin: str) -> dict[str, Any]:
        """What the mapping file says of where it is."""
        names = [self.channels[channel] for channel in channels]
        part = {} if self.part is None else {"part": self.part}
        return {"file": self.path.name, **part, "channels": names, "origin": origin, **self.given}


def surfaces_of(folder: Path) -> tuple[list[Unnamed], list[str]]:
    """The surfaces of a folder's files, by name, and a note for each file that is none.

    Raises DumpError where the folder cannot be read or has no picture.
    """
    try:
        files = sorted(path for path in folder.iterdir() if path.is_file())
    except OSError as error:
        raise DumpError(told(str(folder), "a folder", error.strerror or str(error), "check the path")) from None
    found: list[Unnamed] = []
    notes = []
    for path in files:
        try:
            found += _surfaces(path)
        except DumpError as error:
            notes.append(str(error))
    if not found:
        expected, remedy = f"pictures ({', '.join(READERS)})", "give the folder that your renderer wrote into"
        raise DumpError(told(str(folder), expected, "none that can be read", remedy))
    return found, notes


def _surfaces(path: Path) -> list[Unnamed]:
    suffix = path.suffix.lower()
    if suffix in RAW:
        raise DumpError(told(str(path), "a file that gives its shape", "raw bytes", "write a mapping file"))
    if suffix not in READERS:
        raise DumpError(told(str(path), f"a picture ({', '.join(READERS)})", suffix or "no suffix", "it is left out"))
    parts = parts_of(path)
    several = len(parts) > 1 or any(texels.are_named and len(_groups(texels)) > 1 for texels in parts)
    return [
        Unnamed(path, picked, texels.part if several else None)
        for texels in (part.placed()[0] for part in parts)
        for picked in _pieces(texels)
    ]


def _pieces(texels: StoredTexels) -> list[StoredTexels]:
    """The channels that one compression has not spoiled, layer by layer."""
    return [_only(texels, kept) for group in _groups(texels) if (kept := [c for c in group if c not in texels.spoiled])]


def _only(texels: StoredTexels, names: list[str]) -> StoredTexels:
    data = texels.data[..., [texels.channels.index(name) for name in names]]
    return replace(texels, data=data, channels=tuple(names))


def _groups(texels: StoredTexels) -> list[list[str]]:
    """The channels by what stands before the last dot, as EXR files name layers."""
    groups: dict[str, list[str]] = {}
    for name in texels.channels:
        groups.setdefault(name.rpartition(".")[0], []).append(name)
    return list(groups.values())
