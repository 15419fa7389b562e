"""Every uniform of a scene whose keys are all unlike, worked out by hand from its file."""

import numpy as np
import pytest
from bodies import body
from scenes import settings_with

from sss_ref.methods.inner_body import OWN
from sss_ref.scene.uniforms import of_inner_body, stretch, uniforms_of
from sss_ref.view.views import camera_view, light_of

STAYING = np.eye(4)
EYE = {"type": "look_at", "eye": [0, 0, 4], "target": [0, 0, 0], "fov_y": 90, "near": 1, "far": 16}
CAMERA = {**EYE, "width": 8, "height": 16}
FITTED = {"position": [0, 8, 0], "target": [0, 0, 0], "up": [0, 0, 1], "fov_y": 90, "near": 2, "far": 10}
SHADOW = {"lookup_inset": 0.125, "bias_abs": 0.25, "bias_slope": 3.0, "kernel_scale": 1.5, "lookup_depth": 0.75}
TAPS = [[3.0, 4.0, 0.5, 0.25, 0.125], [0.0, -1.0, 0.5, 0.75, 0.875]]
KEYS = {
    "preset": "robust",
    "mm_per_unit": 4.0,
    "camera": CAMERA,
    "lights": [{**FITTED, "color": [1, 0.5, 0.25], "intensity": 3.0}],
    "shadow_map": {**SHADOW, "width": 16, "height": 32, "encoding": "float32"},
    "phong": {"ambient": 0.0625, "diffuse": 0.75, "specular": 0.375, "shininess": 12.0},
    "translucency": {"x": 2.0, "y": 0.5, "exponent": 0.25, "d_min": 0.01, "scale": 0.1, "wrap": 0.4, "form": "ratio"},
    "blur": {"kernel": TAPS, "unit": "mm", "mm_per_offset": 2.0, "normalize": False},
    "diffusion": {"taps": 7, "samples": 9},
    "output": {"background": [0.125, 0.25, 0.5]},
}
PLAIN = {  # uniform -> its value
    "handedness": 1.0,
    "normal_scale": [1, 1],
    "camera_position": [0, 0, 4],
    "camera_pixel_size": 0.125,  # 2 at a distance of 1, on 16 pixels
    "camera_direction": [0, 0, -1],
    "ahead": [0, 0, -0.4],  # the taps reach 5 * 2 mm, or 2.5 units
    "mm_per_unit": 4,
    "light_count": 1,
    "light_position": [0, 8, 0],
    "light_direction": [0, -1, 0],
    "light_color": [1, 0.5, 0.25],
    "light_intensity": 3,
    "light_texel_size": 0.0625,
    "light_clear_distance": 20,  # twice as far as it sees
    **SHADOW,
    "ambient": 0.0625,
    "diffuse": 0.75,
    "specular": 0.375,
    "shininess": 12,
    "x": 2,
    "y": 0.5,
    "exponent": 0.25,
    "d_min": 0.01,
    "translucency_scale": 0.1,
    "wrap": 0.4,
    "neutral_of_the_method": 0.5,
    "mm_per_offset": 2,
    "tap_offset": [[3, 4], [0, -1]],
    "tap_weight": [[0.5, 0.25, 0.125], [0.5, 0.75, 0.875]],
    "tap_00_offset": [3, 4],
    "tap_00_weight": [0.5, 0.25, 0.125],
    "tap_01_offset": [0, -1],
    "tap_01_weight": [0.5, 0.75, 0.875],
    "tap_count": 2,
    "kernel_count": 7,
    "sample_count": 9,
    "background": [0.125, 0.25, 0.5],
}
SEEN = [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, -17 / 15, 36 / 15], [0, 0, -1, 4]]  # clip from world of the camera
TURNED = np.array([[0, -2, 0, 5], [2, 0, 0, 6], [0, 0, 2, 7], [0, 0, 0, 1.0]])


def uniforms(changes=None, world_from_model=STAYING, constants=None):
    given = {**KEYS, **(changes or {})}
    settings = settings_with(given)
    lights = [light_of(light, settings.shadow_map) for light in settings.lights]
    return uniforms_of(settings, world_from_model, camera_view(settings.camera), lights, constants or {})


def test_each_has_the_value_that_the_file_says():
    found = uniforms(constants={"neutral_of_the_method": 0.5})
    for name, value in PLAIN.items():
        assert np.array_equal(found[name], np.array(value, np.asarray(found[name]).dtype)), name
        assert np.asarray(found[name]).dtype == np.float32 or isinstance(found[name], int), name
    assert np.shape(found["x"]) == () and found["gaussian_count"] == len(found["gaussian_variance"]) == 6
    assert found["gaussian_weight"].shape == (6, 3)


