"""Rendering a recorded scene again and comparing every bit."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from sss_ref.errors import DumpError
from sss_ref.rendering.fold import render
from sss_ref.rendering.result import Result, buffer_hash
from sss_ref.rendering.samples import render_samples
from sss_ref.results.diff import first_difference
from sss_ref.results.folder import read_buffer
from sss_ref.results.manifest import BufferRecord, Manifest, read_manifest
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.load import load_scene
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.shipped import find_mesh


@dataclass(frozen=True)
class Verification:
    """What came of it: whether all is equal, and what to tell the user."""

    equal: bool
    message: str


def verify(
    folder: Path,
    interpreter: str = "kernel",
    threads: int | None = None,
    on_pass: Callable[[str], None] | None = None,
) -> Verification:
    """Whether the scene recorded in a result folder still gives the recorded buffers.

    Where something differs the message says what: the rules, a file of the folder, the mesh, or else the computation,
    with the first differing buffer, pixel and both values. interpreter, threads, on_pass: as in `render`.
    Raises DumpError for a folder that is not a whole result, SceneError and MeshError as `load_scene` does.
    """
    manifest = read_manifest(folder)
    if manifest.rules_version != RULES_VERSION:
        return Verification(False, f"made under other rules ({manifest.rules_version} -> {RULES_VERSION})")
    if manifest.own_stages:
        names = ", ".join(manifest.own_stages)
        raise DumpError(f"{folder}: expected our stages, got others for {names}; render with them again and use diff")
    changed = [record.file for record in manifest.buffers if _is_changed(record, folder)]
    if changed:
        return Verification(False, f"the file {changed[0]} was changed since ({_counted(len(changed), 'such file')})")
    scene = _recorded_scene(manifest, folder)
    found = scene.input_hashes()
    other = [name for name in manifest.inputs | found if manifest.inputs.get(name) != found.get(name)]
    if other:
        return Verification(False, f"input differs: {', '.join(other)} of the mesh {scene.settings.mesh.path}")
    result = _rendered_again(scene, manifest, interpreter, threads, on_pass)
    for record in manifest.buffers:
        computed = result[record.name]
        if result.hashes[record.name] != record.sha256:
            difference = first_difference(read_buffer(folder / record.file), computed)
            return Verification(False, f"computation differs: buffer {record.name}, {difference}")
    return Verification(True, f"verified: {_counted(len(manifest.buffers), 'buffer')} equal in every bit")


def _is_changed(record: BufferRecord, folder: Path) -> bool:
    """Whether a file no longer holds what the manifest says."""
    stored = read_buffer(folder / record.file)
    is_alike = stored.dtype.str == record.dtype and list(stored.shape) == record.shape
    return not is_alike or buffer_hash(record.name, stored) != record.sha256


def _recorded_scene(manifest: Manifest, folder: Path) -> Scene:
    """The scene of a manifest; its files from where they were, else from beside the result, else the shipped mesh."""
    recorded = manifest.scene
    beside = folder.resolve().parent
    named = {"mesh.path": recorded.settings.get("mesh", {}).get("path", "")}
    named |= {f"layers.{k}.path": layer.get("path", "") for k, layer in enumerate(recorded.settings.get("layers", ()))}
    were = {**recorded.other_files, "mesh.path": recorded.mesh_file}
    files = {key: _mesh_again(were.get(key, path), path, beside) for key, path in named.items()}
    texture = {} if recorded.texture_file is None else {"mesh.texture": recorded.texture_file}
    for key, was in {**recorded.other_files, **texture}.items():
        if key in files:
            continue
        places = (Path(was), beside / Path(was).name)
        files[key] = next((str(path) for path in places if path.is_file()), was)
    return load_scene(recorded.settings, **files)


def _mesh_again(was: str, named: str, beside: Path) -> str:
    """Where a mesh is: where it was, else as the scene names it, beside the result or shipped; else where it was."""
    found = (find_mesh(path, beside) for path in (was, named, Path(was).name))
    return next((str(path) for path in found if path), was)


def _rendered_again(
    scene: Scene,
    manifest: Manifest,
    interpreter: str,
    threads: int | None,
    on_pass: Callable[[str], None] | None,
) -> Result:
    """The recorded buffers, or the average of as many samples as were recorded."""
    if manifest.samples != 1:
        return render_samples(scene, manifest.samples, interpreter, threads, on_pass)
    return render(scene, interpreter, threads, [record.name for record in manifest.buffers], on_pass)


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"
