"""Cameras and lights that are dragged: where they go, and what cannot happen to them."""

import numpy as np
import pytest
from pydantic import TypeAdapter

from sss_ref.errors import SceneError
from sss_ref.scene_file.viewpoints import Camera
from sss_ref.view.light_fit import Bounds
from sss_ref.view.views import camera_view
from sss_ref.viewer import steering

CAMERAS = {
    "orbit": {"type": "orbit", "azimuth": 20.0, "elevation": 10.0, "distance": 5.0, "target": [0.1, 0.2, 0.3]},
    "look_at": {"type": "look_at", "eye": [1.0, 2.0, 4.0], "target": [0.0, 0.1, 0.0]},
    "free": {"type": "free", "position": [1.0, 2.0, 4.0], "yaw": 14.0, "pitch": -25.0},
    "orthographic": {"type": "orthographic", "eye": [1.0, 2.0, 4.0], "view_height": 3.0},
}
BALL = Bounds(*(np.full(3, x) for x in (-1.0, 1.0, 0.0)), radius=1.0)
TINY = 1e-5  # what six digits leave


def camera(kind, **changes):
    return TypeAdapter(Camera).validate_python({**CAMERAS[kind], **changes})


def changed(before, changes):
    table = changes if "type" in changes else {**before.model_dump(), **changes}
    return TypeAdapter(Camera).validate_python(table)


def seen(view, point):
    """Where in the picture a point is, in heights from the middle, to the right and upwards."""
    x, y, _, w = view.projection @ view.view @ np.array([*point, 1.0])
    return np.array([x / w * view.width / view.height, y / w]) / 2


@pytest.mark.parametrize("kind", ["orbit", "look_at", "orthographic"])
def test_turning_keeps_the_target_and_the_distance(kind):
    before = camera(kind)
    after = changed(before, steering.turned(before, 0.25, -0.1))
    one, two = camera_view(before), camera_view(after)
    assert np.allclose(one.target, two.target, atol=TINY)
    assert np.isclose(np.linalg.norm(one.eye - one.target), np.linalg.norm(two.eye - two.target), rtol=TINY)
    assert two.eye[1] > one.eye[1]  # dragged down, seen from above


def test_turning_half_a_height_is_a_quarter_turn_and_ends_below_the_zenith():
    before = camera("orbit")
    assert steering.turned(before, 0.5, 0.0) == {"azimuth": -70.0, "elevation": 10.0}
    assert steering.turned(before, 0.0, -5.0)["elevation"] == steering.STEEPEST
    assert steering.turned(camera("orbit", azimuth=170.0), -0.2, 0.0)["azimuth"] == -154.0


def test_one_that_flies_looks_where_the_pointer_goes():
    before = camera("free")
    after = changed(before, steering.turned(before, 0.1, 0.1))
    assert (after.yaw, after.pitch) == (5.0, -16.0) and after.position == before.position


@pytest.mark.parametrize("kind", CAMERAS)
def test_what_is_slid_follows_the_pointer(kind):
    before = camera(kind)
    after = changed(before, steering.slid(before, BALL, 0.2, 0.1))
    one, two = camera_view(before), camera_view(after)
    point = one.target if kind != "free" else one.eye + steering._reach(before, BALL) * one.direction
    np.testing.assert_allclose(seen(two, point) - seen(one, point), [0.2, 0.1], atol=1e-4)
    np.testing.assert_allclose(one.view[:3, :3], two.view[:3, :3], atol=1e-5)


@pytest.mark.parametrize("kind", CAMERAS)
def test_a_smaller_factor_shows_the_middle_larger(kind):
    before = camera(kind)
    after = changed(before, steering.zoomed(before, BALL, 0.5))
    one, two = camera_view(before), camera_view(after)
    ahead = one.target if kind != "free" else one.eye + 4 * one.direction
    beside = ahead + 0.05 * one.view[0, :3]
    assert np.linalg.norm(seen(two, beside) - seen(two, ahead)) > 1.5 * np.linalg.norm(
        seen(one, beside) - seen(one, ahead)
    )


def test_flying_goes_by_radii_and_begins_where_the_camera_was():
    before = camera("orbit")
    after = changed(before, steering.flown(before, BALL, (0.0, 0.0, 0.5)))
    one, two = camera_view(before), camera_view(after)
    assert after.type == "free"
    np.testing.assert_allclose(two.eye, one.eye + 0.5 * one.direction, atol=1e-4)
    np.testing.assert_allclose(two.direction, one.direction, atol=1e-5)


