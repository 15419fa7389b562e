"""Whole scenes on a software OpenGL beside the oracle: same coverage, same triangles, close values."""

import re

import numpy as np
import pytest
from opengl import needs_mesa
from scenes import around, sphere, two_squares, written

from sss_ref.errors import SceneError, ShaderError
from sss_ref.gl import draw
from sss_ref.interpret.shader import array_lengths, shader_files
from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene

pytestmark = needs_mesa

SIZE = 96
SMALL = {
    f"{table}.{side}": SIZE for table in ("camera", "shadow_map", "irradiance_map") for side in ("width", "height")
}
SCENES = ("wedge", "sphere", "teaching", "figure3_with")
METHODS = ("screen_space", "texture_space")
HALF_SUBPIXEL = 0.5 / 256  # pixels: how far the snap moves a triangle, and with it what it interpolates


def oracle(scene):
    """The buffers that OpenGL should give; array code has nothing to compile."""
    return render(scene, "arrays", threads=1).buffers


def both(scene, **overrides):
    """The buffers of the oracle and of OpenGL, and the scene."""
    loaded = load_scene(scene, **SMALL, **overrides)
    return oracle(loaded), draw(loaded), loaded


def window(loaded, position_world):
    """Where the camera sees world positions (N, 3), in pixels, in float64."""
    clip = np.c_[position_world, np.ones(len(position_world))] @ np.asarray(loaded.camera.clip_from(np.eye(4)), float).T
    return (clip[:, :2] / clip[:, 3:] * 0.5 + 0.5) * SIZE


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("scene", SCENES)
def test_the_same_pixels_show_the_same_triangles(scene, method):
    expected, got, _ = both(scene, method=method)
    assert list(got) == list(expected)
    for name, buffer in got.items():
        assert (buffer.dtype, buffer.shape) == (expected[name].dtype, expected[name].shape)
    for name in {"coverage", "irradiance_mask", "irradiance_filled_mask"} & set(got):
        np.testing.assert_array_equal(got[name], expected[name])
    for name in ("triangle", "light_triangle"):
        np.testing.assert_array_equal(got[name] < 0, expected[name] < 0)
        differing = got[name] != expected[name]
        assert differing.sum() <= 2  # on the outline, where two triangles share the sample and nearly the depth


@pytest.mark.parametrize("scene", SCENES)
def test_a_position_is_seen_at_its_pixel(scene):
    """OpenGL interpolates on the triangle as it is, the oracle on the snapped one; neither is off by more."""
    expected, got, loaded = both(scene)
    rows, columns = np.nonzero((got["triangle"] == expected["triangle"]) & (got["coverage"] == 1))
    centres = np.stack([columns + 0.5, rows + 0.5], axis=-1)
    for buffers in (expected, got):
        moved = window(loaded, buffers["position_world"][rows, columns]) - centres
        assert np.abs(moved).max() <= HALF_SUBPIXEL
    assert len(rows) > 500


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("scene", SCENES)
def test_the_pictures_agree(scene, method):
    """Not at every pixel: beside an edge of the shadow map another texel may count."""
    expected, got, _ = both(scene, method=method)
    for name in ("phong", "image"):
        apart = np.abs(got[name] - expected[name]).max(axis=-1)
        assert np.quantile(apart, 0.98) < 3e-4
        assert np.ptp(expected[name]) > 0.05


def body(tmp_path, size=64, **tables):
    positions, triangles, uvs = sphere(12)
    path = written(tmp_path / "sphere.obj", positions, triangles, uvs)
    return load_scene(around(path, size, irradiance_map={"width": size, "height": size}, **tables))


@pytest.mark.parametrize("distance", [0.3, 1.2], ids=["from inside", "through the surface"])
def test_triangles_cut_by_the_near_plane_and_beyond_the_sides(tmp_path, distance):
    camera = {"distance": distance, "near": 0.25, "fov_y": 100.0}
    scene = body(tmp_path, **{"camera": around("any", 64)["camera"] | camera})
    expected, got = oracle(scene), draw(scene)
    np.testing.assert_array_equal(got["coverage"], expected["coverage"])
    assert (got["triangle"] != expected["triangle"]).sum() <= 2


