"""From stored texels to the numbers they stand for: what a sampler returns, in float32, or integers, in int32."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sss_ref.dump.held import HELD, are_held
from sss_ref.dump.loss import Loss
from sss_ref.errors import DumpError
from sss_ref.errors.wording import told
from sss_ref.scene_file.color_texture import srgb_decoded

Storage = Literal[
    "float32",
    "float16",
    "unorm8",
    "unorm16",
    "snorm8",
    "snorm16",
    "srgb8",
    "r11g11b10f",
    "rgb10a2",
    "rgb9e5",
    "uint8",
    "uint16",
    "uint32",
    "int8",
    "int16",
    "int32",
]
INTEGERS = ("uint8", "uint16", "uint32", "int8", "int16", "int32")
LARGEST_CODE = {"unorm8": 255, "unorm16": 65535, "snorm8": 127, "snorm16": 32767}
PACKED = ("r11g11b10f", "rgb10a2", "rgb9e5")

FAMILIES: tuple[tuple[Storage, ...], ...] = (
    ("unorm8", "srgb8", "uint8"),
    ("unorm16", "uint16"),
    ("snorm8", "int8"),
    ("snorm16", "int16"),
    ("uint32", "int32"),
)
READ_AS: dict[str, tuple[str, ...]] = {
    "float32": ("float32", *HELD),
    "float16": ("float16", "r11g11b10f", "rgb9e5"),
    **{storage: family for family in FAMILIES for storage in family},
}
"""What a file's own storage may be taken for if the mapping file says so; any other only for itself."""


@dataclass(frozen=True)
class Encoding:
    """How a buffer was stored, and what was done to get it back: value = stored * scale + offset.

    storage: of the texture. "unormN": n/(2^N - 1); "snormN": n/(2^(N-1) - 1), and not below -1. "srgb8": IEC 61966-2-1,
        alpha linear. "uint32": 4294967295 is -1, as are 65535 of "uint16" and 255 of "uint8" among triangle numbers.
        Packed formats, of which a file of floats may say that it was one: "r11g11b10f", "rgb10a2", "rgb9e5" (three
        channels with one exponent). "unorm24" is a depth of 24 bits, "float24" what PXR24 leaves of float32.
    scale, offset: one number, or one for each channel.
    rounded_from: the storage of the texture where the file has fewer bits than it; else None.
    space: "world" or "view". normals: "xyz", "n*.5+.5" or "octahedral"; see `vectors`. depth: see `depths`.
    loss: how far a value may be off where it is not that of the storage alone; else None.
    """

    storage: str
    scale: float | tuple[float, ...] = 1.0
    offset: float | tuple[float, ...] = 0.0
    rounded_from: str | None = None
    space: str = "world"
    normals: str = "xyz"
    depth: str = "window"
    loss: Loss | None = None


def storage_of(native: str, wanted: str | None, where: str) -> str:
    """The storage that was asked for, if a file of `native` storage can be taken for it. Raises DumpError."""
    allowed = READ_AS.get(native, (native,))
    if wanted is None or wanted in allowed:
        return wanted or native
    raise DumpError(told(where, f"one of {', '.join(allowed)} for a file of {native}", wanted, "correct the encoding"))


def decoded(data: np.ndarray, channels: Sequence[str], storage: str, where: str) -> np.ndarray:
    """The numbers that texels (H, W, C) stand for, float32 or int32.

    channels: their names; "A" is linear in sRGB too. Raises DumpError where a file of float32 is said to come from a
    texture that cannot have held its values.
    """
    if storage in INTEGERS:
        return data.astype(np.int64).astype(np.uint32).view(np.int32)
    if data.dtype == np.float32:
        return _checked(data, storage, where)
    if data.dtype == np.float16:
        return _checked(data.astype(np.float32), storage, where)
    if data.dtype.kind == "i":
        return np.maximum(data.astype(np.float32) / np.float32(LARGEST_CODE[storage]), np.float32(-1))
    linear = data.astype(np.float32) / np.float32(LARGEST_CODE.get(storage, 255))
    if storage == "srgb8":
        return np.where([name == "A" for name in channels], linear, srgb_decoded()[data])
    return linear


def scaled(values: np.ndarray, scale: float | Sequence[float], offset: float | Sequence[float]) -> np.ndarray:
    """values * scale + offset in float64, of floats rounded once to float32; the values themselves for 1 and 0."""
    if (scale, offset) == (1.0, 0.0):
        return values
    with np.errstate(over="ignore", invalid="ignore"):
        result = values.astype(np.float64) * np.asarray(scale) + np.asarray(offset)
        return result.astype(np.float32) if values.dtype.kind == "f" else result


def _checked(data: np.ndarray, storage: str, where: str) -> np.ndarray:
    """The float32 values of a file, if its texture can have held them."""
    other = ~are_held(data, storage) if storage in HELD else np.zeros(data.shape, bool)
    if other.any():
        came = repr(data[other][0].item())
        raise DumpError(told(where, f"values that {storage} can hold", came, "correct the encoding"))
    return data