def test_one_without_perspective_does_not_fly():
    with pytest.raises(SceneError, match="fly: expected a camera with a perspective, got an orthographic one; "):
        steering.flown(camera("orthographic"), BALL, (0.0, 0.0, 0.5))


@pytest.mark.parametrize("kind", CAMERAS)
@pytest.mark.parametrize("other", CAMERAS)
def test_another_type_shows_the_same(kind, other):
    before = camera(kind)
    after = changed(before, steering.retyped(before, other, BALL))
    assert after.type == other and (after.width, after.near) == (before.width, before.near)
    one, two = camera_view(before), camera_view(after)
    middle = one.eye + steering._reach(before, BALL) * one.direction
    for point in (middle, middle + 0.3 * one.view[0, :3], middle + 0.3 * one.view[1, :3]):
        np.testing.assert_allclose(seen(one, point), seen(two, point), atol=1e-4)


def test_planes_give_way_to_the_mesh_and_never_come_back():
    assert steering.widened(camera("orbit", near=0.1, far=100.0), BALL) == {}
    assert steering.widened(camera("orbit", near=4.5, far=5.0), BALL) == {
        "near": pytest.approx(3.6, rel=0.1),
        "far": pytest.approx(6.6, rel=0.1),
    }
    inside = steering.widened(camera("free", position=[0.0, 0.0, 0.5], near=1.0), BALL)
    assert inside == {"near": steering.CLOSEST}


@pytest.mark.parametrize("kind", CAMERAS)
@pytest.mark.parametrize("position", [[1.0, 2.0, 4.0], [-0.5, 0.3, -3.0]], ids=["in front", "behind"])
def test_a_dragged_light_goes_with_its_handle_at_its_distance(kind, position):
    view = camera_view(camera(kind))
    position = np.array(position)
    before = steering.handle(position, view, BALL)
    moved = steering.light_moved((position, np.zeros(3)), view, BALL, (0.02, 0.01), before["behind"])
    after = steering.handle(np.array(moved), view, BALL)
    assert np.isclose(np.linalg.norm(moved), np.linalg.norm(position), rtol=1e-5)
    assert after["x"] > before["x"] and after["y"] < before["y"]
    assert before["behind"] == after["behind"] == (position[2] < 0)


def test_a_light_in_the_middle_and_one_behind_the_eye_have_no_handle():
    view = camera_view(camera("free", position=[0.0, 0.0, 0.5], yaw=0.0, pitch=0.0))
    assert steering.handle(np.zeros(3), view, BALL) is None
    assert steering.handle(np.array([0.0, 0.0, 9.0]), view, BALL) is None


# From (0, 0, 5) onto the middle of a ball of radius 1, with 90 degrees: there the picture is 10 units high.
AHEAD = {"type": "look_at", "eye": [0.0, 0.0, 5.0], "fov_y": 90.0, "width": 64, "height": 64}
FLIES = {"type": "free", "fov_y": 90.0, "width": 64, "height": 64}


def seeing(table):
    return TypeAdapter(Camera).validate_python(table)


def test_a_tenth_of_the_height_is_a_unit():
    assert steering.slid(seeing(AHEAD), BALL, 0.1, 0.2) == {"eye": [-1, -2, 5], "target": [-1, -2, 0]}
    flat = seeing({"type": "orthographic", "eye": [0.0, 0.0, 5.0], "view_height": 3.0})
    assert steering.slid(flat, BALL, 0.1, 0.2) == {"eye": [-0.3, -0.6, 5], "target": [-0.3, -0.6, 0]}


@pytest.mark.parametrize(
    ("z", "factor", "expected"),
    [
        (5.0, 0.5, 2.5),
        (5.0, 2.0, 10.0),
        (0.5, 0.5, 0.0),  # no nearer than a radius: half of that
        (-5.0, 0.5, -5.5),  # the mesh is behind
    ],
)
def test_one_that_flies_goes_a_share_of_the_way_to_the_mesh(z, factor, expected):
    found = steering.zoomed(seeing({**FLIES, "position": [0.0, 0.0, z]}), BALL, factor)
    assert found == {"position": [0, 0, pytest.approx(expected)]}


