"""A scene as files for another renderer: mesh, uniforms, shaders, and what each pass reads, writes and clears."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, get_args, get_origin

import numpy as np

from sss_ref.bundle.porting import guide
from sss_ref.interpret.shader import ARRAY_WIDTH, array_lengths, draws, shader_files
from sss_ref.interpret.work import CHANNELS
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.language.types import Array, Texture, vec2, vec3
from sss_ref.language.typing_rules import type_name
from sss_ref.passes.buffers import background, described
from sss_ref.results.whole_folder import appearing, writable
from sss_ref.rules import RULES_VERSION
from sss_ref.scene.catalogue import method_of_scene
from sss_ref.scene.load import Scene
from sss_ref.scene.uniforms import uniforms

FORMAT = "sss_ref bundle 1"
FORMATS = {float: "R32F", vec2: "RG32F", vec3: "RGB32F", int: "R32I", bool: "R8UI"}  # of what a shader writes


def write_bundle(scene: Scene, folder: Path) -> Path:
    """Write the bundle of a scene, which appears whole or not at all; returns the folder.

    mesh.glb to look at, and mesh/*.npy with the exact arrays; uniforms.json, with textures/*.npy; passes.json;
    shaders/*; scene.json, the scene with all its keys; PORTING.md, which explains the rest.
    Raises DumpError for a folder that cannot be written or is somebody else's.
    """
    folder = writable(folder, _is_bundle, "an earlier bundle")
    values, method = uniforms(scene), method_of_scene(scene)
    with appearing(folder) as part:
        _write_mesh(scene, part)
        _write_json(part / "uniforms.json", _uniforms(values, method, part))
        _write_json(part / "passes.json", _passes(scene, method, values))
        _write_json(part / "scene.json", scene.settings.model_dump(mode="json"))
        (part / "shaders").mkdir()
        for name, text in shader_files(method, array_lengths(values)).items():
            (part / "shaders" / name).write_text(text, encoding="utf-8")
        (part / "PORTING.md").write_text(guide(scene, method), encoding="utf-8")
    return folder


def _is_bundle(folder: Path) -> bool:
    try:
        return bool(json.loads((folder / "passes.json").read_bytes())["format"] == FORMAT)
    except (OSError, ValueError, LookupError, TypeError):
        return False


def _write_json(path: Path, content: Any) -> None:
    path.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _write_mesh(scene: Scene, folder: Path) -> None:
    """The mesh as the passes use it; the glTF file holds it too, but its v, measured from the top, is rounded."""
    import trimesh

    mesh = scene.mesh
    (folder / "mesh").mkdir()
    for name, array in mesh.attributes.items():
        np.save(folder / "mesh" / f"{name}.npy", array)
    np.save(folder / "mesh" / "triangles.npy", mesh.triangles)
    visual = trimesh.visual.TextureVisuals(uv=mesh.attributes["uv"])
    exported = trimesh.Trimesh(
        mesh.positions, mesh.triangles, vertex_normals=mesh.normals, visual=visual, process=False
    )
    exported.export(folder / "mesh.glb")


def _uniforms(values: Mapping[str, Any], method: Method, folder: Path) -> dict[str, Any]:
    """Every uniform that a shader reads: its type and value, or the file of a texture. Matrices are row by row."""
    (folder / "textures").mkdir()
    short, found = array_lengths(values), {}
    for name, kind in sorted(_reads(method).items()):
        value = values[name]
        if get_origin(kind) is Texture or (get_origin(kind) is Array and name not in short):
            np.save(folder / "textures" / f"{name}.npy", value)
            texel = type_name(get_args(kind)[0])
            found[name] = {"type": f"texture of {texel}", "file": f"textures/{name}.npy"}
        else:
            found[name] = {"type": type_name(kind), "value": _plain(value)}
    return found


def _reads(method: Method) -> dict[str, Any]:
    """Name -> type of the uniforms of all passes."""
    buffers = {name for one in method.passes for name in one.outputs}
    read = {name: kind for one in method.passes for name, kind in {**one.reads, **one.draw.reads}.items()}
    return {name: kind for name, kind in read.items() if name not in buffers}


def _plain(value: Any) -> Any:
    """Numbers and lists of them; a float has the fewest digits that give back its float32."""
    if np.ndim(value):
        return [_plain(each) for each in value]
    return int(value) if isinstance(value, int | np.integer) else float(str(np.float32(value)))


def _passes(scene: Scene, method: Method, values: Mapping[str, Any]) -> dict[str, Any]:
    """What passes.json says."""
    passes: list[dict[str, Any]] = []
    there: set[str] = set()
    for one in method.passes:
        passes.append(_pass(scene, one, values, there))
        there |= set(one.outputs)
    about = {"format": FORMAT, "rules_version": RULES_VERSION, "method": method.name, "array_width": ARRAY_WIDTH}
    return {**about, "passes": passes}


def _pass(scene: Scene, one: Pass, values: Mapping[str, Any], there: set[str]) -> dict[str, Any]:
    table = getattr(scene.settings, one.target)
    later_wins = scene.settings.irradiance_map.overlap == "last"
    draw: dict[str, Any] = (
        {"kind": "rectangle", "discards_where_0": one.draw.stencil}
        if isinstance(one.draw, ScreenDraw)
        else {
            "kind": "mesh",
            "depth_test": "less or equal" if one.draw.layout and later_wins else "less",
            "cull": "none",
        }
    )
    return {
        "name": one.name,
        "only_on_demand": one.on_demand,
        "width": table.width,
        "height": table.height,
        "draw": draw,
        "reads": sorted({*one.reads, *one.draw.reads} & there),
        "rounds": one.rounds,
        "feedback": dict(one.feedback),
        "vertex_shader": f"shaders/{one.name}.vert",
        "draws": [
            {
                "fragment_shader": f"shaders/{name}.frag",
                "targets": [_target(buffer, one.outputs[buffer], values) for buffer in outputs],
            }
            for name, outputs in draws(one, one.outputs).items()
        ],
    }


def _target(name: str, kind: Any, values: Mapping[str, Any]) -> dict[str, Any]:
    """A buffer that a shader writes: its texture's format, what it is cleared to, and what it holds."""
    return {
        "buffer": name,
        "format": FORMATS[kind],
        "filter": "nearest",
        "clear": _plain(np.broadcast_to(background(name, values), CHANNELS[kind])),
        "unit": described(name).unit,
    }
