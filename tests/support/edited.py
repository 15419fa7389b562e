"""Small scenes, and drawing them with shaders that say something else in places."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from scenes import around, two_slabs, written

from sss_ref.gl import draw
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.shader import GLSL, array_lengths, shader_files
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

SIZE = 96
SMALL = {
    f"{table}.{side}": SIZE for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
}
KEPT = ("all", "registers")
# How the shaders read a texel that may lie beside the texture, and another way to do it.
CLAMPED = "texelFetch(texture_, ivec2(clamp_(at.x, 0, last.x), clamp_(at.y, 0, last.y)), 0).xyz"
ON_MAP = "at.x >= 0 && at.y >= 0 && at.x <= last.x && at.y <= last.y"
BORDERED = f"{ON_MAP} ? texelFetch(texture_, at, 0).xyz : vec3(0.0, 0.0, 0.0)"
HARD = {"shadow_map.test": "slope"}  # preset robust has soft shadows
PIXELS, MM = HARD | {"blur.unit": "pixel"}, HARD | {"blur.unit": "mm"}
SHIPPED = {  # name -> a scene of the package, and what is different in it
    "bust": ("figure3_with", PIXELS),
    "bust in mm": ("figure3_with", MM),
    "filtered bust": ("figure3_with", PIXELS | {"shadow_map.filter": "bilinear"}),
    "bust cut open": ("figure3_with", HARD | {"camera.near": 4.0}),  # back faces are seen
    "turned": ("teaching", HARD),  # its model matrix is a rotation
    "wax": ("figure4_wax", {}),
    "wax from near": ("figure4_wax", {"camera.distance": 2.0}),  # the model reaches the frame
    "texture space": ("figure5", PIXELS),
    "texture space in mm": ("figure5", MM),
    "soft shadows": ("figure3_with", {}),
    "tooth": ("teeth_layers", {}),
    "parallel": ("molar_orthographic", HARD),
    "parallel on the surface": ("sphere_directional", HARD | {"method": "texture_space"}),
    "texture space as published": ("figure5", {"preset": "published"}),
}


@dataclass(frozen=True)
class Fault:
    """A scene that shows it, the pass/stage that is then wrong, and the shaders' texts as `drawn_edited` takes them."""

    scene: str
    at: str
    edits: dict[str, str]
    files: str = ""


def blamed(verdict):
    """The places that may be wrong; a vertex stage may always be, since nothing shows what it gives."""
    return [place for place in verdict.suspects if not place.endswith("_vertex")]


def judged(fault, folder):
    """What is said of a drawing with a fault."""
    drawing = drawn_edited(fault.scene, fault.edits, folder, fault.files)
    return validate(rendered(fault.scene), drawing, explain=False)


@cache
def rendered(name):
    """The oracle's rendering of a small scene: "slabs", or a name of SHIPPED."""
    return render(slabs() if name == "slabs" else shipped(name), interpreter="arrays")


@cache
def drawn(name):
    """The same scene drawn with our own shaders."""
    return draw(rendered(name).scene, keep=KEPT)


def shipped(name):
    scene, changes = SHIPPED[name]
    return load_scene(scene, **SMALL, **changes)


def slabs():
    """Two plates, one shading the other, in coloured light, with a shadow map read bilinearly."""
    with TemporaryDirectory() as folder:
        path = written(Path(folder) / "slabs.obj", *two_slabs(), flat=True)
        lights = [{"position": [2.0, 1.5, 2.5], "color": [1.0, 0.5, 0.25]}]
        shadow_map = {"width": SIZE, "height": SIZE, "filter": "bilinear"}
        view = {"type": "orbit", "distance": 4.5, "azimuth": 100, "elevation": 12, "fov_y": 40}
        camera = {**view, "width": SIZE, "height": SIZE}
        mesh = {"path": path, "scale": 1.1}
        return load_scene(around(path, SIZE, lights=lights, shadow_map=shadow_map, camera=camera, mesh=mesh))


def drawn_edited(name, edits, folder, files="", dialect=GLSL, draw=draw):
    """Draw a scene with shaders in which texts are replaced.

    edits: old text -> new text. files: how the names of the files begin that are edited; all unless given. dialect: of
    the shaders, and draw: what draws with them.
    """
    scene = rendered(name).scene
    found = set()
    files_of_scene = shader_files(scene.method, array_lengths(scene.uniforms, dialect), dialect, registers=True)
    for path, text in files_of_scene.items():
        if path.startswith("taps"):  # drawn on demand only
            continue
        for old in (old for old in edits if old in text and path.startswith(files)):
            text = text.replace(old, edits[old])
            found.add(old)
        (folder / path).write_text(text)
    assert found == set(edits), f"the shaders no longer say {set(edits) - found}"
    return draw(scene, shader_folder(folder, scene.settings), KEPT)
