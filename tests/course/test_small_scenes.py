"""The course's scenes take any mesh, and put it where the shipped head stands."""

import numpy as np
import pytest
from scenes import cube, written

import sss_ref
from sss_ref.course import small_scenes
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.scene_file.shipped import find_mesh
from sss_ref.view.light_fit import Bounds


def bounds(scene):
    corners = np.c_[scene.mesh.positions, np.ones(len(scene.mesh.positions))]
    return Bounds.around(corners @ np.asarray(scene.world_from_model)[:3].T)


def test_the_shipped_head_is_left_as_it_is():
    scene, shipped = small_scenes.load("figure3_with", "bust"), sss_ref.load_scene("figure3_with")
    assert np.array_equal(scene.world_from_model, shipped.world_from_model)


@pytest.mark.parametrize("head", ["molar_enamel", "own"])
def test_another_head_gets_its_bounds(head, tmp_path):
    if head == "own":
        pytest.importorskip("xatlas")  # it has no UVs
    path = written(tmp_path / "own.obj", cube()[0] * 150 + 40, cube()[1]) if head == "own" else head
    own, model = bounds(small_scenes.load("figure3_with", path)), bounds(small_scenes.load("figure3_with", "bust"))
    assert np.isclose(own.radius, model.radius)
    assert np.allclose(own.centre, model.centre, atol=1e-6)


def test_a_head_without_uvs_gets_some(tmp_path):
    pytest.importorskip("xatlas")
    scene = small_scenes.load("figure5", written(tmp_path / "own.obj", *cube()))
    assert scene.mesh.uvs is not None


def test_a_missing_head_is_named():
    with pytest.raises(sss_ref.MeshError, match=r"HEAD: expected a mesh file .* got 'nobody\.obj'"):
        small_scenes.load("figure5", "nobody.obj")


def test_sizes_can_be_overridden():
    scene = small_scenes.load("figure5", size=64, **{"shadow_map.width": 32})
    assert (scene.settings.camera.width, scene.settings.shadow_map.width, scene.settings.shadow_map.height) == (
        64,
        32,
        128,
    )


def test_a_lessons_scene_is_384_pixels_wide_with_a_map_of_twice_that():
    settings = small_scenes.load("figure5").settings
    assert (settings.camera.width, settings.camera.height) == (384, 384)
    assert (settings.shadow_map.width, settings.shadow_map.height) == (768, 768)


def test_where_another_head_is_put(tmp_path):
    """Beside the origin and twice as large as it has to be: half of it, moved back."""
    points, triangles = cube()
    model = Bounds.around(load_mesh(find_mesh("bust", tmp_path)).positions.astype(float))
    own = Bounds.around(points)
    path = written(tmp_path / "own.obj", points * 2 + [3, 0, 0], triangles)
    found = small_scenes.placed(path)
    scale = model.radius / own.radius / 2
    assert found["mesh.scale"] == pytest.approx(scale, rel=1e-6)
    assert found["mesh.translate"] == pytest.approx(
        (model.centre - (own.centre * 2 + [3, 0, 0]) * scale).tolist(), abs=1e-6
    )
    assert found["mesh.path"] == str(path) and found["mesh.unwrap"]
    assert (
        small_scenes.placed("bust") == {"mesh.path": "bust"} and not small_scenes.placed("molar_enamel")["mesh.unwrap"]
    )
