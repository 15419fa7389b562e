"""Whether a view sees anything, at the borders of what it sees: a vertex on one is seen."""

import numpy as np
import pytest
from bodies import body
from scenes import settings_with

from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.unseen import framing, turned, unseen, written
from sss_ref.view.lenses import Orthographic, Perspective
from sss_ref.view.light_fit import MARGIN, Bounds
from sss_ref.view.views import View

TABLE = settings_with({}).camera  # an orbit camera: what mends it is its target
FREE = settings_with({"camera": {"type": "free", "position": [0, 0, 0]}}).camera
WIDE, TALL = (256, 128), (128, 256)
PERSPECTIVE = Perspective(90.0)


def view(size=WIDE, near=0.125, far=16.0, lens=PERSPECTIVE):
    """From the origin along -Z, up is +Y; by 90 degrees half of what is seen is as high as far away."""
    return View("camera", np.zeros(3), np.array([0, 0, -1.0]), np.array([0, 1.0, 0]), lens, near, far, *size)


def told(points, given=None):
    return unseen(given or view(), PlacedMesh(body(points), np.eye(4)), "camera", TABLE)


def across(ahead, x=0.5, y=0.25):
    """A triangle at a distance."""
    return [(-x, -y, -ahead), (x, -y, -ahead), (x, y, -ahead)]


def test_behind():
    """One vertex beside the eye is not ahead of it; a little further, it is."""
    behind = "the whole mesh is behind it; set camera.target = [0.5, 0, 1]"
    assert told([(0, 0, 0), (1, 0, 2), (0, 0, 1)]) == behind
    assert told([(0, 0, -0.5), (1, 0, 2), (0, 0, 1)]) == ""


def test_beyond_far():
    assert told(across(16, x=4)) == ""
    assert (
        told([*across(17, x=4)[:2], (0, 4, -20)])
        == "the whole mesh lies beyond far = 16, from 17 on; set camera.far = 22"
    )


def test_before_near():
    """Nine tenths of the nearest, but never less than a thousandth of the farthest."""
    near = view(near=1.0)
    assert told(across(1), near) == ""
    before = "the whole mesh lies before near = 1, up to 0.5; set camera.near = "
    assert told([*across(0.25)[:2], (0, 0, -0.5)], near) == f"{before}0.225"
    assert told([(0, 0, 3), (0.1, 0, -0.1), (0, 0, -0.5)], near) == f"{before}0.0005"
    assert told([(0, 0, 3), (0.1, 0, -0.1), (0, 0, -0.998)], near).endswith(", up to 0.998; set camera.near = 0.000998")


@pytest.mark.parametrize("lens", [PERSPECTIVE, Orthographic(16.0)])
@pytest.mark.parametrize(("way", "limit"), [((1, 0), 16), ((-1, 0), 16), ((0, 1), 8), ((0, -1), 8)])
def test_beside(way, limit, lens):
    """At distance 8 half of the picture is 8 high and 16 wide."""
    x, y = way

    def at(place):
        return [(x * place + y * k, y * place + x * k, -8) for k in (-1, 0, 1)]

    assert told(at(limit), view(lens=lens)) == ""
    centre = written(np.array([x, y, 0]) * (limit + 1) + (0, 0, -8.0))
    beside = f"the whole mesh is beside its picture; set camera.target = {centre}"
    assert told(at(limit + 1), view(lens=lens)) == beside
    assert told([*at(limit + 1), at(limit - 1)[0]], view(lens=lens)) == ""


@pytest.mark.parametrize("far", [3.0, 40.0])
@pytest.mark.parametrize("turn", [False, True])
def test_a_few_pixels(turn, far):
    """At distance 2 the picture is 8 wide or, upright, 4 high: 4 of 256 pixels are 1/8 or 1/16 of a unit."""
    pixels = view(TALL if turn else WIDE, far=far, near=1.0)

    def seen(length):
        points = [(-length / 2, 0, -2), (length / 2, 0, -2), (0, length / 8, -2)]
        return told([(y, x, z) for x, y, z in points] if turn else points, pixels)

    long = 0.0625 if turn else 0.125
    assert seen(long) == ""
    size = "128 x 256" if turn else "256 x 128"
    assert seen(long * 0.9).startswith(f"the mesh is 3.6 of its {size} pixels wide; set camera.fov_y = ")


