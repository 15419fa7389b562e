"""Textures of bytes, read through the sampler's own filter: a right driver passes, a larger error fails."""

import numpy as np
import pytest
from edited import drawn_edited, rendered
from opengl import needs_mesa
from PIL import Image
from scenes import around, sphere, written

from sss_ref import gl
from sss_ref.gl.canvas import Canvas
from sss_ref.gl.shaders import shader_folder
from sss_ref.gl.uploads import downloaded
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.language.types import vec3
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

MAP = "scattered_irradiance"
BY_TEXELS = "return sample_bilinear_vec3(texture_, whole_part(at), fractional_part(at));"
BY_SAMPLER = "return textureLod(texture_, uv, 0.0).xyz;"
SRGB8 = 0x8C41  # GL_SRGB8


def bytes_of(buffer):
    return np.rint(np.clip(buffer, 0, 1) * 255).astype(np.uint8)


def linear(context, texels, internal_format=None):
    """A texture of bytes (H, W, 3) that is filtered."""
    height, width = texels.shape[:2]
    texture = context.texture(
        (width, height), 3, texels.tobytes(), alignment=1, dtype="f1", internal_format=internal_format
    )
    texture.filter = (context.LINEAR, context.LINEAR)
    return texture


@pytest.fixture(scope="module")
def in_bytes(tmp_path_factory):
    """figure5 as drawn where the irradiance that the camera reads is in unorm8; that map is dumped as it was read."""
    hand_over = Canvas.hand_over

    def with_bytes(canvas, program, buffers, where):
        there = dict(buffers)
        if MAP in there and "camera" in where:
            there[MAP] = linear(canvas.context, bytes_of(downloaded(there[MAP], vec3)))
            there[MAP].repeat_x = there[MAP].repeat_y = False
        hand_over(canvas, program, there, where)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Canvas, "hand_over", with_bytes)
        folder = tmp_path_factory.mktemp("bytes")
        drawing = drawn_edited("texture space", {BY_TEXELS: BY_SAMPLER}, folder, "camera")
    return {**drawing, MAP: bytes_of(drawing[MAP]).astype(np.float32) / np.float32(255)}


def judged(drawing, stored="unorm8", **more):
    return validate(rendered("texture space"), drawing, {MAP: stored}, explain=False, **more)


def test_a_filter_of_eight_bits_is_right(in_bytes):
    assert judged(in_bytes).passed, judged(in_bytes).summary


def test_and_wrong_where_the_profile_asks_for_more(in_bytes, tmp_path):
    exact = tmp_path / "exact.toml"
    exact.write_text("filter_bits = 0\n")
    assert judged(in_bytes, profile=str(exact)).culprit.stage == "irradiance_added_wrapped"


def test_more_than_two_of_its_steps_are_an_error(in_bytes):
    shown = rendered("texture space")["coverage"] != 0
    off = in_bytes["irradiance_used"] + np.float32(3.5 / 255) * shown[..., np.newaxis]
    assert judged({**in_bytes, "irradiance_used": off}).culprit.stage == "irradiance_added_wrapped"


@pytest.fixture
def painted(tmp_path):
    """A sphere with a picture of noise for its colour, and its camera's shaders, which let the sampler filter it."""
    picture = np.random.default_rng(3).integers(0, 256, (8, 8, 3), np.uint8)
    Image.fromarray(picture[::-1]).save(tmp_path / "noise.png")
    path = written(tmp_path / "sphere.obj", *sphere(6))
    mesh = {"path": path, "texture": str(tmp_path / "noise.png")}
    return render(load_scene(around(path, 64, mesh=mesh)), interpreter="arrays"), picture


def test_a_colour_texture_that_the_sampler_decodes(painted, tmp_path, monkeypatch):
    """Mesa's sampler decodes sRGB by a polynomial, a third of a code beside the formula."""
    oracle, picture = painted
    scene = oracle.scene
    by_texels = "return sample_repeated_vec3(texture_, texel_position(textureSize(texture_, 0), fract_(uv)));"
    (tmp_path / "shaders").mkdir()
    for name, text in shader_files(scene.method, array_lengths(scene.uniforms), registers=True).items():
        if name.startswith("camera"):
            (tmp_path / "shaders" / name).write_text(text.replace(by_texels, BY_SAMPLER))
    hand_over = Canvas.hand_over

    def with_codes(canvas, program, buffers, where):
        if "albedo_map" in canvas.textures:
            canvas.textures["albedo_map"] = linear(canvas.context, picture, SRGB8)
        hand_over(canvas, program, buffers, where)

    monkeypatch.setattr(Canvas, "hand_over", with_codes)
    drawing = gl.draw(scene, shader_folder(tmp_path / "shaders", scene.settings))
    assert validate(oracle, drawing, {"albedo_map": "srgb8"}, explain=False).passed
    assert validate(oracle, drawing, explain=False).culprit.stage == "albedo_textured"
    wrong = {**drawing, "albedo": drawing["albedo"] * np.float32(1.1)}
    assert validate(oracle, wrong, {"albedo_map": "srgb8"}, explain=False).culprit.stage == "albedo_textured"
