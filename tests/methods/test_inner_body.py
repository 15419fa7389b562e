"""Whole scenes of a body inside another one, held against what can be worked out."""

import numpy as np
import pytest
from scenes import around, cube, sphere, written

from sss_ref.errors import SceneError
from sss_ref.language import stage, vec3
from sss_ref.methods.inner_body import OWN
from sss_ref.passes.phong import Phong
from sss_ref.rendering.fold import render
from sss_ref.scene import load_scene
from sss_ref.scene.own_stage import with_stage
from sss_ref.scene.uniforms import uniforms_of
from sss_ref.scene_file.settings import PhongSettings

EXTINCTION = [0.1, 0.5, 2.0]
FRONT = {"type": "orthographic", "eye": [0, 0, 6], "target": [0, 0, 0], "view_height": 2.5, "width": 40, "height": 40}
BEFORE = {"type": "directional", "position": [0, 0, 9], "target": [0, 0, 0]}
SIDE = {"type": "directional", "azimuth": 60, "elevation": 20}

SEEN_FROM_NEAR = {
    "lights": [{"position": [3.0, 2.0, 3.0]}],
    "camera": {"type": "orbit", "distance": 5.0, "azimuth": 30.0, "width": 40, "height": 40},
}


@pytest.fixture
def scene(tmp_path):
    """A scene of a cube of half width 1 with a cube of half width 1/2 in it, or another body, and further tables."""

    def made(inner=cube, size=0.5, layer=None, **tables):
        outside = written(tmp_path / "outer.obj", *cube(), flat=True)
        positions, triangles, *_ = inner()
        inside = written(tmp_path / "inner.obj", positions * size, triangles, flat=True)
        layers = [{"path": inside, "color": [0.9, 0.6, 0.3], "extinction_per_mm": EXTINCTION, **(layer or {})}]
        given = {"camera": FRONT, "lights": [BEFORE], "mm_per_unit": 3.0, **tables}
        return around(outside, 64, layers=layers, **given)

    return made


def rendered(data):
    loaded = load_scene(data)
    result = render(loaded, "arrays")
    assert render(loaded, "kernel", threads=1).hashes == result.hashes
    return result


def test_between_two_faces_the_way_is_their_distance_and_light_fades_on_it_twice(scene):
    """From z = 1 to z = 1/2 both light and sight go 1.5 mm. The inner face is seen at 16 x 16 of 32 x 32 pixels."""
    result = rendered(scene())
    inside = result["inner_coverage"] == 1
    assert inside.sum() == 16 * 16 and result["coverage"].sum() == 32 * 32
    assert set(np.unique(result["way_to_inner"])) == {0, 1.5}
    left = np.exp(np.float32(-1.5) * np.float32(EXTINCTION)).astype(np.float32)
    np.testing.assert_allclose(result["inner_incident_light"][inside], np.tile(left, (256, 1)), rtol=1e-6)
    added = result["seen"] - result["lit"]
    np.testing.assert_allclose(added[inside], (result["inner_lit"] * left)[inside], rtol=1e-5)
    assert not added[~inside].any()


def test_the_inner_body_is_drawn_as_it_is_without_the_outer_one(scene):
    """Its shadow map, its own thickness and its own T; only the light that reaches it is another."""
    both = rendered(scene(sphere_of_8, 0.8, lights=[SIDE], translucency={"y": 0.5}))
    alone = scene(sphere_of_8, 0.8, lights=[both.scene.settings.lights[0].model_dump()], translucency={"y": 0.5})
    alone = {**alone, "mesh": {"path": alone["layers"][0]["path"], "color": [0.9, 0.6, 0.3]}, "layers": []}
    alone = render(load_scene(alone), "arrays")
    for name in ("light_distance", "triangle", "depth", "position_world", "albedo", "thickness", "translucency"):
        np.testing.assert_array_equal(both[f"inner_{name}"], alone[name])
    np.testing.assert_array_equal(both["inner_light_around"], alone["incident_light"])


def test_the_outer_body_is_drawn_as_it_is_without_the_inner_one(scene):
    data = scene()
    alone = render(load_scene({**data, "layers": []}), "arrays")
    both = rendered(data)
    for name in alone.buffers.keys() - {"scattered", "image"}:
        np.testing.assert_array_equal(both[name], alone[name])
    assert "seen" not in alone.buffers and (both["image"] != alone["image"]).any()


def test_a_layer_has_a_material_of_its_own_and_takes_the_rest_from_the_scene(scene):
    material = {"phong": {"specular": 0.0}, "translucency": {"combine": "add", "x": 3.0}}
    result = rendered(scene(layer=material, phong={"ambient": 0.3}, translucency={"y": 0.25}))
    uniforms = result.scene.uniforms
    assert (uniforms["specular"], uniforms["inner_specular"], uniforms["inner_ambient"]) == (0.5, 0, np.float32(0.3))
    assert (uniforms["x"], uniforms["inner_x"], uniforms["inner_y"]) == (2, 3, 0.25)
    assert (uniforms["translucency_neutral"], uniforms["inner_translucency_neutral"]) == (1, 0)
    assert {"lit_add_directional", "lit_multiply"} <= set(result.scene.method.stages)


