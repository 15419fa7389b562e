"""A scene as files for another renderer: mesh, uniforms, shaders, and what each pass reads, writes and clears."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.bundle.porting import guide
from sss_ref.dump.mapping_template import mapping_template
from sss_ref.errors import DumpError
from sss_ref.errors.text_file import text_of
from sss_ref.interpret.shader import ARRAY_WIDTH, GLSL, array_lengths, draws, shader_files
from sss_ref.language.layout import CHANNELS
from sss_ref.language.pipeline import Method, Pass
from sss_ref.language.types import Array, Texture, vec2, vec3
from sss_ref.language.typing_rules import type_name
from sss_ref.mesh.array_folder import write_arrays
from sss_ref.mesh.triangles import Mesh
from sss_ref.passes.buffers import described
from sss_ref.results.whole_folder import appearing, writable
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.bundled import FILE_NAME, PICTURE, bundle_record
from sss_ref.scene_file.color_texture import srgb_decoded

FORMAT = "sss_ref bundle 1"
FORMATS = {float: "R32F", vec2: "RG32F", vec3: "RGB32F", int: "R32I", bool: "R8UI"}  # of what a shader writes


def write_bundle(scene: Scene, folder: Path) -> Path:
    """Write the bundle of a scene, which appears whole or not at all; returns the folder.

    mesh.glb to look at, and mesh/*.npy with the exact arrays; of a layer inner_mesh.glb and inner_mesh/*.npy;
    uniforms.json, with textures/*.npy; passes.json; shaders/*; scene.json, the scene with all its keys, which makes the
    folder a scene to `load_scene`; mapping.toml, a mapping file to edit; PORTING.md, which explains the rest.
    Raises DumpError for a folder that cannot be written or is somebody else's.
    """
    folder = writable(folder, _is_bundle, "an earlier bundle")
    values, method = scene.uniforms, scene.method
    with appearing(folder) as part:
        for name, mesh in scene.meshes.items():
            _write_mesh(mesh, name, part)
        _write_json(part / "uniforms.json", _uniforms(values, method, part))
        _write_json(part / "passes.json", _passes(scene))
        record = bundle_record(scene.settings, scene.source, scene.own_stages)
        _write_json(part / FILE_NAME, record.model_dump(mode="json"))
        (part / "shaders").mkdir()
        for name, text in shader_files(method, array_lengths(values)).items():
            (part / "shaders" / name).write_text(text, encoding="utf-8")
        (part / "mapping.toml").write_text(mapping_template(scene), encoding="utf-8")
        (part / "PORTING.md").write_text(guide(scene), encoding="utf-8")
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


def _uniforms(values: Mapping[str, Any], method: Method, folder: Path) -> dict[str, Any]:
    """Every uniform that a shader reads: its type and value, or the file of a texture. Matrices are row by row."""
    (folder / "textures").mkdir()
    _write_picture(values.get("albedo_map"), folder / PICTURE)
    short, found = array_lengths(values), {}
    for name, kind in sorted(_reads(method).items()):
        value = values[name]
        if get_origin(kind) is Texture or (get_origin(kind) is Array and name not in short):
            np.save(folder / "textures" / f"{name}.npy", value)
            texel = type_name(get_args(kind)[0])
            found[GLSL.name(name)] = {"type": f"texture of {texel}", "file": f"textures/{name}.npy"}
        else:
            found[GLSL.name(name)] = {"type": type_name(kind), "value": _plain(value)}
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


def _plain(value: Any) -> Any:
    """Numbers and lists of them; a float has the fewest digits that give back its float32."""
    if np.ndim(value):
        return [_plain(each) for each in value]
    return int(value) if isinstance(value, int | np.integer) else float(str(np.float32(value)))


def _passes(scene: Scene) -> dict[str, Any]:
    """What passes.json says."""
    passes: list[dict[str, Any]] = []
    there: set[str] = set()
    for each in scene.method.passes:
        passes.append(_pass(scene, each, there))
        there |= set(each.outputs)
    name = scene.method.name
    about = {"format": FORMAT, "rules_version": RULES_VERSION, "method": name, "array_width": ARRAY_WIDTH}
    return {**about, "passes": passes}


def _pass(scene: Scene, this_pass: Pass, there: set[str]) -> dict[str, Any]:
    width, height = scene.size(this_pass)
    return {
        "name": this_pass.name,
        "only_on_demand": this_pass.on_demand,
        "width": width,
        "height": height,
        "draw": _draw(scene, this_pass),
        "reads": sorted(this_pass.needs & there),
        **this_pass.repetition,
        "vertex_shader": f"shaders/{this_pass.name}.vert",
        "draws": [
            {
                "fragment_shader": f"shaders/{name}.frag",
                "targets": [_target(scene, buffer, this_pass.outputs[buffer]) for buffer in outputs],
            }
            for name, outputs in draws(this_pass, this_pass.outputs).items()
        ],
    }


def _draw(scene: Scene, this_pass: Pass) -> dict[str, Any]:
    """What is drawn, and with which tests."""
    if not this_pass.draw.vertex_stages:
        return {"kind": "rectangle", "discards_where_0": this_pass.draw.stencil}
    later_wins = this_pass.draw.layout and scene.settings.irradiance_map.overlap == "last"
    drawn = this_pass.draw.mesh
    return {"kind": "mesh", "mesh": drawn, "depth_test": "less or equal" if later_wins else "less", "cull": "none"}


def _target(scene: Scene, name: str, kind: Any) -> dict[str, Any]:
    """A buffer that a shader writes: its texture's format, what it is cleared to, and what it holds."""
    return {
        "buffer": name,
        "format": FORMATS[kind],
        "filter": "nearest",
        "clear": _plain(np.broadcast_to(scene.clear(name), CHANNELS[kind])),
        "unit": described(name).unit,
    }
