"""The page of a scene: its mesh, uniforms, textures and shaders, with the script that draws them, in one file."""

import json
from collections.abc import Callable, Collection, Iterable, Mapping
from html import escape
from importlib.resources import files
from typing import Any

import numpy as np

from sss_ref.gl.uploads import texture_data
from sss_ref.interpret.shader import ESSL, array_lengths, draws, fragment_shader, vertex_shader
from sss_ref.language.layout import CHANNELS, dtype_of
from sss_ref.language.pipeline import Pass
from sss_ref.mesh.triangles import Mesh
from sss_ref.scene.scene import Scene
from sss_ref.webgl.packing import Packed, plain

Packing = Callable[[np.ndarray], Packed]

KINDS = {"f": "float", "i": "int", "u": "bool"}  # kind of number -> the script's name


def page(scene: Scene, keep: str | Iterable[str] = "all") -> str:
    """A page of HTML, to be opened in a browser, that draws a scene with WebGL 2.

    It reads nothing but itself and sends nothing. A buffer becomes a file NAME.npy to save, row 0 at the bottom, named
    and typed as that of a rendering. A UV layout that overlaps is drawn even where the scene's policy is "error".
    keep: which buffers to offer, as in `sss_ref.render`; only what they need is drawn.
    Raises SceneError for the name of no buffer.
    """
    return page_of(f"sss_ref: {scene.mesh.name}", drawing(scene, keep))


def page_of(title: str, content: Mapping[str, Any]) -> str:
    """A page that draws what it holds. content: as `drawing` gives it."""
    folder = files("sss_ref.webgl")
    text = json.dumps(content).replace("<", "\\u003c")
    template, *scripts = (
        (folder / name).read_text(encoding="utf-8") for name in ("page.html", "drawing.js", "draw.js")
    )
    return template.format(title=escape(title), scene=text, script="\n".join(scripts))


def drawing(scene: Scene, keep: str | Iterable[str]) -> dict[str, Any]:
    """All that the script needs, as JSON has it; arrays are little-endian bytes in base 64."""
    wanted = scene.kept(keep)
    kept = [name for name in scene.method.values if name in wanted]
    return {"passes": _passes(kept, scene), "kept": kept, **inputs(scene, plain)}


def inputs(scene: Scene, packed: Packing) -> dict[str, Any]:
    """What all passes read that none of them writes: meshes, uniforms and textures; and the names in the shaders."""
    textures = texture_data(scene.uniforms)
    return {
        "uniforms": {name: np.ravel(value).tolist() for name, value in scene.uniforms.items() if name not in textures},
        "names": {ESSL.name(name): name for name in (*scene.uniforms, *scene.method.values)},
        "textures": {name: texture(data, packed) for name, data in textures.items()},
        "meshes": {name: _mesh(mesh, packed) for name, mesh in scene.meshes.items()},
    }


def _mesh(mesh: Mesh, packed: Packing) -> dict[str, Any]:
    """The corners of its triangles, and what the vertex shaders read of a vertex."""
    attributes = {name: {"channels": data.shape[1], "data": packed(data)} for name, data in mesh.attributes.items()}
    return {"triangles": packed(mesh.triangles), "attributes": attributes}


def _passes(kept: Collection[str], scene: Scene) -> list[dict[str, Any]]:
    """The passes, each with the draws that fill what is kept of it or read later."""
    listed: list[dict[str, Any]] = []
    there: set[str] = set()
    for each, read_later in scene.method.only({*kept}).in_order():
        wanted = {*kept, *read_later, *each.fed_back}
        listed.append(pass_settings(each, scene) | {"draws": _draws(each, wanted, there, scene)})
        there |= wanted & set(each.outputs)
    return listed


def pass_settings(this_pass: Pass, scene: Scene) -> dict[str, Any]:
    """How a pass is drawn."""
    width, height = scene.size(this_pass)
    return {
        "width": width,
        "height": height,
        "mesh": this_pass.draw.mesh,
        "laterWins": this_pass.draw.layout and scene.settings.irradiance_map.overlap == "last",
        **this_pass.repetition,
    }


def _draws(this_pass: Pass, wanted: Collection[str], buffers: Collection[str], scene: Scene) -> list[dict[str, Any]]:
    """The draws of a pass: their shaders and the buffers that they fill."""
    lengths = array_lengths(scene.uniforms)
    return [
        {
            "name": draw,
            "vertex": vertex_shader(this_pass, lengths, ESSL),
            "fragment": fragment_shader(this_pass, buffers, outputs, lengths, ESSL),
            "outputs": [output(name, this_pass.values[name], scene.clear(name)) for name in outputs],
        }
        for draw, outputs in draws(this_pass, wanted, ESSL).items()
    ]


def output(name: str, kind: Any, clear: Any) -> dict[str, Any]:
    """A buffer and what it holds before the draw, in four channels."""
    background = np.resize(np.asarray(clear, dtype_of(kind)), 4).tolist()
    return {"name": name, "kind": KINDS[dtype_of(kind).kind], "channels": CHANNELS[kind], "background": background}


def texture(data: np.ndarray, packed: Packing) -> dict[str, Any]:
    """A texture (H, W) or (H, W, C)."""
    height, width, channels = (*data.shape, 1)[:3]
    kind = KINDS[data.dtype.kind]
    return {"kind": kind, "channels": channels, "width": width, "height": height, "data": packed(data)}