def test_matrices_go_from_the_mesh_or_from_the_world_to_the_picture():
    """At 90 degrees x is doubled on a picture half as wide as high; z = -near is -1 there and z = -far is 1."""
    found = uniforms(world_from_model=TURNED)
    np.testing.assert_array_equal(found["camera_clip_from_world"], np.float32(SEEN))
    np.testing.assert_array_equal(found["camera_clip_from_model"], (np.array(SEEN) @ TURNED).astype(np.float32))
    np.testing.assert_array_equal(found["world_from_model"], TURNED.astype(np.float32))
    assert np.array_equal(np.sign(found["normal_from_model"]), [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    light = found["light_clip_from_world"].astype(np.float64)
    np.testing.assert_allclose(light @ TURNED, found["light_clip_from_model"], rtol=1e-6)
    assert (light @ (0, 0, 0, 1)).tolist()[3] == 8, "w is the distance from the light"


def test_a_mesh_in_a_mirror_turns_the_other_way():
    assert uniforms(world_from_model=np.diag([-1.0, 1, 1, 1]))["handedness"] == -1
    assert uniforms(world_from_model=np.diag([-1.0, -1, 1, 1]))["handedness"] == 1


@pytest.mark.parametrize(("green", "scale"), [("up", [0.5, 0.5]), ("down", [0.5, -0.5])])
def test_green_of_a_normal_map_is_up_or_down(green, scale):
    mesh = {"path": "any", "normal_map": "bumps.png", "normal_map_green": green, "normal_strength": 0.5}
    assert uniforms({"mesh": mesh})["normal_scale"].tolist() == scale


def test_a_kernel_of_one_tap_reaches_nowhere():
    centre = {"kernel": [[0, 0, 1, 1, 1]], "unit": "mm", "mm_per_offset": 2.0, "normalize": False}
    assert uniforms({"blur": centre})["ahead"].tolist() == [0, 0, 0]
    near = {**centre, "kernel": [[2.0**-20, 0, 1, 1, 1]]}
    assert uniforms({"blur": near})["ahead"].tolist() == [0, 0, -(2.0**21)]


def test_a_technique_has_its_own_reach():
    found = uniforms({"method": "separable", "diffusion": {"reach_mm": 16.0}})
    assert found["ahead"].tolist() == [0, 0, -0.25]
    short, shortest = (
        uniforms({"method": "separable", "mm_per_unit": 1.0, "diffusion": {"reach_mm": reach}})["ahead"].tolist()
        for reach in (2e-30, 1e-30)
    )
    assert short == [0, 0, np.float32(-1 / 2e-30)] and shortest == [0, 0, 0]


def test_what_is_stored_in_other_texels_is_cleared_to_zero():
    clear = uniforms({"shadow_map": {**KEYS["shadow_map"], "encoding": "unorm8"}})["light_clear_distance"]
    assert clear == 0


def test_several_lights_have_numbers():
    other = {**FITTED, "position": [0, 4, 0], "intensity": 2.0}
    found = uniforms({"lights": [*KEYS["lights"], other]})
    assert found["light_count"] == 2 and "light_intensity" not in found
    assert (found["light_intensity_1"], found["light_intensity_2"]) == (3, 2)
    assert found["light_position_2"].tolist() == [0, 4, 0] and "light_intensity_3" not in found


def test_one_number_of_three_channels_makes_all_so():
    """And of form gaussians the variances stand beside the weights."""
    found = uniforms({"translucency": {**KEYS["translucency"], "x": [1.0, 2.0, 4.0]}})
    assert found["x"].tolist() == [1, 2, 4] and found["y"].tolist() == [0.5] * 3
    assert found["wrap"].shape == ()
    rows = [[2, 0.5, 0.25, 0.125], [8, 1, 2, 3]]
    found = uniforms({"translucency": {**KEYS["translucency"], "form": "gaussians", "gaussians": rows}})
    assert found["gaussian_variance"].tolist() == [2, 8] and found["gaussian_count"] == 2
    assert found["gaussian_weight"].tolist() == [[0.5, 0.25, 0.125], [1, 2, 3]] and found["d_min"].shape == (3,)


def test_a_layer_says_how_light_fades_on_the_way_to_it():
    assert "extinction_per_mm" not in uniforms()
    layers = [{"path": "any", "extinction_per_mm": [1, 2, 3]}]
    assert uniforms({"layers": layers})["extinction_per_mm"].tolist() == [1, 2, 3]


def test_the_inner_body_has_some_for_itself():
    found = of_inner_body({"ambient": 1, "background": 2, "mesh_color": 3, "bias_abs": 4})
    assert found == {"inner_ambient": 1, "inner_mesh_color": 3} and {"ambient", "mesh_color"} < set(OWN)


SQUARE = body([(0, 0, 0), (4, 0, 0), (4, 3, 0)], uvs=[(0, 0), (1, 0), (1, 1)])
MAP = {"irradiance_map": {"width": 8, "height": 16}}


@pytest.mark.parametrize(
    ("keys", "there"),
    [
        ({"method": "screen_space", "blur": {"unit": "mm"}}, False),
        ({"method": "texture_space", "blur": {"unit": "pixel"}}, False),
        ({"method": "texture_space", "blur": {"unit": "mm"}}, True),
        ({"method": "gaussian_texture", "blur": {"unit": "pixel"}}, True),
        ({"method": "separable", "blur": {"unit": "mm"}}, False),
    ],
)
def test_a_blur_in_mm_of_the_layout_reads_its_stretch(keys, there):
    """4 units along 8 texels of u, 3 along 16 of v."""
    found = stretch(settings_with({"preset": "robust", **MAP, **keys}), SQUARE.positions.astype(np.float64), SQUARE)
    assert {name: value.tolist() for name, value in found.items()} == (
        {"triangle_stretch": [[0.5, 0.1875]]} if there else {}
    )
