"""Normal map and specular map on a software OpenGL and in a browser: right shaders pass, each mistake is named."""

from dataclasses import replace

import numpy as np
import pytest
from bundle_player import Player
from chromium import SUBPIXEL_BITS, needs_chromium
from detailed import bumpy
from opengl import needs_mesa

from sss_ref import webgl
from sss_ref.bundle.writing import write_bundle
from sss_ref.gl import draw
from sss_ref.gl.context import open_context
from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

SIZE = 64
SWIFTSHADER = replace(PROFILES["vulkan"], subpixel_bits=SUBPIXEL_BITS)
SMALL = {"irradiance_map": {"width": SIZE, "height": SIZE}, "preset": "robust"}


def scene_in(folder, method="screen_space", **tables):
    return load_scene(bumpy(folder, SIZE, method=method, **SMALL, **tables))


@needs_mesa
@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_our_shaders_pass(tmp_path, method):
    scene = scene_in(tmp_path, method)
    verdict = validate(render(scene, "arrays"), draw(scene, keep=["all", "registers"]), explain=False)
    assert verdict.passed, verdict.summary


@needs_mesa
def test_the_bundle_alone_gives_the_same_buffers(tmp_path):
    scene = scene_in(tmp_path, "texture_space")
    folder = write_bundle(scene, tmp_path / "bundle")
    expected, context = draw(scene), open_context()
    try:
        played = Player(context, folder).play()
    finally:
        context.release()
    assert set(played) == set(expected)
    for buffer, values in expected.items():
        assert played[buffer].tobytes() == values.tobytes(), buffer


@needs_chromium
def test_a_browser_draws_it(tmp_path):
    scene = scene_in(tmp_path)
    verdict = validate(render(scene, "arrays"), webgl.draw(scene), profile=SWIFTSHADER, explain=False)
    assert verdict.passed, verdict.summary


MISTAKES = {
    "the normal map's green is upside down": (
        "normal_mapped",
        {"mapped.y * normal_scale.y": "mapped.y * -normal_scale.y"},
    ),
    "the normal map is read as sRGB": (
        "normal_mapped",
        {"texelFetch(texture_, ivec2(repeated": "DECODED(texture_, ivec2(repeated"},
    ),
    "the normal map is taken from 0 to 1, not from -1 to 1": ("normal_mapped", {" * 2.0 - 1.0;": ";"}),
    "there is no normal map": (
        "normal_mapped",
        {"normalize_(sideways + unmapped_normal_world * mapped.z)": "unmapped_normal_world"},
    ),
}
DECODED = """#version 400 core
#define DECODED(t, at, level) vec4(pow((texelFetch(t, at, level).rgb + 0.055) / 1.055, vec3(2.4)), 1.0)"""


@needs_mesa
@pytest.mark.parametrize("text", MISTAKES)
def test_a_mistake_is_named(tmp_path, text):
    scene = scene_in(tmp_path)
    stage, edits = MISTAKES[text]
    sources = shader_files(scene.method, array_lengths(scene.uniforms), registers=True)
    files = []
    for name in (name for name in sources if name.startswith("camera") and name.endswith(".frag")):
        changed = sources[name].replace("#version 400 core", DECODED) if "DECODED" in str(edits) else sources[name]
        for old, new in edits.items():
            changed = changed.replace(old, new)
        (tmp_path / name).write_text(changed)
        files.append(tmp_path / name)
    drawn = draw(scene, {"camera": files}, keep=["all", "registers"])
    verdict = validate(render(scene, "arrays"), drawn)
    assert not verdict.passed and verdict.culprit.stage == stage
    assert verdict.explanations[0].endswith(text), verdict.explanations


def test_the_maps_repeat_as_the_shader_says(tmp_path):
    """What a bundle holds of them are the very texels."""
    scene = scene_in(tmp_path)
    write_bundle(scene, tmp_path / "bundle")
    again = load_scene(tmp_path / "bundle")
    for name, texels in scene.maps.items():
        assert np.array_equal(texels, again.maps[name])
    assert again.mesh.tangents.tobytes() == scene.mesh.tangents.tobytes()
