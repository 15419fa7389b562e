"""The result folder: pictures, buffers and manifest, all there or not there at all."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.array_file import mapped_array
from sss_ref.errors.text_file import check_regular, text_of
from sss_ref.errors.wording import told
from sss_ref.rendering.result import Result
from sss_ref.results.manifest import FILE_NAME, FORMAT
from sss_ref.results.saving import Saving, filling
from sss_ref.results.whole_folder import appearing, writable


def save(result: Result, folder: Path, interpreter: str | None = None, threads: int | None = None) -> Path:
    """Write a rendering into `folder`, replacing an earlier result there; returns the absolute path.

    interpreter, threads: what it was rendered with, for the manifest. Writes `image.png` (if the image was kept),
    `overview.png` (if anything else was), `buffers.exr`, `buffers/NAME.npy` and `manifest.json`.
    Raises DumpError where the folder is not ours to replace or cannot be written; it is then left as it was.
    """
    with saving(folder, interpreter, threads) as files:
        files.finish(result)
    return folder.resolve()


@contextmanager
def saving(folder: Path, interpreter: str | None, threads: int | None) -> Iterator[Saving]:
    """Write a rendering while it is made: what comes takes buffers, and finishes with the result; otherwise as `save`.

    The folder appears at the end, or not at all if something goes wrong, be it the rendering.
    """
    with appearing(checked_target(folder)) as part, filling(part, interpreter, threads) as files:
        yield files


def checked_target(folder: Path) -> Path:
    """The absolute path of a folder that a result can be written to. Raises DumpError where it cannot."""
    return writable(folder, _is_result, "an earlier result")


def read_buffer(path: Path) -> np.ndarray:
    """The buffer (H, W) or (H, W, C), row 0 at the bottom, in the NPY file at `path`; DumpError if it is none."""
    expected, again = "a buffer in NPY format", "render the scene again"
    check_regular(path, expected, DumpError)
    try:
        buffer = mapped_array(path)  # a mapping fails early where the file is too short
    except Exception:  # whatever a broken file makes NumPy raise, a tokenizer's error too
        raise DumpError(told(str(path), expected, "one that is damaged or cut off", again)) from None
    if buffer is None:
        raise DumpError(told(str(path), expected, "an archive", again))
    return np.array(buffer)


def _is_result(folder: Path) -> bool:
    """Whether a folder has a manifest of this package, of whatever version."""
    try:
        content = json.loads(text_of(folder / FILE_NAME, "a manifest", DumpError))
        return bool(content["format"] == FORMAT)
    except (DumpError, ValueError, LookupError, TypeError, RecursionError):
        return False
