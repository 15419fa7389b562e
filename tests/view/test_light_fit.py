import math

import numpy as np
import pytest

from sss_ref.errors import SceneError
from sss_ref.scene_file.viewpoints import DirectionalLight, PointLight
from sss_ref.view.light_fit import Bounds, field_of_view, fitted, placed

# A box from (-1, -1, -1) to (1, 1, 3): centre (0, 0, 1), and the farthest vertex is 2 away.
POINTS = np.array([[-1, 0, 1], [1, 0, 1], [0, -1, 1], [0, 1, 1], [0, 0, 3], [0, 0, -1.0]])
BOUNDS = Bounds.around(POINTS)
K = 1.05 * 2


def test_bounds_are_around_the_boxes_middle():
    assert np.array_equal(BOUNDS.centre, [0, 0, 1]) and BOUNDS.radius == 2
    for corner in ([1, 1, 3.0], [-1, -1, -1.0]):
        assert BOUNDS.holds(np.array(corner)) and not BOUNDS.holds(np.nextafter(corner, np.multiply(corner, 9)))


def test_a_radius_is_a_length_in_space():
    """Farthest from the middle of the box, (1, 1, 1), is (4, 5, 13): by (3, 4, 12), which is 13 long."""
    assert Bounds.around(np.float64([[4, 5, 13], [-2, -3, -11], [0, 1, 13]])).radius == 13


def test_fit_from_outside():
    light = fitted(PointLight(position=(0, 0, 11)), BOUNDS, 1.0)
    assert light.target == (0, 0, 1)
    assert (light.near, light.far) == (10 - K, 10 + K)
    assert light.fov_y == pytest.approx(2 * math.degrees(math.asin(K / 10)), rel=1e-15)


def test_near_is_never_below_a_thousandth_of_the_distance():
    q = np.nextafter(K, 3)
    light = fitted(PointLight(position=(0, 0, 1 + q)), BOUNDS, 1.0)
    assert light.near == (1 + q - 1) / 1000


def test_given_values_stay():
    light = PointLight(position=(0, 0, 11), target=(0, 0, 5), fov_y=20, near=0.5, far=50)
    assert fitted(light, BOUNDS, 1.0) == light
    partly = fitted(PointLight(position=(0, 0, 11), near=0.5), BOUNDS, 1.0)
    assert (partly.near, partly.far) == (0.5, 10 + K)


def test_field_of_view_by_hand():
    # asin(1/2) = 30 degrees; a target 45 degrees off adds 45; a map half as wide as high doubles the tangent.
    ahead, beside = np.array([0, 0, -2.0]), np.array([-1, 0, -1.0])
    assert field_of_view(ahead, ahead, 1.0, 1.0) == 60
    assert field_of_view(ahead, ahead, 1.0, 1.5) == field_of_view(ahead, ahead, 1.0, 7.0) == 60
    assert field_of_view(ahead, beside, 1.0, 1.0) == 150
    assert field_of_view(np.array([0, 0, -math.sqrt(2)]), ahead, 1.0, 0.5) == pytest.approx(
        2 * math.degrees(math.atan(2)), rel=1e-15
    )


@pytest.mark.parametrize("seed", range(9))
def test_field_of_view_between_any_two_directions(seed):
    """The angle by its cosine, where it is not small; every component counts."""
    to_centre, aside = np.random.default_rng(seed).normal(size=(2, 3))
    to_target = to_centre + 0.5 * aside * (np.linalg.norm(to_centre) / np.linalg.norm(aside))
    norms = np.linalg.norm(to_centre), np.linalg.norm(to_target)
    angle = math.acos(float(to_centre @ to_target) / float(norms[0] * norms[1]))
    half = math.asin(0.1) + angle
    assert field_of_view(to_centre, to_target, 0.1 * float(norms[0]), 2.0) == pytest.approx(
        2 * math.degrees(half), rel=1e-9
    )


def test_half_a_circle_is_too_much():
    ahead = np.array([0, 0, -2.0])
    assert field_of_view(ahead, ahead, np.nextafter(2.0, 0), 1.0) < 180
    with pytest.raises(SceneError, match="field of view of 180 degrees"):
        field_of_view(ahead, ahead, 2.0, 1.0)


