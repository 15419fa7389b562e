"""The result folder: pictures, buffers and manifest, all there or not there at all."""

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from sss_ref.errors import DumpError
from sss_ref.io.exr import write_exr
from sss_ref.io.manifest import FILE_NAME, FORMAT, Manifest, manifest_of, scene_hash
from sss_ref.io.overview import write_overview
from sss_ref.io.png import encoding_of, write_png
from sss_ref.result import Result
from sss_ref.samples import SampledResult


def save(result: Result, folder: Path, interpreter: str | None = None, threads: int | None = None) -> Path:
    """Write a rendering into `folder`, replacing an earlier result there; returns the absolute path.

    interpreter, threads: what it was rendered with, for the manifest. Writes `image.png` (if the image was kept),
    `overview.png`, `buffers.exr`, `buffers/NAME.npy` and `manifest.json`.
    Raises DumpError where the folder is not ours to replace or cannot be written; it is then left as it was.
    """
    folder = checked_target(folder)
    with _appearing(folder) as part:
        _write(result, manifest_of(result, interpreter, threads), part)
    return folder


def checked_target(folder: Path) -> Path:
    """The absolute path of a folder that a result can be written to. Raises DumpError where it cannot."""
    folder = folder.resolve()
    if folder.exists() and not _replaceable(folder):
        raise DumpError(
            f"{folder}: expected a new folder, an empty one or an earlier result, got other files; move them"
        )
    parent = next(parent for parent in folder.parents if parent.exists())
    if not (parent.is_dir() and os.access(parent, os.W_OK)):
        raise DumpError(f"{folder}: expected a place to write to, got {parent}; choose another folder")
    return folder


def read_buffer(path: Path) -> np.ndarray:
    """A buffer from its NPY file, row 0 at the bottom. Raises DumpError where it cannot be read."""
    try:
        return np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError) as error:
        raise DumpError(f"{path}: expected a buffer in NPY format, got {error}; render the scene again") from None


def _replaceable(folder: Path) -> bool:
    """Whether nothing of anybody else's is lost with `folder`: it is empty, or an earlier result."""
    return folder.is_dir() and (not any(folder.iterdir()) or _is_result(folder))


def _is_result(folder: Path) -> bool:
    """Whether a folder has a manifest of this package, of whatever version."""
    try:
        return json.loads((folder / FILE_NAME).read_bytes())["format"] == FORMAT
    except (OSError, ValueError, LookupError, TypeError):
        return False


@contextmanager
def _appearing(folder: Path) -> Iterator[Path]:
    """A hidden folder beside `folder` to write into; it takes its place at the end, or vanishes if writing fails."""
    part = folder.with_name(f".{folder.name}.{os.getpid()}.part")
    try:
        part.mkdir(parents=True)
        yield part
        _put(part, folder)
    except (OSError, RuntimeError) as error:  # OpenEXR raises the latter
        reason = getattr(error, "strerror", None) or error
        raise DumpError(f"{folder}: cannot be written ({reason}); choose another folder") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _put(part: Path, folder: Path) -> None:
    """Rename `part` to `folder`, whose own content, if any, is moved aside first and deleted last."""
    if not folder.exists():
        part.rename(folder)
        return
    old = part.with_suffix(".old")
    folder.rename(old)
    try:
        part.rename(folder)
    except OSError:
        old.rename(folder)
        raise
    shutil.rmtree(old, ignore_errors=True)


def _write(result: Result, manifest: Manifest, folder: Path) -> None:
    (folder / "buffers").mkdir()
    for name, buffer in result.buffers.items():
        np.save(folder / "buffers" / f"{name}.npy", buffer.astype(buffer.dtype.newbyteorder("<"), copy=False))
    camera = result.scene.settings.camera
    origin: dict[str, str | int] = {
        "version": manifest.package_version,
        "rules_version": manifest.rules_version,
        "scene_sha256": scene_hash(result.scene),
    }
    write_exr(folder / "buffers.exr", result.buffers, (camera.width, camera.height), origin)
    if "image" in result.buffers:
        write_png(folder / "image.png", *_preview(result), encode=encoding_of(result.scene.settings))
    write_overview(folder / "overview.png", result)
    (folder / FILE_NAME).write_text(manifest.model_dump_json(indent=2) + "\n", encoding="utf-8")


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
