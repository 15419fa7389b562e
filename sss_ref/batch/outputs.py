"""The files of an item, beside its record."""

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from sss_ref.pictures.png_file import image_encoding_of, write_png
from sss_ref.rendering.result import Result
from sss_ref.results.saving import preview, write_buffers_exr


def write_outputs(result: Result, outputs: tuple[str, ...], folder: Path) -> None:
    """Write a rendering into an item's folder, in each of the formats that are asked for and lie there."""
    for name in outputs:
        if name in WRITERS:
            WRITERS[name](result, folder)


def _write_picture(result: Result, folder: Path) -> None:
    write_png(folder / "image.png", *preview(result), encode=image_encoding_of(result.scene.settings))


def _write_archive(result: Result, folder: Path) -> None:
    little = {name: each.astype(each.dtype.newbyteorder("<"), copy=False) for name, each in result.buffers.items()}
    np.savez(folder / "buffers.npz", allow_pickle=False, **little)


WRITERS: Mapping[str, Callable[[Result, Path], None]] = {
    "png": _write_picture,
    "npz": _write_archive,
    "exr": write_buffers_exr,
}