def test_a_light_just_at_the_sphere_is_too_close():
    around_zero = Bounds(np.float64([-1, -1, -1]), np.float64([1, 1, 1]), np.zeros(3), 2.0)
    with pytest.raises(SceneError, match=r"expected a light farther than 2.1 from the mesh's centre, got 2.1;"):
        fitted(PointLight(position=(0, 0, K)), around_zero, 1.0)


def test_light_too_close():
    with pytest.raises(SceneError) as error:
        fitted(PointLight(position=(0, 0, 3)), BOUNDS, 1.0)
    assert str(error.value) == (
        "expected a light farther than 2.1 from the mesh's centre, got 2; move it or give fov_y, near and far"
    )


def test_target_too_far_aside():
    with pytest.raises(SceneError) as error:
        fitted(PointLight(position=(0, 0, 11), target=(0, 5, 11)), BOUNDS, 1.0)
    assert str(error.value) == (
        "expected a target near the mesh, got one that needs a field of view of 204.245 degrees; "
        "move the target or give fov_y, near and far"
    )


def test_near_beyond_the_fitted_far():
    with pytest.raises(SceneError) as error:
        fitted(PointLight(position=(0, 0, 11), near=13), BOUNDS, 1.0)
    assert str(error.value) == "expected near < far, got near 13 and far 12.1 after fitting; give both or neither"
    with pytest.raises(SceneError, match=r"after fitting; move it closer"):
        fitted(PointLight(position=(0, 0, 1e30)), BOUNDS, 1.0)
    with pytest.raises(SceneError, match=r"expected near < far, got near 12.1 and far 12.1 "):
        fitted(PointLight(position=(0, 0, 11), near=10 + K), BOUNDS, 1.0)


def test_a_directional_light_is_fitted_along_its_rays():
    """The sphere's centre lies 12 before the plane and 5 beside the line of sight, (12, 5) being 13 away."""
    bounds = Bounds(np.float64([-1, -1, -1]), np.float64([1, 1, 1]), np.zeros(3), 2.0)
    given = {"type": "directional", "position": (5, 0, 12), "target": (5, 0, 0)}
    light = fitted(DirectionalLight(**given), bounds, 1.0)
    k = 1.05 * 2
    assert (light.near, light.far) == (12 - k, 12 + k)
    assert light.view_height == 2 * (k + 5)
    assert fitted(DirectionalLight(**given), bounds, 1.5).view_height == 2 * (k + 5)
    assert fitted(DirectionalLight(**given), bounds, 0.5).view_height == 4 * (k + 5)
    assert fitted(DirectionalLight(**given, near=2.0), bounds, 1.0).near == 2


def test_a_directional_light_whose_plane_cuts_the_mesh():
    bounds = Bounds(np.float64([-1, -1, -1]), np.float64([1, 1, 1]), np.zeros(3), 2.0)
    with pytest.raises(SceneError, match=r"expected a light farther than 2.1 .*, got 1; .* view_height, near and far"):
        fitted(DirectionalLight(type="directional", position=(9, 0, 1), target=(9, 0, 0)), bounds, 1.0)


@pytest.mark.parametrize(
    ("azimuth", "elevation", "position"),
    [(0, 0, (1, 2, 7)), (90, 0, (5, 2, 3)), (0, 90, (1, 6, 3)), (180, 0, (1, 2, -1))],
)
def test_a_place_on_the_orbit(azimuth, elevation, position):
    light = placed(PointLight(azimuth=azimuth, elevation=elevation, distance=4, target=(1, 2, 3)), BOUNDS)
    assert light.position == position
    assert (light.azimuth, light.elevation, light.distance) == (None, None, None)


def test_an_orbit_is_about_the_middle_of_the_mesh_and_a_direction_needs_no_distance():
    bounds = Bounds(np.float64([-1, -1, -1]), np.float64([1, 1, 1]), np.float64([0, 0, 1]), 2.0)
    assert placed(PointLight(azimuth=0, distance=4), bounds).position == (0, 0, 5)
    light = placed(DirectionalLight(type="directional", azimuth=0, target=(3, 0, 0)), bounds)
    assert light.position == (3, 0, 1 + 2 * 1.05 * 2)  # 2 k before the centre, along the rays
    behind = placed(DirectionalLight(type="directional", azimuth=0, target=(3, 0, 5)), bounds)
    assert behind.position == pytest.approx((3, 0, 1 + 2 * 1.05 * 2), rel=1e-15)  # wherever on the ray its target is
