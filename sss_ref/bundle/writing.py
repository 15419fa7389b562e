"""A scene as files for another renderer: mesh, uniforms, shaders, and what each pass reads, writes and clears."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.bundle.languages import LANGUAGES
from sss_ref.bundle.pass_list import FORMAT, pass_list, plain
from sss_ref.bundle.porting import guide
from sss_ref.dump.mapping_template import mapping_template
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of
from sss_ref.interpret.shader import Dialect, array_lengths, shader_files
from sss_ref.language.pipeline import Method
from sss_ref.language.types import Array, Texture
from sss_ref.language.typing_rules import type_name
from sss_ref.mesh.array_folder import write_arrays
from sss_ref.mesh.triangles import Mesh
from sss_ref.results.whole_folder import appearing, writable
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.bundled import FILE_NAME, PICTURE, bundle_record
from sss_ref.scene_file.color_texture import srgb_decoded


def write_bundle(scene: Scene, folder: Path, dialect: str = "glsl") -> Path:
    """Write the bundle of a scene, which appears whole or not at all; returns the folder.

    mesh.glb to look at, and mesh/*.npy with the exact arrays; of a layer inner_mesh.glb and inner_mesh/*.npy;
    uniforms.json, with textures/*.npy; passes.json; shaders/*; scene.json, the scene with all its keys, which makes the
    folder a scene to `load_scene`; mapping.toml, a mapping file to edit; PORTING.md, which explains the rest.
    dialect: the language of the shaders, one of LANGUAGES, and with it the words of passes.json and PORTING.md.
    Raises DumpError for a folder that cannot be written or is somebody else's.
    """
    folder = writable(folder, _is_bundle, "an earlier bundle")
    language, method = LANGUAGES[dialect], scene.method
    with appearing(folder) as part:
        for name, mesh in scene.meshes.items():
            _write_mesh(mesh, name, part)
        _write_json(part / "uniforms.json", _uniforms(scene.uniforms, method, language.dialect, part))
        _write_json(part / "passes.json", pass_list(scene, language))
        record = bundle_record(scene.settings, scene.source, scene.own_stages)
        _write_json(part / FILE_NAME, record.model_dump(mode="json"))
        (part / "shaders").mkdir()
        for name, text in shader_files(
            method, array_lengths(scene.uniforms, language.dialect), language.dialect
        ).items():
            (part / "shaders" / name).write_text(text, encoding="utf-8")
        (part / "mapping.toml").write_text(mapping_template(scene), encoding="utf-8")
        (part / "PORTING.md").write_text(guide(scene, language), encoding="utf-8")
    return folder


def _is_bundle(folder: Path) -> bool:
    try:
        content = json.loads(text_of(folder / "passes.json", "a bundle's passes", DumpError))
        return bool(content["format"] == FORMAT)
    except (DumpError, ValueError, LookupError, TypeError, RecursionError):
        return False


def _write_json(path: Path, content: Any) -> None:
    path.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _write_mesh(mesh: Mesh, name: str, folder: Path) -> None:
    """A mesh as the passes use it; the glTF file holds it too, but its v, measured from the top, is rounded."""
    import trimesh

    (folder / name).mkdir()
    write_arrays(mesh, folder / name)
    visual = trimesh.visual.TextureVisuals(uv=mesh.attributes["uv"])
    exported = trimesh.Trimesh(
        mesh.positions, mesh.triangles, vertex_normals=mesh.normals, visual=visual, process=False
    )
    exported.export(folder / f"{name}.glb")


def _uniforms(values: Mapping[str, Any], method: Method, dialect: Dialect, folder: Path) -> dict[str, Any]:
    """Every uniform that a shader reads: its type and value, or the file of a texture. Matrices are row by row."""
    (folder / "textures").mkdir()
    _write_picture(values.get("albedo_map"), folder / PICTURE)
    short, found = array_lengths(values, dialect), {}
    for name, kind in sorted(_reads(method).items()):
        value = values[name]
        if get_origin(kind) is Texture or (get_origin(kind) is Array and name not in short):
            np.save(folder / "textures" / f"{name}.npy", value)
            texel = type_name(get_args(kind)[0])
            found[dialect.name(name)] = {"type": f"texture of {texel}", "file": f"textures/{name}.npy"}
        else:
            found[dialect.name(name)] = {"type": type_name(kind), "value": plain(value)}
    return found


def _write_picture(texels: np.ndarray | None, path: Path) -> None:
    """The codes that a picture's texels (H, W, 3) were decoded from: reading it again gives the same bits."""
    from PIL import Image

    if texels is not None:
        Image.fromarray(np.searchsorted(srgb_decoded(), texels[::-1]).astype(np.uint8)).save(path)


def _reads(method: Method) -> dict[str, Any]:
    """Name -> type of the uniforms of all passes."""
    buffers = {name for each in method.passes for name in each.outputs}
    read = {name: kind for each in method.passes for name, kind in {**each.reads, **each.draw.reads}.items()}
    return {name: kind for name, kind in read.items() if name not in buffers}