def test_a_share_of_a_small_picture_is_enough():
    """Of 20 x 10 pixels a tenth of the width is two of them."""
    small = view((20, 10), near=1.0)
    assert told(across(2, x=0.41, y=0.01), small) == ""
    assert told(across(2, x=0.39, y=0.01), small).startswith("the mesh is 1.9 of its 20 x 10 pixels wide; ")
    assert told(across(2, x=0.01, y=0.21), small) == ""
    assert told(across(2, x=0.01, y=0.19), small).startswith("the mesh is 0.95 of its 20 x 10 pixels wide; ")


def test_a_tenth_of_the_picture_is_not_small():
    """At distance 2.5 the picture is 10 wide: a mesh of 1 is a tenth of it, two pixels."""
    assert told([(0, 0, -2.5), (1, 0, -2.5), (0, 0.125, -2.5)], view((20, 10), near=1.0)) == ""


def test_a_mesh_beside_the_eye_is_not_said_to_be_small():
    """Parallel rays show it small as well, but it may be cut off by near."""
    small = [(0, 0, 0), (0.001, 0, -1), (0, 0.001, -1)]
    parallel = view(lens=Orthographic(16.0))
    assert told(small, parallel) == ""
    assert told([(x, y, z - 0.25) for x, y, z in small], parallel).startswith("the mesh is 0.008 of its 256 x 128 ")


def test_a_mesh_around_the_eye_is_not_said_to_be_small():
    assert told([(0, 0, 1), (0.001, 0, -1), (0, 0.001, -1)]) == ""
    assert told([(-0.001, 0, -0.5), (0.001, 0, -0.5), (0, 0.001, -0.5)]).startswith("the mesh is 0.26 of its ")


BALL = Bounds(np.array([-1.0, -1, -1]), np.array([1.0, 1, 1]), np.array([0, 0, 3.0]), 1 / MARGIN)


@pytest.mark.parametrize(("size", "taller"), [(WIDE, 1), ((64, 64), 1), (TALL, 2)])
def test_what_frames_a_sphere(size, taller):
    """One of radius 1 that is 2 away fills twice asin(1/2), 60 degrees; one around the eye half of all."""
    eye = view(size)
    assert framing(eye, BALL) == f"fov_y = {38.94 * taller:.3g}"  # 2*asin(1/3)
    nearer = Bounds(BALL.low, BALL.high, np.array([0, 2.0, 0]), 1 / MARGIN)
    assert framing(eye, nearer) == f"fov_y = {60 * taller}"
    around = Bounds(BALL.low, BALL.high, np.array([0, 0, 0.5]), 1 / MARGIN)
    assert framing(eye, around) == f"fov_y = {180 * taller}"
    larger = Bounds(BALL.low, BALL.high, nearer.centre, 4 / MARGIN)
    assert framing(view(size, lens=Orthographic(9.0)), larger) == f"view_height = {8 * taller}"
    elsewhere = View("camera", np.array([0, 1.0, 5]), np.zeros(3), np.array([0, 1.0, 0]), PERSPECTIVE, 1, 16, *size)
    assert (
        framing(elsewhere, Bounds(BALL.low, BALL.high, np.array([0, 1.0, 3]), 1 / MARGIN)) == f"fov_y = {60 * taller}"
    )


def test_a_free_camera_is_turned_by_its_angles():
    """To (3, 5, 4) from the origin: yaw -143.1 is atan2(-3, -4), pitch 45 for 5 up on a way of 5."""
    towards = Bounds(BALL.low, BALL.high, np.array([3.0, 5, 4]), 1.0)
    assert turned(view(), towards, "camera", FREE) == "camera.yaw = -143 and camera.pitch = 45"
    assert turned(view(), towards, "lights.1", TABLE) == "lights.1.target = [3, 5, 4]"
    moved = View(
        "camera", np.array([3.0, 9, 4]), *(getattr(view(), name) for name in ("target", "up", "lens")), 1, 2, 4, 4
    )
    assert turned(moved, Bounds(BALL.low, BALL.high, np.array([0.0, 4, 0]), 1.0), "camera", FREE) == (
        "camera.yaw = 36.9 and camera.pitch = -45"
    )