def test_zooming_of_the_others():
    assert steering.zoomed(seeing(AHEAD), BALL, 0.5) == {"eye": [0, 0, 2.5]}
    assert steering.zoomed(camera("orbit"), BALL, 0.5) == {"distance": 2.5}
    assert steering.zoomed(camera("orthographic"), BALL, 0.5) == {"view_height": 1.5}


def test_flying_is_to_the_right_upwards_and_ahead():
    flying = seeing({**FLIES, "position": [0.0, 0.0, 5.0]})
    assert steering.flown(flying, BALL, (1.0, 2.0, 3.0)) == {"position": [1, 2, 2]}


@pytest.mark.parametrize(("behind", "side"), [(False, 1), (True, -1)])
def test_a_light_turns_about_its_target_as_fast_as_its_handle_moves(behind, side):
    """The handle is 1.2 from the middle: 0.6 units of the picture are half a radian."""
    view, place = camera_view(seeing(AHEAD)), (np.array([0.0, 0, 3]), np.zeros(3))
    sine, cosine = 3 * np.sin(0.5), 3 * np.cos(0.5)
    right = steering.light_moved(place, view, BALL, (0.06, 0.0), behind)
    up = steering.light_moved(place, view, BALL, (0.0, 0.06), behind)
    assert right == pytest.approx([side * sine, 0, cosine], abs=TINY)
    assert up == pytest.approx([0, side * sine, cosine], abs=TINY)
    beside = place[0] + (7, 0, 0), place[1] + (7, 0, 0)
    assert steering.light_moved(beside, view, BALL, (0.06, 0.0), behind)[0] == pytest.approx(7 + side * sine, abs=TINY)


def test_without_perspective_a_light_turns_by_the_height_of_the_picture():
    """Of 3 units it is a fifth: 0.6, as above."""
    view = camera_view(camera("orthographic", eye=[0.0, 0.0, 9.0]))
    right = steering.light_moved((np.array([0.0, 0, 3]), np.zeros(3)), view, BALL, (0.2, 0.0), False)
    assert right == pytest.approx([3 * np.sin(0.5), 0, 3 * np.cos(0.5)], abs=TINY)


@pytest.mark.parametrize(
    ("position", "x", "y", "behind"),
    [
        ((0, 0, 3), 0.5, 0.5, False),
        ((3, 0, 0), 0.62, 0.5, True),
        ((0, 9, 0), 0.5, 0.38, True),
        ((0, 0, -1), 0.5, 0.5, True),
    ],
)
def test_where_a_handle_is(position, x, y, behind):
    """1.2 beside the middle is .24 of half the height; a light straight above is behind the ball's outline."""
    found = steering.handle(np.array(position, float), camera_view(seeing(AHEAD)), BALL)
    assert found == {"x": x, "y": y, "behind": behind}


def test_planes_are_a_tenth_off_the_mesh():
    """The ball reaches from 4 to 6."""
    assert steering.widened(seeing({**AHEAD, "near": 4.0, "far": 6.0}), BALL) == {}
    assert steering.widened(seeing({**AHEAD, "near": 4.01, "far": 5.99}), BALL) == {"near": 3.6, "far": 6.6}
    inside = seeing({**AHEAD, "eye": [0.0, 0.0, 0.5], "near": 1.0, "far": 1.2})
    assert steering.widened(inside, BALL) == {"near": 0.01, "far": 1.65}


def test_another_type_has_the_same_numbers():
    to_free = steering.retyped(seeing(AHEAD), "free", BALL)
    assert (to_free["position"], to_free["yaw"], to_free["pitch"], to_free["fov_y"]) == ([0, 0, 5], 0, 0, 90)
    to_flat = steering.retyped(seeing(AHEAD), "orthographic", BALL)
    assert (to_flat["eye"], to_flat["target"], to_flat["view_height"]) == ([0, 0, 5], [0, 0, 0], 10)
    flat = seeing({"type": "orthographic", "eye": [0.0, 0.0, 5.0], "view_height": 3.0})
    to_orbit = steering.retyped(flat, "orbit", BALL)
    assert to_orbit["fov_y"] == 30 and to_orbit["distance"] == pytest.approx(1.5 / np.tan(np.radians(15)), rel=1e-5)


