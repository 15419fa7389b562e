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