@pytest.mark.parametrize("method", METHODS)
def test_two_lights(tmp_path, method):
    lights = [{"position": [2.0, 1.5, 2.5]}, {"position": [-3.0, 2.0, -1.0], "falloff": "inverse_square"}]
    scene = body(tmp_path, method=method, preset="robust", lights=lights)
    expected, got = oracle(scene), draw(scene)
    assert set(got) == set(expected) and "thickness_2" in got
    assert np.quantile(np.abs(got["image"] - expected["image"]), 0.98) < 2e-4
    assert np.ptp(expected["image"]) > 0.1


def test_materials_of_more_triangles_than_a_row_of_texels_holds(tmp_path):
    positions, triangles, _ = sphere(40)
    colors = [f"newmtl m{number}\nKd {number / 64} 0.5 {1 - number / 64}" for number in range(45)]
    (tmp_path / "many.mtl").write_text("\n".join(colors))
    lines = ["mtllib many.mtl", *(f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist())]
    for first in range(0, len(triangles), 140):
        lines.append(f"usemtl m{first // 140}")
        lines += ["f " + " ".join(map(str, corners)) for corners in (triangles[first : first + 140] + 1).tolist()]
    (tmp_path / "many.obj").write_text("\n".join(lines))
    data = around(str(tmp_path / "many.obj"), 64)
    scene = load_scene(
        data | {"mesh": data["mesh"] | {"color": "material"}, "camera": data["camera"] | {"elevation": -30}}
    )
    expected, got = oracle(scene), draw(scene)
    same = got["triangle"] == expected["triangle"]
    assert same.mean() > 0.999
    np.testing.assert_array_equal(got["albedo"][same], expected["albedo"][same])
    assert got["triangle"].max() > 4096 and len(np.unique(got["albedo"])) > 20


@pytest.mark.parametrize("overlap", ["first", "last"])
def test_the_policy_decides_which_of_two_triangles_owns_a_texel(tmp_path, overlap):
    """Two squares, one behind the other, with the same UVs: in the mode `distance` they differ."""
    path = written(tmp_path / "squares.obj", *two_squares())
    layout = {"width": 32, "height": 32, "overlap": overlap, "mode": "distance"}
    scene = load_scene(around(path, 32, method="texture_space", irradiance_map=layout))
    expected, got = oracle(scene), draw(scene)
    np.testing.assert_allclose(got["irradiance"], expected["irradiance"], rtol=1e-5)


@pytest.mark.parametrize("method", METHODS)
def test_the_printed_figures(tmp_path, method):
    """A texture read in the vertex shader, and targets of eight bits: most pixels hold the same byte."""
    scene = body(tmp_path, method=method, preset="published", shadow_map={"width": 64, "height": 64})
    expected, got = oracle(scene), draw(scene)
    assert list(got) == list(expected)
    np.testing.assert_array_equal(got["coverage"], expected["coverage"])
    for name in {"light_distance", "lit", "irradiance", "image"} & set(got):
        steps = np.rint((got[name] - expected[name]) * 255)
        assert np.abs(steps).max() <= 1 and (steps == 0).mean() > 0.97
    assert len(np.unique(expected["image"])) > 50


@pytest.fixture
def ours(tmp_path):
    """A scene, and the translated shaders by file name."""
    scene = body(tmp_path, size=32)
    return scene, shader_files(scene.method, array_lengths(scene.uniforms))


def test_our_own_files_change_nothing(ours, tmp_path):
    scene, files = ours
    paths = {name: tmp_path / name for name in files}
    for name, path in paths.items():
        path.write_text(files[name])
    given = {"camera": [path for name, path in paths.items() if name.startswith("camera")], "blur": paths["blur.frag"]}
    expected, got = draw(scene), draw(scene, given)
    assert len(given["camera"]) == 4 and list(got) == list(expected)
    assert all(got[name].tobytes() == buffer.tobytes() for name, buffer in expected.items())


def test_what_is_kept_comes_back(tmp_path):
    scene = body(tmp_path, size=32, preset="published")
    everything = draw(scene, keep=["all", "registers", "taps"])
    assert [name for name in everything if name not in draw(scene)] == [
        "exact_light_distance",
        "exact_lit",
        *(f"tap_{number:02}" for number in range(13)),
        "exact_image",
    ]
    assert everything["exact_lit"].max() > everything["lit"].max()
    assert list(draw(scene, keep="exact_lit")) == ["exact_lit"]
    with pytest.raises(SceneError, match='keep: expected "all"'):
        draw(scene, keep="texel_uv")


