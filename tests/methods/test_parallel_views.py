"""Whole scenes with parallel light and an orthographic camera, held against what can be worked out."""

import numpy as np
import pytest
from scenes import around, cube, two_slabs, wedge, written

from sss_ref.errors import SceneError, StageError
from sss_ref.language import normalize, stage, vec3
from sss_ref.passes.shadow_map import BackPoint
from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene
from sss_ref.scene.own_stage import with_stage
from sss_ref.validation.stage_by_stage import validate

BELOW = {"type": "directional", "position": [0, 0, -9], "target": [0, 0, 0], "up": [0, 1, 0]}
FLAT = {"type": "orthographic", "eye": [0, 0, 6], "target": [0, 0, 0], "view_height": 2.5, "width": 40, "height": 40}


def rendered(path, method="screen_space", **tables):
    scene = load_scene(around(path, 64, method=method, **tables))
    result = render(scene, "arrays")
    assert render(scene, "kernel").hashes == result.hashes
    return result


def test_thickness_of_a_wedge_lit_from_below_is_its_height(tmp_path):
    """Between z = -1 and z = -3 - x the way of a vertical ray is 2 + x, and its distance from z = -9 is 6 - x."""
    path = written(tmp_path / "wedge.obj", *wedge())
    result = rendered(path, lights=[BELOW], camera={**FLAT, "view_height": 1.8})
    inside = result["shadow_valid"] == 1
    x = result["position_world"][..., 0]
    assert inside.mean() > 0.99
    texel = float(result.scene.uniforms["light_texel_size"])
    assert np.abs(result["thickness"] - (2 + x))[inside].max() <= texel  # a texel has the distance of its middle
    assert np.abs(result["stored_distance"] - (6 - x))[inside].max() <= texel
    assert np.abs(result["entry_point"][..., :2] - result["position_world"][..., :2]).max() == 0


def test_an_orthographic_picture_has_its_scale_everywhere(tmp_path):
    """2.5 units are 40 pixels high: the front of the cube, 2 wide, and its back, farther away, are 32."""
    path = written(tmp_path / "cube.obj", *cube())
    for direction in (1, -1):
        result = rendered(path, lights=[BELOW], camera={**FLAT, "eye": [0, 0, 6 * direction]})
        assert result["coverage"].sum() == 32 * 32
    row, column = np.argwhere(result["coverage"])[0]
    step = result["position_world"][row, column + 1] - result["position_world"][row, column]
    assert np.abs(step).max() == pytest.approx(2.5 / 40, rel=1e-6)
    assert np.unique(result["depth"][result["coverage"] == 1]).tolist() == [np.float32((5 - 0.1) / 99.9)]


def test_an_offset_in_mm_is_as_long_everywhere_on_an_orthographic_picture(tmp_path):
    """2.5 units of 8 mm are 40 pixels high, however far a slope is from the camera: 0.5 mm each."""
    path = written(tmp_path / "wedge.obj", *wedge())
    millimetres = {"mm_per_unit": 8.0, "blur": {"unit": "mm", "mm_per_offset": 1.0}}
    result = rendered(path, lights=[BELOW], camera={**FLAT, "eye": [9, 0, 6]}, **millimetres)
    covered = result["coverage"] == 1
    assert np.ptp(result["depth"][covered]) > 0
    assert np.unique(result["mm_per_pixel"][covered]).tolist() == [0.5]
    assert np.unique(result["pixels_per_offset"][covered]).tolist() == [2]


def test_phong_of_a_flat_face_is_one_colour(tmp_path):
    """Neither the way to the light nor the way to the eye changes along it."""
    path = written(tmp_path / "cube.obj", *cube(), flat=True)
    sun = {"type": "directional", "azimuth": 10, "elevation": 20}
    phong = rendered(path, lights=[sun], camera=FLAT)
    assert len(np.unique(phong["phong"][phong["coverage"] == 1], axis=0)) == 1


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_lights_of_both_kinds_and_both_interpreters(tmp_path, method, preset):
    lights = [{"azimuth": 30, "distance": 5}, {"type": "directional", "azimuth": 200, "elevation": 20}]
    path = "sphere" if method == "texture_space" else written(tmp_path / "slabs.obj", *two_slabs())
    size = {"irradiance_map": {"width": 32, "height": 32}}
    result = rendered(path, method, lights=lights, camera=FLAT, preset=preset, **size)
    names = set(result.scene.method.stages)
    assert {"back_point_parallel", "phong_shading_directional_orthographic"} <= names
    assert any("directional" in stage.name for stage in result.scene.method["shadow_map_2"].stages)
    assert result.scene.method["shadow_map_1"].stages[0].name == "distance_to_light"


