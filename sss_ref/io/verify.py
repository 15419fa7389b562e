"""Rendering a recorded scene again and comparing every bit."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sss_ref.io.folder import read_buffer
from sss_ref.io.manifest import BufferRecord, Manifest, read_manifest
from sss_ref.rendering import render
from sss_ref.result import buffer_hash
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.load import Scene, load_scene
from sss_ref.scene.shipped import find_mesh


@dataclass(frozen=True)
class Verdict:
    """What came of it: whether all is equal, and what to tell the user."""

    equal: bool
    message: str


def verify(
    folder: Path,
    interpreter: str = "kernel",
    threads: int | None = None,
    on_pass: Callable[[str], None] | None = None,
) -> Verdict:
    """Whether the scene recorded in a result folder still gives the recorded buffers.

    interpreter, threads, on_pass: as in `render`. Where something differs the message says what: the rules, a file of
    the folder, the mesh, or else the computation, with the first differing buffer, pixel and both values.
    Raises DumpError for a folder that is not a whole result, SceneError and MeshError as `load_scene` does.
    """
    manifest = read_manifest(folder)
    if manifest.rules_version != RULES_VERSION:
        return Verdict(False, f"made under other rules ({manifest.rules_version} -> {RULES_VERSION})")
    changed = [record.file for record in manifest.buffers if _is_changed(record, folder)]
    if changed:
        return Verdict(False, f"the file {changed[0]} was changed since ({_counted(len(changed), 'such file')})")
    scene = _recorded_scene(manifest, folder)
    found = scene.mesh.hashes()
    other = [name for name in manifest.inputs | found if manifest.inputs.get(name) != found.get(name)]
    if other:
        return Verdict(False, f"input differs: {', '.join(other)} of the mesh {scene.settings.mesh.path}")
    result = render(scene, interpreter, threads, [record.name for record in manifest.buffers], on_pass)
    for record in manifest.buffers:
        if result.hashes[record.name] != record.sha256:
            difference = first_difference(read_buffer(folder / record.file), result.buffers[record.name])
            return Verdict(False, f"computation differs: buffer {record.name}, {difference}")
    return Verdict(True, f"verified: {_counted(len(manifest.buffers), 'buffer')} equal in every bit")


def first_difference(recorded: np.ndarray, computed: np.ndarray) -> str:
    """Where two buffers of one type and size first differ, row by row from the bottom, with values and bit patterns."""
    if recorded.shape != computed.shape:
        return f"its shape: recorded {recorded.shape}, now {computed.shape}"
    differs = (bits(recorded) != bits(computed)).reshape(*recorded.shape[:2], -1).any(axis=-1)
    row, column = np.argwhere(differs)[0]
    return (
        f"first at pixel {column},{row} (column,row; row 0 at the bottom): "
        f"recorded {_shown(recorded[row, column])}, now {_shown(computed[row, column])}; "
        f"{np.count_nonzero(differs)} of {differs.size} pixels differ"
    )


def bits(values: np.ndarray) -> np.ndarray:
    """The bit patterns of values, as unsigned integers of the same size: -0 is not 0 here."""
    return np.ascontiguousarray(values).view(f"u{values.dtype.itemsize}")


def _shown(pixel: np.ndarray) -> str:
    """The channels of a pixel, each with its bit pattern."""
    channels = np.atleast_1d(pixel)
    digits = 2 * channels.dtype.itemsize
    return " ".join(
        f"{value!s} (0x{pattern:0{digits}x})" for value, pattern in zip(channels, bits(channels), strict=True)
    )


def _is_changed(record: BufferRecord, folder: Path) -> bool:
    """Whether a file no longer holds what the manifest says."""
    stored = read_buffer(folder / record.file)
    is_alike = stored.dtype.str == record.dtype and list(stored.shape) == record.shape
    return not is_alike or buffer_hash(record.name, stored) != record.sha256


def _recorded_scene(manifest: Manifest, folder: Path) -> Scene:
    """The scene of a manifest; its mesh from where it was, else from beside the result, else the shipped one."""
    recorded = manifest.scene
    named = recorded.settings.get("mesh", {}).get("path", "")
    beside = folder.resolve().parent
    candidates = (find_mesh(path, beside) for path in (recorded.mesh_file, named, Path(recorded.mesh_file).name))
    mesh = next((path for path in candidates if path), recorded.mesh_file)
    return load_scene(recorded.settings, **{"mesh.path": str(mesh)})


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"
