"""What each technique reads of [diffusion], by the names of its uniforms, worked out by hand."""

import math

import numpy as np
import pytest
from bodies import body
from scenes import settings_with

from sss_ref.scene.spreading import curvatures_of, on_axes, spreading_of
from sss_ref.scene_file.diffusion import Diffusion

PROFILE = [[1.0, 1, 2, 0], [2.0, 3, 2, 1], [6.0, 4, 0, 3], [7.0, 0, 4, 0], [16.0, 0, 0, 0], [25.0, 0, 0, 4]]
STAYING = np.eye(4)


def spreading(method, **diffusion):
    return spreading_of(settings_with({"method": method, "diffusion": diffusion, "preset": "robust"}))


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_the_papers_methods_read_none(method):
    assert spreading(method) == {}


def test_places_on_a_line_lie_along_rows_or_columns():
    found = on_axes("tap", np.array([-1.0, 2.0, 0.5]))
    assert found["tap_rows"].tolist() == [[-1, 0], [2, 0], [0.5, 0]]
    assert found["tap_columns"].tolist() == [[0, -1], [0, 2], [0, 0.5]]
    assert len(found) == 2


def test_six_gaussians_are_blurred_one_after_the_other():
    """Variances add up: to go from 2 to 6 takes one of 4. Weights are shares of their channel's sum, 8."""
    found = spreading("gaussian_texture", profile=PROFILE)
    assert [float(found[f"spread_{letter}_mm"]) for letter in "abcdef"] == [1, 1, 2, 1, 3, 3]
    assert found["profile_variance"].tolist() == [1, 2, 6, 7, 16, 25]
    assert (8 * found["profile_weight"]).tolist() == [row[1:] for row in PROFILE]
    assert found["gaussian_rows"].tolist() == [[place, 0] for place in range(-3, 4)]
    assert found["gaussian_columns"].tolist() == [[0, place] for place in range(-3, 4)]
    taps = [float(np.float32(math.exp(-place * place / 2))) for place in range(-3, 4)]
    whole = 0.0
    for tap in taps:
        whole += tap
    assert found["spread_weight"].tolist() == [tap / whole for tap in taps]


def test_the_separable_kernel_has_its_own_reach():
    found = spreading("separable", taps=3, reach_mm=2.5)
    assert found["kernel_rows"].tolist() == [[-1, 0], [0, 0], [1, 0]] and found["reach_mm"] == 2.5
    assert found["kernel_columns"].tolist() == [[0, -1], [0, 0], [0, 1]]
    assert found["kernel_weight"].shape == (3, 3) and (found["kernel_weight"][1] > found["kernel_weight"][0]).all()


def test_samples_reach_as_far_as_the_last_one():
    found = spreading("burley", samples=5, albedo=[0.8] * 3, mean_free_path_mm=[1.05, 2.1, 4.2])
    assert found["scatter_distance"] == pytest.approx((1, 2, 4))
    assert (np.diff(found["sample_radius"]) > 0).all() and found["reach_mm"] == found["sample_radius"][4]
    assert found["sample_place"].shape == (5, 2) and found["sample_area"].shape == (5,)


def test_the_table_of_rings_ends_at_its_curvature():
    found = spreading("preintegrated", sharpest_curvature=0.25)
    assert found["sharpest_curvature"] == 0.25 and found["diffusion_table"].shape == (64, 64, 3)
    assert Diffusion().sharpest_curvature == 0.5


def test_only_preintegrated_skin_reads_curvatures():
    mesh = body([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    assert curvatures_of(settings_with({"method": "burley", "preset": "robust"}), STAYING, mesh) == {}
    found = curvatures_of(settings_with({"method": "preintegrated", "preset": "robust"}), STAYING, mesh)
    assert list(found) == ["triangle_curvature"]
    assert found["triangle_curvature"].shape == (1, 4) and found["triangle_curvature"].dtype == np.float32
    assert not found["triangle_curvature"].any(), "a plane is not bent"


@pytest.mark.parametrize("size", [1.0, 2.0])
def test_a_sphere_is_bent_by_one_over_its_radius(size):
    """Its normals turn as the mesh does: the corner of a mesh on the axes of a sphere, doubled and turned."""
    axes = np.eye(3)
    mesh = body(axes, [(0, 1, 2)])
    mesh.normals[:] = axes
    world = np.diag([size, size, size, 1.0])[[1, 2, 0, 3]]
    settings = settings_with({"method": "preintegrated", "preset": "robust"})
    found = curvatures_of(settings, world, mesh)["triangle_curvature"]
    straight = curvatures_of(settings, np.diag([size, size, size, 1.0]), mesh)["triangle_curvature"]
    np.testing.assert_allclose(np.sort(np.abs(found)), np.sort(np.abs(straight)), atol=1e-6)
    np.testing.assert_allclose(
        found[0, 3] * size, curvatures_of(settings, STAYING, mesh)["triangle_curvature"][0, 3], atol=1e-6
    )