def test_64_lights(tmp_path):
    """Each as strong as a 64th gives what one gives, but for the rounding of the sums."""
    path, size = written(tmp_path / "slabs.obj", *two_slabs()), 12
    one = render(load_scene(around(path, size)), "arrays")
    data = around(path, size)
    many = render(load_scene({**data, "lights": [{**data["lights"][0], "intensity": 1 / 64}] * 64}), "arrays")
    assert {"shadow_uv_1", "shadow_uv_64", "phong"} <= set(many.buffers)
    assert np.abs(many["phong"] - one["phong"]).max() < 1e-5
    with pytest.raises(SceneError, match=r"expected 1 to 64 lights, got .*; add or remove"):
        load_scene({**data, "lights": data["lights"] * 65})


def test_64_lights_of_both_kinds_in_every_interpreter_and_validated(tmp_path):
    kinds = ("point", "directional")
    lights = [{"type": kinds[i % 2], "azimuth": 5.625 * i, "elevation": i % 50, "distance": 9} for i in range(64)]
    tables = {"lights": lights, "shadow_map": {"width": 32, "height": 32}}
    scene = load_scene(around(written(tmp_path / "slabs.obj", *two_slabs()), 32, **tables))
    result = render(scene, "arrays")
    assert render(scene, "kernel").hashes == result.hashes
    assert validate(scene, result.buffers, explain=False).passed
    wrong = result["thickness_64"] + np.float32(0.1) * (result["thickness_64"] > 0)
    found = validate(scene, {**result.buffers, "thickness_64": wrong}, explain=False)
    assert found.culprit.stage == "back_point_parallel"


def test_a_stage_of_ones_own_is_made_for_parallel_rays_too(tmp_path):
    @stage(source="a test")
    def shallow(position_world: vec3, light_position: vec3, stored_distance: float) -> BackPoint:
        return BackPoint(position_world + normalize(light_position - position_world), stored_distance)

    scene = load_scene(around(written(tmp_path / "cube.obj", *cube()), 16, lights=[BELOW]))
    mine = with_stage(scene, "back_point_parallel", shallow)
    assert mine.method["camera"].stages[3].name == "shallow_directional"
    entry, at = (render(mine)[name] for name in ("entry_point", "position_world"))
    assert np.array_equal((at + np.float32([0, 0, -1]))[entry != 0], entry[entry != 0])

    @stage(source="a test")
    def lost(light_position: vec3, stored_distance: float) -> BackPoint:
        return BackPoint(light_position, stored_distance)

    with pytest.raises(StageError, match="let the stage read light_direction too"):
        with_stage(scene, "back_point_parallel", lost)


@pytest.mark.parametrize(
    ("light", "problem"),
    [
        (
            {"azimuth": 3},
            "lights[0].distance: expected a value, got nothing; add it: how far the light is from its target",
        ),
        (
            {"distance": 3},
            "lights[0].position: expected a value, got nothing; add it, or azimuth, elevation and distance",
        ),
        (
            {"azimuth": 3, "distance": 3, "position": [0, 0, 9]},
            "lights[0].position: expected no position beside azimuth, got [0, 0, 9]; remove one of the two",
        ),
        (
            {"type": "directional", "azimuth": 3, "falloff": "inverse_square"},
            'lights[0].falloff: expected "none", got "inverse_square"; choose one of these',
        ),
        (
            {"type": "directional", "azimuth": 3, "fov_y": 30},
            "lights[0].fov_y: expected a known key, got this one; remove it (known here: azimuth, color, distance, "
            "elevation, falloff, far, intensity, near, position, target, type, up, view_height)",
        ),
    ],
)
def test_what_is_wrong_with_a_light_is_told(light, problem):
    with pytest.raises(SceneError) as caught:
        load_scene(around("sphere", lights=[light]))
    assert str(caught.value) == f"scene: {problem}"


def test_the_printed_figures_have_neither():
    with pytest.raises(SceneError) as caught:
        load_scene(around("sphere", preset="published", lights=[BELOW], camera=FLAT))
    told = [line.partition(" with preset")[0] for line in str(caught.value).split("\n")]
    assert 'scene: lights[0].type: expected "point"' in told
    assert "scene: camera.type: expected a perspective" in told
    assert not [line for line in told if "known key" in line]
