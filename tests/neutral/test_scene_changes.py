"""What each change makes of a scene; what it does not name stays as it was."""

import numpy as np
import pytest
from scenes import around, cube, written

from sss_ref.neutral import scene_changes as changes
from sss_ref.scene.load import load_scene
from sss_ref.view.lenses import Orthographic, Perspective

FAR = {
    "position": [0, 4, 3],
    "falloff": "inverse_square",
    "intensity": 6.0,
    "color": [1, 0.5, 0.25],
    "near": 1,
    "far": 8,
}
NEAR = {"type": "directional", "azimuth": 30, "elevation": 10, "intensity": 2.0, "color": [0.25, 0.5, 1]}
LAMP = {"position": [2, 1, 2.5], "intensity": 4.0}
PLANE = {"type": "orthographic", "eye": [1, 2, 5], "target": [0, 0, 1], "view_height": 3, "near": 2, "far": 9}
INSIDE = {"path": "sphere", "extinction_per_mm": [1, 1, 1], "phong": {"ambient": 0.5}}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return written(tmp_path_factory.mktemp("bodies") / "cube.obj", *cube())


@pytest.fixture
def scene(path):
    """Three lights, the second of them far away by the square, a camera of parallel rays, a layer."""
    keys = {"lights": [LAMP, FAR, NEAR], "mm_per_unit": 4.0, "phong": {"ambient": 0.25}, "layers": [INSIDE]}
    camera = {"camera": {**PLANE, "width": 20, "height": 30}}
    return load_scene({**around(path, 16, preset="robust"), **keys, **camera}, **{"shadow_map.bias_abs": 0.01})


def seen(view):
    return [*view.eye, *view.target, view.near, view.far]


def test_a_color_twice_as_bright_for_half_the_intensity(scene):
    changed = changes.brighter_color(scene)
    assert [light.intensity for light in changed.lights] == [2, 3, 1]
    assert [light.color.tolist() for light in changed.lights] == [[2, 2, 2], [2, 1, 0.5], [0.5, 1, 2]]
    assert changed.settings.lights == scene.settings.lights


def test_lights_the_other_way_round(scene):
    changed = changes.lights_swapped(scene)
    assert [light.intensity for light in changed.lights] == [2, 6, 4]
    assert [light.intensity for light in changed.settings.lights] == [2, 6, 4]


@pytest.mark.parametrize(("before", "intensities", "black"), [(True, [4, 4, 6, 2], 0), (False, [4, 6, 2, 4], 3)])
def test_a_black_light_at_the_place_of_the_first(scene, before, intensities, black):
    changed = changes.with_black_light(scene, before)
    for lights in (changed.lights, changed.settings.lights):
        assert [light.intensity for light in lights] == intensities
    assert [light.color.tolist() == [0, 0, 0] for light in changed.lights] == [number == black for number in range(4)]
    assert changed.lights[black].position.tolist() == scene.lights[0].position.tolist()
    assert [light.intensity for light in scene.lights] == [4, 6, 2], "the scene itself stays"


def test_no_body_has_ambient_light(scene):
    changed = changes.without_ambient(scene).settings
    assert (changed.phong.ambient, changed.layers[0].phong.ambient) == (0, 0)
    assert changed.phong.diffuse == scene.settings.phong.diffuse


def test_vertices_in_another_order_make_the_same_triangles(scene):
    changed = changes.vertices_reordered(scene)
    for before, after in ((scene.mesh, changed.mesh), (scene.inner_mesh, changed.inner_mesh)):
        assert not np.array_equal(after.triangles, before.triangles)
        for name in ("positions", "normals"):
            corners = [getattr(mesh, name)[mesh.triangles].tobytes() for mesh in (before, after)]
            assert corners[0] == corners[1]
    before, after = scene.inner_mesh, changed.inner_mesh
    assert after.uvs[after.triangles].tobytes() == before.uvs[before.triangles].tobytes()
    assert scene.mesh.uvs is changed.mesh.uvs is None


def test_without_a_layer_there_is_none_to_reorder(path):
    assert changes.vertices_reordered(load_scene(around(path, 16))).inner_mesh is None


def test_every_length_is_doubled(scene):
    """A light that falls off by the square is four times as strong; an angle stays, the height of parallel rays not."""
    changed = changes.twice_as_large(scene)
    assert (changed.settings.shadow_map.bias_abs, changed.settings.mm_per_unit) == (0.02, 2)
    assert changed.world_from_model.tolist() == (np.diag([2, 2, 2, 1]) @ scene.world_from_model).tolist()
    assert seen(changed.camera) == [2, 4, 10, 0, 0, 2, 4, 18] and changed.camera.lens == Orthographic(6)
    assert [light.intensity for light in changed.lights] == [4, 24, 2]
    for before, after in zip(scene.lights, changed.lights, strict=True):
        assert seen(after.view) == [2 * each for each in seen(before.view)]
        assert after.position.tolist() == (2 * before.position).tolist()
        fitted = before.view.lens
        assert after.view.lens == (fitted if isinstance(fitted, Perspective) else Orthographic(2 * fitted.view_height))


def test_a_picture_grows_to_the_right_and_upwards(scene):
    changed = changes.larger_picture(scene, 3, 7).settings.camera
    assert (changed.width, changed.height) == (23, 37) and changed.view_height == 3