@pytest.mark.parametrize(("degrees", "wrapped"), [(180.0, -180.0), (179.0, 179.0), (-180.0, -180.0), (541.0, -179.0)])
def test_angles_run_from_minus_180_on(degrees, wrapped):
    assert steering._wrapped(degrees) == wrapped


# The same world twice as large: angles stay, lengths are doubled.
TWICE = Bounds(*(np.full(3, x) for x in (-2.0, 2.0, 0.0)), radius=2.0)
ANGLES = {"azimuth", "elevation", "yaw", "pitch", "fov_y", "width", "height", "type"}
NEAR_CAMERAS = CAMERAS | {
    "inside": {"type": "free", "position": [0.1, 0.2, 0.3], "yaw": 14.0, "pitch": -25.0, "near": 0.5, "far": 0.6},
    "beyond": {"type": "free", "position": [0.1, 0.2, -4.0], "yaw": 14.0, "pitch": -25.0, "near": 0.5, "far": 0.6},
}


def doubled(table):
    return {
        key: value if key in ANGLES else [2 * each for each in value] if isinstance(value, list | tuple) else 2 * value
        for key, value in table.items()
    }


@pytest.mark.parametrize("kind", NEAR_CAMERAS)
@pytest.mark.parametrize(
    "move",
    [
        lambda one, ball: steering.turned(one, 0.2, 0.1),
        lambda one, ball: steering.slid(one, ball, 0.2, 0.1),
        lambda one, ball: steering.zoomed(one, ball, 0.7),
        lambda one, ball: steering.flown(one, ball, (0.1, 0.2, 0.3)) if one.type != "orthographic" else {},
        lambda one, ball: steering.widened(one, ball),
        *(lambda one, ball, kind=kind: steering.retyped(one, kind, ball) for kind in CAMERAS),
    ],
    ids=["turned", "slid", "zoomed", "flown", "widened", *(f"retyped to {kind}" for kind in CAMERAS)],
)
def test_in_a_world_twice_as_large_all_ways_are_twice_as_long(kind, move):
    one = seeing(NEAR_CAMERAS[kind])
    other = seeing(doubled(one.model_dump()))
    small, large = move(one, BALL), move(other, TWICE)
    assert small.keys() == large.keys()
    for key, value in doubled(small).items():
        assert large[key] == pytest.approx(value, rel=2e-5, abs=1e-9) if key != "type" else large[key] == value


@pytest.mark.parametrize("kind", NEAR_CAMERAS)
@pytest.mark.parametrize("behind", [False, True])
def test_lights_too(kind, behind):
    one, place = seeing(NEAR_CAMERAS[kind]), np.array([[1.0, 2.0, 3.0], [0.1, 0.0, 0.2]])
    views = camera_view(one), camera_view(seeing(doubled(one.model_dump())))
    small, large = (
        steering.light_moved(tuple(place * size), view, ball, (0.01, 0.02), behind)
        for size, view, ball in zip((1, 2), views, (BALL, TWICE), strict=True)
    )
    assert large == pytest.approx([2 * each for each in small], rel=2e-5)
    assert small != [1.0, 2.0, 3.0]
    handles = (
        steering.handle(place[0] * size, view, ball)
        for size, view, ball in zip((1, 2), views, (BALL, TWICE), strict=True)
    )
    assert next(handles) == next(handles)


def test_a_light_seen_from_behind_the_mesh_hardly_moves():
    """The picture is as high there as a hundredth of the radius away, of the height of 2 at a distance of 1."""
    away = seeing({**FLIES, "position": [0.0, 0.0, -5.0]})  # it looks along -Z
    moved = steering.light_moved((np.array([0.0, 0, 3]), np.zeros(3)), camera_view(away), BALL, (0.6, 0.0), False)
    assert moved == pytest.approx([3 * np.sin(0.01), 0, 3 * np.cos(0.01)], abs=TINY)


def test_how_steep_a_camera_may_look():
    assert steering.turned(camera("orbit"), 0.0, -5.0)["elevation"] == 89
    assert steering.turned(camera("orbit"), 0.0, 5.0)["elevation"] == -89
    assert steering.turned(camera("free"), 0.0, 5.0)["pitch"] == 89
    assert steering.turned(camera("free"), 0.0, -5.0)["pitch"] == -89
    assert steering.turned(camera("free"), 3.0, 0.0)["yaw"] == 14.0 - 270 + 360
