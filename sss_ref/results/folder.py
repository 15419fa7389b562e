"""The result folder: pictures, buffers and manifest, all there or not there at all."""

import json
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import check_regular, text_of
from sss_ref.errors.wording import told
from sss_ref.pictures.overview import write_overview
from sss_ref.pictures.png_file import encoding_of, write_png
from sss_ref.rendering.result import Result
from sss_ref.rendering.samples import SampledResult
from sss_ref.results.exr_file import write_exr
from sss_ref.results.manifest import FILE_NAME, FORMAT, Manifest, manifest_of, package_version, scene_hash
from sss_ref.results.whole_folder import appearing, writable
from sss_ref.rules import RULES_VERSION


def save(result: Result, folder: Path, interpreter: str | None = None, threads: int | None = None) -> Path:
    """Write a rendering into `folder`, replacing an earlier result there; returns the absolute path.

    interpreter, threads: what it was rendered with, for the manifest. Writes `image.png` (if the image was kept),
    `overview.png`, `buffers.exr`, `buffers/NAME.npy` and `manifest.json`.
    Raises DumpError where the folder is not ours to replace or cannot be written; it is then left as it was.
    """
    folder = checked_target(folder)
    with appearing(folder) as part:
        _write(result, part, partial(manifest_of, result, interpreter, threads))
    return folder


def checked_target(folder: Path) -> Path:
    """The absolute path of a folder that a result can be written to. Raises DumpError where it cannot."""
    return writable(folder, _is_result, "an earlier result")


def read_buffer(path: Path) -> np.ndarray:
    """The buffer (H, W) or (H, W, C), row 0 at the bottom, in the NPY file at `path`; DumpError if it is none."""
    expected, again = "a buffer in NPY format", "render the scene again"
    check_regular(path, expected, DumpError)
    try:
        buffer = np.load(path, mmap_mode="r", allow_pickle=False)  # a mapping fails early where the file is too short
    except Exception:  # whatever a broken file makes NumPy raise, a tokenizer's error too
        raise DumpError(told(str(path), expected, "one that is damaged or cut off", again)) from None
    if not isinstance(buffer, np.ndarray):
        raise DumpError(told(str(path), expected, "an archive", again))
    return np.array(buffer)


def _is_result(folder: Path) -> bool:
    """Whether a folder has a manifest of this package, of whatever version."""
    try:
        content = json.loads(text_of(folder / FILE_NAME, "a manifest", DumpError))
        return bool(content["format"] == FORMAT)
    except (DumpError, ValueError, LookupError, TypeError, RecursionError):
        return False


def _write(result: Result, folder: Path, about: Callable[[], Manifest]) -> None:
    """All files, several at a time; about: makes the manifest, for which every buffer is hashed."""
    (folder / "buffers").mkdir()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        manifest = pool.submit(about)
        tasks = [pool.submit(_write_exr, result, folder)]
        tasks += [pool.submit(_write_pictures, result, folder)]
        tasks += [pool.submit(_write_buffer, folder, *named) for named in result.buffers.items()]
        for task in tasks:
            task.result()
        (folder / FILE_NAME).write_text(manifest.result().model_dump_json(indent=2) + "\n", encoding="utf-8")


def _write_buffer(folder: Path, name: str, buffer: np.ndarray) -> None:
    np.save(folder / "buffers" / f"{name}.npy", buffer.astype(buffer.dtype.newbyteorder("<"), copy=False))


def _write_exr(result: Result, folder: Path) -> None:
    camera = result.scene.settings.camera
    origin: dict[str, str | int] = {
        "version": package_version(),
        "rules_version": RULES_VERSION,
        "scene_sha256": scene_hash(result.scene),
    }
    write_exr(folder / "buffers.exr", result.buffers, (camera.width, camera.height), origin)


def _write_pictures(result: Result, folder: Path) -> None:
    if "image" in result.buffers:
        write_png(folder / "image.png", *_preview(result), encode=encoding_of(result.scene.settings))
    write_overview(folder / "overview.png", result)


def _preview(result: Result) -> tuple[np.ndarray, np.ndarray | None]:
    """Colour and coverage of image.png; PNG wants the model's colour at its edges, without the background behind it.

    A picture whose blur reaches beyond the model has no alpha: it would hide the halo.
    """
    settings = result.scene.settings
    if settings.method == "screen_space" and settings.blur.mask == "none":
        return result.image, None
    if isinstance(result, SampledResult):
        return result.foreground, result.coverage
    return result.image, result.buffers.get("coverage")
