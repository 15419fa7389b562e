"""What must change nothing changes nothing in ours; planted mistakes are told by the change that shows them."""

import re

import pytest
from opengl import needs_mesa

from sss_ref.cli import main
from sss_ref.errors import SceneError
from sss_ref.gl.shader_artist import ShaderArtist
from sss_ref.gl.shaders import shader_folder
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.language import float32, ivec2, select, stage, vec3
from sss_ref.neutral.relations import RELATIONS
from sss_ref.neutral.trial import neutral
from sss_ref.passes.composite import Image
from sss_ref.scene.load import load_scene
from sss_ref.scene.own_stage import with_stage

SIDE = 24
SMALL = {
    f"{table}.{side}": SIDE for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
}
ONE_LIGHT = {"preset": "robust", "shadow_map.test": "slope"}
LIGHTS = [{"position": [2.0, 1.5, 2.6]}, {"position": [-2.0, 1.0, 2.6], "color": [0.5, 0.7, 1.0], "intensity": 1.3}]
TWO_LIGHTS = {**ONE_LIGHT, "lights": LIGHTS}
SCENES = [
    ("sphere", ONE_LIGHT),
    ("sphere", {**TWO_LIGHTS, "translucency.form": "gaussians"}),
    ("figure3_with", {"preset": "paper"}),
    ("figure5", TWO_LIGHTS),
    ("figure4_wax", {}),
]


def small(name, keys):
    return load_scene(name, **SMALL, **keys)


def broken(trials):
    return [str(each) for each in trials if each.broken]


@pytest.mark.parametrize(("name", "keys"), SCENES)
def test_ours_is_neutral(name, keys):
    trials = list(neutral(small(name, keys)))
    assert broken(trials) == []
    assert [each.name for each in trials] == list(RELATIONS)
    assert sum(each.compared > 0 for each in trials) >= 5


@needs_mesa
@pytest.mark.parametrize(("name", "keys"), SCENES[:3])
def test_ours_is_neutral_on_opengl(name, keys):
    assert broken(neutral(small(name, keys), ShaderArtist({}))) == []


def test_what_is_not_tried_says_why():
    told = {each.name: each.not_tried for each in neutral(small("figure4_wax", {})) if each.not_tried}
    assert told["lights swapped"] == "the scene has not two lights but 1"
    assert told["twice as large"] == "preset published keeps lengths from 0 to 1"
    with pytest.raises(SceneError, match=r"neutral: expected one of drawn again, .*, got mirrored; "):
        list(neutral(small("sphere", ONE_LIGHT), only=["mirrored"]))


@stage(source="a test")
def vignetted(scattered: vec3, coverage: bool, background: vec3, pixel: ivec2) -> Image:
    """Darker in the columns to the left."""
    return Image(select(coverage, scattered * (float32(pixel.x) / 64.0), background))


def test_a_stage_of_ones_own_that_looks_at_the_pixel_is_told_with_buffer_and_pixel():
    scene = with_stage(small("sphere", ONE_LIGHT), "over_background", vignetted)
    trials = {each.name: each for each in neutral(scene)}
    assert re.match(r"broken: a moved picture: image, first at pixel \d+,\d+ .*before", str(trials["a moved picture"]))
    assert [each.name for each in trials.values() if each.broken] == ["a moved picture"]


PIXEL = "ivec2 pixel = ivec2(gl_FragCoord.xy);"
INTENSITY = "light_color * light_intensity"
LIT = "partial_lit_1, partial_lit_2"
TOWARDS = "normalize_(light_position - position_world)"
NORMAL = "fragment_normal = vertex.fragment_normal;"
PLANTED = {  # mistake -> file, what stands there, what is written in its place, the change that shows it, keys
    "a width written out": (
        "blur.frag",
        PIXEL,
        f"ivec2 pixel = ivec2(gl_FragCoord.xy / {SIDE}.0 * vec2(textureSize(lit, 0)));",
        "a larger picture",
        ONE_LIGHT,
    ),
    "texture coordinates of another size": (
        "composite.frag",
        PIXEL,
        f"ivec2 pixel = ivec2(gl_FragCoord.xy / {SIDE}.0 * vec2(textureSize(coverage, 0)));",
        "a larger picture",
        ONE_LIGHT,
    ),
    "noise that stays on the screen": (
        "composite.frag",
        "out_image = image;",
        "out_image = image * (1.0 + fract(gl_FragCoord.x * 0.31) * 0.01);",
        "a moved picture",
        ONE_LIGHT,
    ),
    "one light's colour for all": ("camera", "(light_color_2,", "(light_color_1,", "lights swapped", TWO_LIGHTS),
    "a loop over the first light": ("camera", LIT, "partial_lit_1, vec3(0.0)", "lights swapped", TWO_LIGHTS),
    "intensity left out": ("camera", INTENSITY, "light_color", "colour for intensity", ONE_LIGHT),
    "colour decoded as sRGB": (
        "camera",
        INTENSITY,
        "pow(light_color, vec3(2.2)) * light_intensity",
        "colour for intensity",
        ONE_LIGHT,
    ),
    "the vertex's number": (
        "camera.vert",
        NORMAL,
        "fragment_normal = vertex.fragment_normal * (1.0 + 0.0001 * float(gl_VertexID));",
        "vertices reordered",
        ONE_LIGHT,
    ),
    "a length written out": (
        "camera",
        TOWARDS,
        "normalize_(light_position - position_world + vec3(0.01))",
        "twice as large",
        ONE_LIGHT,
    ),
}


@needs_mesa
@pytest.mark.parametrize("mistake", PLANTED)
def test_planted_mistakes_are_told(mistake, tmp_path):
    name, right, wrong, change, keys = PLANTED[mistake]
    scene = small("sphere", keys)
    ours = shader_files(scene.method, array_lengths(scene.uniforms))
    files = {each: text for each, text in ours.items() if each == name or (each.startswith(name) and ".frag" in each)}
    changed = {each: text.replace(right, wrong) for each, text in files.items()}
    assert changed != files, f"no {right}"
    for each, text in changed.items():
        (tmp_path / each).write_text(text)
    artist = ShaderArtist(shader_folder(tmp_path, scene.settings))
    (trial,) = neutral(scene, artist, only=[change])
    assert trial.broken, trial


@needs_mesa
def test_on_the_command_line(tmp_path, capsys):
    scene = ["sphere", *(word for key in SMALL for word in ("--set", f"{key}={SIDE}"))]
    assert main(["neutral", *scene, "--only", "vertices reordered", "--only", "lights swapped"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[0].startswith("not tried: lights swapped: ") and printed[1].startswith("holds: vertices reordered: ")
    assert printed[2] == "neutral: nothing changed"
    loaded = small("sphere", {})
    text = shader_files(loaded.method, array_lengths(loaded.uniforms))["composite.frag"]
    (tmp_path / "composite.frag").write_text(text.replace("out_image = image;", "out_image = image * gl_FragCoord.x;"))
    assert main(["neutral", *scene, "--shaders", str(tmp_path), "--only", "a moved picture"]) == 1
    assert capsys.readouterr().out.endswith("broken: 1\n")