def test_every_key_of_its_material_reaches_its_stages(scene):
    """What would be the outer body's in silence, if a uniform were left out of `OWN`."""
    phong = dict.fromkeys(PhongSettings.model_fields, 0.375)
    numbers = {key: 0.375 for key, value in load_scene(scene()).settings.translucency if isinstance(value, float)}
    translucency = {**numbers, "gaussians": [[0.375, 0.375, 0.375, 0.375]], "combine": "add"}
    loaded = load_scene(scene(layer={"phong": phong, "translucency": translucency}))
    settings = loaded.settings
    given = (loaded.world_from_model, loaded.camera, loaded.lights)
    outer, own = (uniforms_of(each, *given, {}) for each in (settings, settings.inner))
    differing = {name for name in own if not np.array_equal(outer[name], own[name])}
    assert len(differing) >= 12 and differing <= set(OWN)
    assert set(OWN) - differing <= {"mesh_color", "translucency_neutral"}  # which `Scene.uniforms` adds


@pytest.mark.parametrize("preset", ["paper", "robust"])
def test_several_lights_and_a_perspective(scene, preset):
    """Each light has its own way through the outer body, and its number."""
    two = {**SEEN_FROM_NEAR, "lights": [SIDE, *SEEN_FROM_NEAR["lights"]]}
    result = rendered(scene(sphere_of_8, 0.9, preset=preset, **two))
    assert (result["inner_incident_light_1"] != result["inner_incident_light_2"]).any()
    assert {"shadow_map_1", "inner_shadow_map_2", "inner_camera"} <= {each.name for each in result.scene.method.passes}
    assert result["way_to_inner"].max() > 0


def test_the_inner_body_has_soft_shadows_by_the_kernel_of_the_scene(scene):
    """The kernel is no buffer of a body: its taps are the same for both."""
    result = rendered(scene(sphere_of_8, 0.9, shadow_map={"test": "kernel"}, **SEEN_FROM_NEAR))
    visible = result["inner_light_visible"][result["inner_coverage"] == 1]
    assert ((visible > 0) & (visible < 1)).any() and (visible[:, 0] != visible[:, 2]).any()


def test_what_reaches_out_is_told_and_seen_before_the_mesh_alone(scene):
    result = rendered(scene(size=1.1))
    assert not result["way_to_inner"].any()
    assert any("layers[0]: it reaches out of the mesh" in line for line in result.scene.warnings)
    assert not result["seen"][result["coverage"] == 0].any()


@stage(source="a test")
def thickness_shown(albedo: vec3, thickness: float) -> Phong:
    """Red of the body that it is of, and how thick that is."""
    return Phong(vec3(albedo.x, thickness, 0.0))


def test_a_stage_of_ones_own_runs_for_both_bodies(scene):
    """It reads what the one in whose place it stands does not, of the body that it is of."""
    result = render(with_stage(load_scene(scene(**SEEN_FROM_NEAR)), "phong_shading", thickness_shown), "arrays")
    for body in ("", "inner_"):
        np.testing.assert_array_equal(result[f"{body}phong"][..., 0], result[f"{body}albedo"][..., 0])
        np.testing.assert_array_equal(result[f"{body}phong"][..., 1], result[f"{body}thickness"])


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"method": "texture_space"}, 'layers: expected no layers with method = "texture_space", got 1; remove'),
        ({"preset": "published"}, 'layers: expected none with preset "published", got'),
        ({"layers.0.path": "nowhere"}, "layers[0].path: expected a mesh file or a shipped mesh's name, got"),
        ({"layers.0.extinction_per_mm": [0.1, -1, 0]}, "layers[0].extinction_per_mm[1]: expected a number >= 0"),
        ({"layers.0.scale": 2}, "layers[0].scale"),
        ({"layers.0.translucency.x": [1, 2]}, "override: layers[0].translucency.x[2]: expected a value, got nothing"),
        ({"layers.0.translucency.x": "a"}, "override: layers[0].translucency.x: expected a number"),
        ({"layers.0.translucency.gaussians": [[1]]}, "layers[0].translucency.gaussians[0][1]: expected a value"),
    ],
)
def test_what_a_layer_cannot_be(scene, changes, problem):
    with pytest.raises(SceneError) as error:
        load_scene(scene(), **changes)
    assert problem in str(error.value), str(error.value)


def test_one_layer_only(scene):
    data = scene()
    with pytest.raises(SceneError, match="layers: expected at most one layer, got 2; remove the others"):
        load_scene({**data, "layers": data["layers"] * 2})


def sphere_of_8():
    return sphere(8)
