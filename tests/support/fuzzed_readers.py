"""What is read from each kind of file, as comparable facts: the readers that changed files are handed to."""

import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import is_dataclass
from pathlib import Path

import numpy as np
from pydantic import BaseModel
from saved_scene import SCENE, TETRAHEDRON


def facts(name, thing):
    """Name, content and whether it is finite of every number and array in a thing, however deep."""
    if isinstance(thing, np.ndarray):
        finite = thing.dtype.kind not in "fc" or bool(np.isfinite(thing).all())
        yield name, (thing.dtype.str, thing.shape, thing.tobytes()), finite
    elif isinstance(thing, BaseModel):
        yield from facts(name, dict(thing))
    elif is_dataclass(thing):
        yield from facts(name, {key: getattr(thing, key) for key in thing.__dataclass_fields__})
    elif isinstance(thing, Mapping):
        for key in sorted(thing, key=str):
            yield from facts(f"{name}.{key}", thing[key])
    elif isinstance(thing, list | tuple):
        for key, each in enumerate(thing):
            yield from facts(f"{name}.{key}", each)
    else:
        yield name, repr(thing), not isinstance(thing, float) or abs(thing) < float("inf")


def of_scene(path):
    """Everything that the passes would read."""
    from sss_ref.scene.load import load_scene

    scene = load_scene(path)
    settings = scene.settings.model_dump()
    paths = {key: settings["mesh"].pop(key) for key in ("path", "texture", "normal_map", "specular_map")}
    assert paths["path"]
    return list(facts("scene", {"settings": settings, "mesh": of_arrays(scene.mesh), "uniforms": scene.uniforms}))


def of_arrays(mesh):
    """What of a mesh reaches a buffer, and its materials."""
    return {**mesh.attributes, "triangles": mesh.triangles, "material": mesh.material, "materials": mesh.materials}


def of_mesh(path):
    """Its arrays; numbers of vertices that are there."""
    from sss_ref.mesh.mesh_file import load_mesh

    mesh = load_mesh(path)
    assert mesh.triangles.min() >= 0 and mesh.triangles.max() < len(mesh.positions)
    return list(facts("mesh", of_arrays(mesh)))


def of_dump(path):
    """The buffers of a folder; NaN in them is the shader's, and counted."""
    return _buffers(path.parent)


def of_mapping(path):
    """The buffers that a mapping file names."""
    return _buffers(path)


def _buffers(path):
    from sss_ref.dump.read import read_dump

    buffers = read_dump(path, dumped_scene()).buffers
    found = [(name, buffer.data.tobytes(), buffer.encoding, len(buffer.notes)) for name, buffer in buffers.items()]
    assert all(bool(buffer.not_finite) == any("NaN" in note for note in buffer.notes) for buffer in buffers.values())
    return [("dump", found, True)]


def dumped_scene(made=[]):  # noqa: B006
    """The scene that dumps are of."""
    from sss_ref.scene.load import load_scene

    if not made:
        folder = Path(tempfile.mkdtemp())
        (folder / "tetrahedron.obj").write_text(TETRAHEDRON)
        (folder / "a.toml").write_text(SCENE)
        made.append(load_scene(folder / "a.toml"))
        shutil.rmtree(folder)
    return made[0]


def of_profile(path):
    """A processor's bounds: infinity is one."""
    from sss_ref.validation.profile_file import profile_of

    return [(name, content, content != "nan") for name, content, _ in facts("profile", profile_of(path))]


def of_manifest(path):
    """What a manifest says."""
    from sss_ref.results.manifest import read_manifest

    return list(facts("manifest", read_manifest(path.parent)))


def of_sweep(path):
    """A sweep as far as its file says it."""
    from sss_ref.batch.sweep_file import read_sweep

    return list(facts("sweep", read_sweep(path).model_dump(exclude={"scene"})))


def of_bundle(path):
    """The scene in a folder that is a bundle."""
    return of_scene(path.parent)


SCENE_KINDS = {
    "scene": of_scene,
    "mesh": of_mesh,
    "dump": of_dump,
    "mapping": of_mapping,
    "profile": of_profile,
    "manifest": of_manifest,
    "sweep": of_sweep,
    "bundle": of_bundle,
}
