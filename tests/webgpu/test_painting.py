"""Whole scenes on lavapipe beside the oracle: another compiler and another API, which must give what is allowed."""

import numpy as np
import pytest
from lavapipe import LAVAPIPE, needs_lavapipe
from scenes import around, sphere, two_squares, written

from sss_ref import webgpu
from sss_ref.errors import SceneError, ShaderError
from sss_ref.interpret.shader import WGSL, shader_files
from sss_ref.rendering.fold import render
from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_lavapipe

QUICK = {  # what shows most: published (a texture read at the vertices, bytes), both methods, two lights
    "figure4_wax": {},
    "figure5": {},
    "wax": {},
    "teaching": {"method": "texture_space", "preset": "published"},
}
METHODS = ("screen_space", "texture_space")


def small(size):
    return {f"{t}.{s}": size for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}


def drawn(scene, shaders=None, keep="all"):
    return webgpu.draw(scene, shaders, keep, adapter=LAVAPIPE)


def assert_passes(scene):
    found = validate(render(scene, interpreter="arrays"), drawn(scene), profile="wgsl", explain=False)
    assert found.passed, found.summary
    assert not found.missing


@pytest.mark.parametrize("name", QUICK)
def test_our_own_shaders_pass(name):
    assert_passes(load_scene(name, **small(32), **QUICK[name]))


@pytest.mark.full
@pytest.mark.parametrize("method", [None, *METHODS])
@pytest.mark.parametrize("name", scene_names())
def test_every_shipped_scene_passes(name, method):
    try:
        scene = load_scene(name, **small(96), **({"method": method} if method else {}))
    except SceneError:
        pytest.skip("the scene has no such method")
    assert_passes(scene)


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A small sphere in colour, its files, and what ours draw."""
    path = written(tmp_path_factory.mktemp("ball") / "sphere.obj", *sphere(8))
    scene = load_scene(around(path, 24))
    return scene, shader_files(scene.method, {}, WGSL), drawn(scene)


def test_the_buffers_are_those_of_a_rendering(ball):
    scene, _, got = ball
    expected = render(scene, interpreter="arrays").buffers
    assert list(got) == list(expected)
    for name, buffer in expected.items():
        assert (got[name].dtype, got[name].shape) == (buffer.dtype, buffer.shape)
    np.testing.assert_array_equal(got["triangle"], expected["triangle"])
    np.testing.assert_allclose(got["image"], expected["image"], atol=2e-3)


def test_only_what_is_kept_comes_back(ball):
    scene, _, all_buffers = ball
    got = drawn(scene, keep=["lit"])
    assert list(got) == ["lit"] and got["lit"].tobytes() == all_buffers["lit"].tobytes()
    with pytest.raises(SceneError, match=r"^keep: expected "):
        drawn(scene, keep=["lid"])


def test_the_draws_of_a_pass_give_the_same_bits_as_fewer_with_wider_targets(ball, monkeypatch):
    scene, _, got = ball
    object.__setattr__(WGSL, "most_bytes", 128)
    try:
        wide = drawn(scene)
    finally:
        object.__setattr__(WGSL, "most_bytes", 32)
    assert {name: buffer.tobytes() for name, buffer in wide.items()} == {n: b.tobytes() for n, b in got.items()}


def test_a_shader_of_ones_own_is_drawn_in_the_place_of_ours(ball, tmp_path):
    scene, files, ours = ball
    path = tmp_path / "composite.frag"
    path.write_text(files["composite.frag"])
    assert drawn(scene, {"composite": path})["image"].tobytes() == ours["image"].tobytes()
    path.write_text(files["composite.frag"].replace("vec4<f32>(image, 1.0)", "vec4<f32>(image.zyx, 1.0)"))
    got = drawn(scene, {"composite": path})["image"]
    assert got.tobytes() == ours["image"][..., ::-1].tobytes() != ours["image"].tobytes()


def test_a_vertex_shader_alone_is_drawn_with_our_fragment_shaders(ball, tmp_path):
    scene, files, ours = ball
    path = tmp_path / "camera.vert"
    path.write_text(files["camera.vert"].replace("vec4<f32>(1.0, -1.0, 1.0, 1.0)", "vec4<f32>(1.0, 1.0, 1.0, 1.0)"))
    got = drawn(scene, {"camera": path})
    assert got["coverage"].tobytes() == ours["coverage"][::-1].tobytes()


def test_what_a_shader_leaves_out_is_missing(ball, tmp_path):
    scene, files, _ = ball
    path = tmp_path / "blur.frag"
    path.write_text(files["composite.frag"])
    with pytest.raises(ShaderError, match=r"expected outputs of pass blur \(scattered\), got out_image; rename it$"):
        drawn(scene, {"blur": path})


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("@fragment", "@fragmen", "expected shaders that compile and fit each other, got "),
        ("scattered", "scatterd", "expected names of earlier buffers or uniforms .*, got scatterd; "),
        ("background: vec3<f32>", "background: f16", r"expected background to be of type f32, .*, got f16; declare it"),
        (
            "texture_2d<u32>",
            "texture_3d<u32>",
            r"expected coverage to be a texture_2d of f32, i32 or u32, got texture_3d<u32>; d",
        ),
        ("@location(0) out_image", "@location(0) image", r"expected outputs at locations 0, .* as @location\(0\) out_"),
        ("struct Uniforms", "struct Constants", "expected a struct Uniforms with the uniforms, got none; define it"),
    ],
)
def test_what_does_not_fit_is_told(ball, tmp_path, old, new, message):
    scene, files, _ = ball
    path = tmp_path / "composite.frag"
    assert old in files["composite.frag"]
    path.write_text(files["composite.frag"].replace(old, new))
    with pytest.raises(ShaderError, match=rf"^\S*composite\.frag: {message}"):
        drawn(scene, {"composite": path})


@pytest.mark.parametrize("overlap", ["first", "last"])
def test_the_policy_decides_which_of_two_triangles_owns_a_texel(tmp_path, overlap):
    """Two squares, one behind the other, with the same UVs: in the mode `distance` they differ."""
    path = written(tmp_path / "squares.obj", *two_squares())
    layout = {"width": 32, "height": 32, "overlap": overlap, "mode": "distance"}
    scene = load_scene(around(path, 32, method="texture_space", irradiance_map=layout))
    expected = render(scene, "arrays", keep=["irradiance"])["irradiance"]
    np.testing.assert_allclose(drawn(scene, keep=["irradiance"])["irradiance"], expected, rtol=1e-5)
