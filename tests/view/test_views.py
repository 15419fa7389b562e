import numpy as np
import pytest

from sss_ref.scene_file.settings import ShadowMap
from sss_ref.scene_file.viewpoints import FreeCamera, LookAtCamera, OrbitCamera, PointLight
from sss_ref.view.views import camera_view, free_target, light_of, orbit_eye


@pytest.mark.parametrize(
    "azimuth, elevation, expected",
    [(0, 0, (1, 2, 7)), (90, 0, (5, 2, 3)), (180, 0, (1, 2, -1)), (0, 90, (1, 6, 3)), (30, 0, (3, 2, 3 + 12**0.5))],
)
def test_orbit_eye(azimuth, elevation, expected):
    camera = OrbitCamera(type="orbit", target=(1, 2, 3), azimuth=azimuth, elevation=elevation, distance=4)
    assert tuple(orbit_eye(camera)) == expected


@pytest.mark.parametrize(
    "yaw, pitch, forward", [(0, 0, (0, 0, -1)), (90, 0, (-1, 0, 0)), (-90, 0, (1, 0, 0)), (0, 90, (0, 1, 0))]
)
def test_free_target(yaw, pitch, forward):
    camera = FreeCamera(type="free", position=(1, 2, 3), yaw=yaw, pitch=pitch)
    assert tuple(free_target(camera) - np.array([1, 2, 3])) == forward


def test_free_camera_looks_like_the_orbit_camera_of_the_same_angles():
    orbit = camera_view(OrbitCamera(type="orbit", azimuth=30, elevation=90, distance=1))
    free = camera_view(FreeCamera(type="free", position=tuple(orbit.eye.tolist()), yaw=30, pitch=-90))
    assert np.array_equal(orbit.view, free.view)


def test_a_view_looks_from_its_eye_to_its_target():
    camera = camera_view(LookAtCamera(type="look_at", eye=(3, 2, 0), target=(0, 2, 0)))
    assert camera.direction.tolist() == [-1, 0, 0]
    for each in (OrbitCamera(type="orbit", distance=2), FreeCamera(type="free", position=(0, 0, 2))):
        assert camera_view(each).direction.tolist() == [0, 0, -1]
        assert camera_view(each).up.tolist() == [0, 1, 0]


def test_clip_matrix_is_the_product_rounded_once():
    camera = LookAtCamera(type="look_at", eye=(3, 2, 0), target=(0, 2, 0), fov_y=90, near=1, far=3, width=4, height=2)
    world_from_model = np.diag([1.0, 1.0, 1.0, 1.0])
    world_from_model[2, 3] = 1 / 3
    clip = camera_view(camera).clip_from(world_from_model)
    # x = -.5 z, y = y - 2, z = -2 (x - 3) - 3, w = 3 - x, with z moved by 1/3.
    moved = np.float32(-0.5 * (1 / 3))
    assert np.array_equal(clip, np.array([[0, 0, -0.5, moved], [0, 1, 0, -2], [-2, 0, 0, 3], [-1, 0, 0, 3]], "f4"))
    assert clip.dtype == np.float32


def test_light_has_the_view_of_its_map():
    light = PointLight(position=(0, 0, 2), target=(0, 0, 0), fov_y=90, near=1, far=3, color=(1, 0.5, 0), intensity=2)
    result = light_of(light, ShadowMap(width=8, height=4))
    assert (result.view.width, result.view.height, result.falloff, result.intensity) == (8, 4, "none", 2)
    assert np.array_equal(result.view.projection[:2, :2], [[0.5, 0], [0, 1]])
    assert np.array_equal(result.view.eye, [0, 0, 2]) and np.array_equal(result.color, [1, 0.5, 0])
    assert result.view.pixel_size == np.float32(0.5)
