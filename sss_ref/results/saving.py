"""The files of a result, written by threads of their own: a buffer as soon as it is there, the others at the end."""

import os
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from sss_ref.pictures.overview import write_overview
from sss_ref.pictures.png_file import image_encoding_of, write_png
from sss_ref.rendering.result import Result, buffer_hash
from sss_ref.rendering.samples import SampledResult
from sss_ref.results.exr_file import plane_by_plane, write_exr
from sss_ref.results.manifest import FILE_NAME, manifest_of, package_version, scene_hash
from sss_ref.rules import RULES_VERSION


@dataclass(frozen=True)
class Saving:
    """A folder that is being filled.

    pool: of the threads that write. interpreter, threads: what is rendered with, for the manifest.
    """

    folder: Path
    pool: ThreadPoolExecutor
    interpreter: str | None
    threads: int | None
    taken: dict[str, Future[tuple[np.ndarray, str]]] = field(default_factory=dict)

    def take(self, name: str, buffer: np.ndarray) -> None:
        """Begin to write and hash a buffer, which nobody changes any more."""
        self.taken[name] = self.pool.submit(_written, self.folder, name, buffer)

    def finish(self, result: Result) -> Result:
        """Write all that is left, the manifest last; the result with hashes, and with all buffers that were taken.

        Raises what writing raises.
        """
        for name in result.buffers:
            if name not in self.taken:
                self.take(name, result.buffers[name])
        done = {name: self.taken[name].result() for name in result.scene.method.values if name in self.taken}
        whole = replace(
            result,
            buffers={name: buffer for name, (buffer, _) in done.items()},
            digests={name: digest for name, (_, digest) in done.items()},
        )
        tasks = [self.pool.submit(write, whole, self.folder) for write in (write_buffers_exr, _write_pictures)]
        for task in tasks:
            task.result()
        manifest = manifest_of(whole, self.interpreter, self.threads)
        (self.folder / FILE_NAME).write_text(manifest.model_dump_json(indent=2) + "\n", encoding="utf-8")
        return whole


@contextmanager
def filling(folder: Path, interpreter: str | None, threads: int | None) -> Iterator[Saving]:
    """What fills an empty folder; what has not begun yet when something goes wrong is not written."""
    (folder / "buffers").mkdir()
    pool = ThreadPoolExecutor(os.cpu_count())
    try:
        yield Saving(folder, pool, interpreter, threads)
    finally:
        pool.shutdown(cancel_futures=True)


def shows_all(result: Result) -> bool:
    """Whether `image.png` shows all that there is, so that there is no overview."""
    return list(result.buffers) == ["image"]


def _written(folder: Path, name: str, buffer: np.ndarray) -> tuple[np.ndarray, str]:
    """Write a NPY file; the buffer, put apart for `buffers.exr`, and its hash."""
    np.save(folder / "buffers" / f"{name}.npy", buffer.astype(buffer.dtype.newbyteorder("<"), copy=False))
    return plane_by_plane(buffer), buffer_hash(name, buffer)


def write_buffers_exr(result: Result, folder: Path) -> None:
    """Write the buffers of a rendering as `buffers.exr` into a folder."""
    camera = result.scene.settings.camera
    origin: dict[str, str | int] = {
        "version": package_version(),
        "rules_version": RULES_VERSION,
        "scene_sha256": scene_hash(result.scene),
    }
    write_exr(folder / "buffers.exr", result.buffers, (camera.width, camera.height), origin)


def _write_pictures(result: Result, folder: Path) -> None:
    if "image" in result.buffers:
        write_png(folder / "image.png", *preview(result), encode=image_encoding_of(result.scene.settings))
    if not shows_all(result):
        write_overview(folder / "overview.png", result)


def preview(result: Result) -> tuple[np.ndarray, np.ndarray | None]:
    """Colour and coverage of image.png; PNG wants the model's colour at its edges, without the background behind it.

    A picture whose blur reaches beyond the model has no alpha: it would hide the halo.
    """
    if result.scene.settings.glows:
        return result.image, None
    if isinstance(result, SampledResult):
        return result.foreground, result.coverage
    return result.image, result.buffers.get("coverage")