def test_a_users_shader_takes_the_place_of_ours(ours, tmp_path):
    """It writes lit alone: what it does not write of its stages is missing, what the rasterizer writes is not."""
    scene, files = ours
    path = tmp_path / "mine.frag"
    path.write_text(re.sub(r"out_lit = lit;", "out_lit = lit * 2.0;", files["camera_3.frag"]))
    expected, got = draw(scene), draw(scene, {"camera": path})
    missing = set(expected) - set(got)
    assert "thickness" in missing and not {"lit", "scattered", "image", "coverage", "triangle", "depth"} & missing
    np.testing.assert_array_equal(got["lit"], expected["lit"] * 2)
    np.testing.assert_array_equal(got["scattered"], expected["scattered"] * 2)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda text: text.replace("void main()", "void main("), r"mine\.frag: expected shaders that compile"),
        (lambda text: text.replace("out_lit", "out_lid"), r"expected outputs of pass camera .*, got out_lid"),
        (lambda text: text.replace("location = 0", "location = 1"), r"expected outputs at locations 0, 1"),
        (lambda text: text.replace("out_lit", "lit_color"), r"expected outputs at locations 0, 1"),
        (lambda text: text.replace("d_min", "d_mim"), r"mine\.frag: expected names of .* d_min, .* got d_mim"),
        (lambda text: text.replace("lit", "phong_out"), "expected outputs"),
    ],
)
def test_a_shader_that_does_not_fit_is_refused(ours, tmp_path, change, message):
    scene, files = ours
    path = tmp_path / "mine.frag"
    path.write_text(change(files["camera_3.frag"]))
    with pytest.raises(ShaderError, match=message):
        draw(scene, {"camera": path})


def test_a_vertex_shader_alone_is_drawn_with_our_fragment_shaders(ours, tmp_path):
    """In every draw of the pass: what the rasterizer writes follows it too."""
    scene, files = ours
    path = tmp_path / "camera.vert"
    path.write_text(files["camera.vert"])
    expected = draw(scene)
    assert {name: array.tobytes() for name, array in draw(scene, {"camera": path}).items()} == {
        name: array.tobytes() for name, array in expected.items()
    }
    path.write_text(files["camera.vert"].replace("gl_Position = vertex.clip_position;", "gl_Position = vec4(2.0);"))
    got = draw(scene, {"camera": path})
    assert expected["coverage"].any() and not got["coverage"].any() and (got["triangle"] == -1).all()
    fragment = tmp_path / "camera_3.frag"
    fragment.write_text(files["camera_3.frag"])
    got = draw(scene, {"camera": [path, fragment]})
    assert not got["coverage"].any() and (got["triangle"] == -1).all() and not got["lit"].any()


def test_a_vertex_shader_that_does_not_compile_is_named(ours, tmp_path):
    scene, files = ours
    path = tmp_path / "camera.vert"
    path.write_text(files["camera.vert"].replace("void main()", "void main("))
    with pytest.raises(ShaderError, match=r"camera\.vert: expected shaders that compile and link"):
        draw(scene, {"camera": path})


def test_more_lights_than_opengl_has_textures_for(tmp_path):
    data = around("teaching", 16)
    with pytest.raises(
        ShaderError, match=r"^camera_\d+: expected at most \d+ textures, .*, got 128; draw fewer lights"
    ):
        draw(load_scene({**data, "lights": data["lights"] * 64}))


def test_a_second_vertex_shader_is_refused(ours, tmp_path):
    scene, _ = ours
    with pytest.raises(
        ShaderError, match=r"b\.vert: expected one vertex shader a pass, got \S*a\.vert as well; remove"
    ):
        draw(scene, {"camera": [tmp_path / "a.vert", tmp_path / "b.vert"]})


def test_a_pass_that_lacks_what_a_shader_left_out_says_so(ours, tmp_path):
    scene, files = ours
    (tmp_path / "mine.frag").write_text(files["camera_1.frag"])
    with pytest.raises(ShaderError, match="pass blur: expected the buffer lit, which no shader wrote"):
        draw(scene, {"camera": tmp_path / "mine.frag"})


def test_other_names_are_refused(ours, tmp_path):
    scene, _ = ours
    with pytest.raises(ShaderError, match=r"expected passes of screen_space \(shadow_map, .*, got 'lighting'"):
        draw(scene, {"lighting": tmp_path / "mine.frag"})
    with pytest.raises(ShaderError, match=r"none\.frag: expected GLSL source, got"):
        draw(scene, {"camera": tmp_path / "none.frag"})
