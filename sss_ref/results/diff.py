"""Comparing two sets of buffers bit by bit: which buffer differs first, where, and how far apart the values are."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import DumpError
from sss_ref.passes.buffers import BUFFERS, entry_of, is_listed

BUFFER_TYPES = ("<f4", "<i4", "|u1")
CHANNELS = ((), (2,), (3,))  # what follows height and width in a buffer's shape
ULP_BOUNDS = (1, 2, 4, 16, 256)  # the least distance of each class after the first
ULP_CLASSES = ("0", "1", "2-3", "4-15", "16-255", "more", "sign, NaN")
"""Distances in units in the last place; last, values of different sign and NaN, which have no such distance."""


@dataclass(frozen=True)
class BufferDiff:
    """What a buffer of A and the one of B have in common, and what not."""

    name: str
    pixels: int
    differing: int  # pixels with other bits in any channel
    largest: float  # difference of two finite values, in the buffer's unit
    ulps: tuple[int, ...]  # values, one a channel of a pixel, in each of ULP_CLASSES
    first: str | None  # the first differing pixel in words


@dataclass(frozen=True)
class FolderDiff:
    """The buffers that both have, in stage order, and the names of those that one has alone."""

    buffers: tuple[BufferDiff, ...]
    only_in_a: tuple[str, ...]
    only_in_b: tuple[str, ...]

    @property
    def first(self) -> BufferDiff | None:
        """The first buffer in stage order that differs: what differs after it may only be its consequence."""
        return next((one for one in self.buffers if one.differing), None)


def diff(a: Path, b: Path) -> FolderDiff:
    """Compare two folders of buffers, without reading more than two buffers at a time.

    Stage order is that of the first manifest found, else that of `BUFFERS`.
    a, b: result folders, or folders of NPY files named after the buffers.
    Raises DumpError where a folder has no buffers, a file is no buffer, the two have none in common, or one differs in
    size or type.
    """
    files_a, files_b = buffer_files(a), buffer_files(b)
    order = _stage_order(a, b)
    shared = sorted(files_a.keys() & files_b.keys(), key=order)
    if not shared:
        raise DumpError(f"{b}: expected a buffer that {a} has ({', '.join(files_a)}), got {', '.join(files_b)}")
    found = tuple(compared(name, *buffer_pair(files_a[name], files_b[name])) for name in shared)
    only_a, only_b = (tuple(sorted(files.keys() - set(shared), key=order)) for files in (files_a, files_b))
    return FolderDiff(found, only_a, only_b)


def compared(name: str, a: np.ndarray, b: np.ndarray) -> BufferDiff:
    """Compare two buffers of one type and shape, (H, W) or (H, W, C)."""
    differing = int(np.count_nonzero(differing_pixels(a, b)))
    ulps = np.bincount(ulp_class(a, b).reshape(-1), minlength=len(ULP_CLASSES))
    first = first_difference(a, b, ("A", "B")) if differing else None
    return BufferDiff(name, a.shape[0] * a.shape[1], differing, _largest(a, b), tuple(ulps.tolist()), first)


def differing_pixels(a: np.ndarray, b: np.ndarray) -> NDArray[np.bool_]:
    """Where any bit of any channel differs, (H, W)."""
    differing: NDArray[np.bool_] = (bits(a) != bits(b)).reshape(*a.shape[:2], -1).any(axis=-1)
    return differing


def ulp_class(a: np.ndarray, b: np.ndarray) -> NDArray[np.intp]:
    """For every value the index of its class in ULP_CLASSES; of integers the unit in the last place is 1.

    Floats of one sign are ordered like their bit patterns, so the distance is the difference of these.
    """
    distance = np.abs(bits(a).astype(np.int64) - bits(b).astype(np.int64))
    apart = (a < 0) != (b < 0)
    if a.dtype.kind == "f":
        apart = np.isnan(a) | np.isnan(b) | (np.signbit(a) != np.signbit(b))
    classes = np.searchsorted(ULP_BOUNDS, distance, side="right")
    return np.where(apart & (distance != 0), len(ULP_BOUNDS) + 1, classes)


def first_difference(a: np.ndarray, b: np.ndarray, sides: tuple[str, str] = ("recorded", "now")) -> str:
    """Where two buffers of one type first differ, row by row from the bottom, with values and bit patterns."""
    if a.shape != b.shape:
        return f"its shape: {sides[0]} {a.shape}, {sides[1]} {b.shape}"
    differs = differing_pixels(a, b)
    row, column = np.argwhere(differs)[0]
    return (
        f"first at pixel {column},{row} (column,row; row 0 at the bottom): "
        f"{sides[0]} {_shown(a[row, column])}, {sides[1]} {_shown(b[row, column])}; "
        f"{np.count_nonzero(differs)} of {differs.size} pixels differ"
    )


def bits(values: np.ndarray) -> np.ndarray:
    """The bit patterns of values, as unsigned integers of the same size: -0 is not 0 here."""
    return np.ascontiguousarray(values).view(f"u{values.dtype.itemsize}")


def buffer_files(folder: Path) -> dict[str, Path]:
    """Name -> NPY file of the buffers in a result folder, or in a folder of such files."""
    inner = folder / "buffers"
    files = {path.stem: path for path in sorted((inner if inner.is_dir() else folder).glob("*.npy"))}
    if not files:
        raise DumpError(f"{folder}: expected a result folder or a folder of buffers, got one without NPY files")
    for name in files:
        _check_name(name, files[name])
    return files


def buffer_pair(file_a: Path, file_b: Path) -> tuple[np.ndarray, np.ndarray]:
    """The two versions of a buffer. Raises DumpError where they cannot be compared value by value."""
    from sss_ref.results.folder import read_buffer  # with all that saves: not for those who compare arrays

    a, b = read_buffer(file_a), read_buffer(file_b)
    for file, buffer in ((file_a, a), (file_b, b)):
        if buffer.dtype.str not in BUFFER_TYPES or buffer.shape[2:] not in CHANNELS or not buffer.size:
            expected = "float32, int32 or uint8 of height x width, perhaps x 2 or 3 channels"
            raise DumpError(f"{file}: expected {expected}, got {_form(buffer)}; convert it")
    if _form(a) != _form(b):
        raise DumpError(f"{file_b}: expected {_form(a)} as in {file_a}, got {_form(b)}; render both in one size")
    return a, b


def _check_name(name: str, file: Path) -> None:
    if not is_listed(name):
        raise DumpError(f"{file}: expected the name of a buffer ({', '.join(BUFFERS)}), got {name}; rename it")


def _stage_order(*folders: Path) -> Callable[[str], int]:
    """The place of a buffer's name in the first manifest there is; buffers it does not have come after its own."""
    from sss_ref.results.manifest import FILE_NAME, read_manifest

    manifests = [read_manifest(folder) for folder in folders if (folder / FILE_NAME).is_file()]
    recorded = [record.name for record in manifests[0].buffers] if manifests else []
    order = list(dict.fromkeys((*recorded, *BUFFERS)))
    return lambda name: order.index(name if name in order else entry_of(name))


def _form(buffer: np.ndarray) -> str:
    """Type and shape as text."""
    return f"{buffer.dtype} {' x '.join(map(str, buffer.shape))}"


def _largest(a: np.ndarray, b: np.ndarray) -> float:
    """The largest difference of two finite values, in float64, which holds that of two float32 or int32."""
    both = np.isfinite(a) & np.isfinite(b)
    return float(np.abs(a[both].astype(np.float64) - b[both]).max(initial=0))


def _shown(pixel: np.ndarray) -> str:
    """The channels of a pixel, each with its bit pattern."""
    channels = np.atleast_1d(pixel)
    digits = 2 * channels.dtype.itemsize
    return " ".join(
        f"{value!s} (0x{pattern:0{digits}x})" for value, pattern in zip(channels, bits(channels), strict=True)
    )
