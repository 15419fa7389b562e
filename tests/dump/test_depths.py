"""Distances brought to window depth, held against the projection matrix and against points whose distance is known."""

from fractions import Fraction

import numpy as np
import pytest

from sss_ref.dump.depths import ray_cosines, window_depth, window_loss
from sss_ref.dump.loss import LOSSES, ROUNDING, Loss
from sss_ref.view.lenses import Orthographic, Perspective
from sss_ref.view.views import View

VIEW = View("camera", np.zeros(3), np.array([0, 0, -1.0]), np.array([0, 1.0, 0]), Perspective(40.0), 0.5, 20.0, 6, 4)


def points(seed=1):
    """A point of view space through the centre of each pixel, float64 (4, 6, 3)."""
    z = np.random.default_rng(seed).uniform(0.6, 19, (4, 6))
    half = np.tan(np.radians(20)) * z
    x = (np.arange(6) + 0.5) / 3 - 1
    y = (np.arange(4) + 0.5) / 2 - 1
    return np.dstack([x[np.newaxis] * half * 1.5, y[:, np.newaxis] * half, -z])


def by_the_matrix(view_points):
    clip = np.dstack([view_points, np.ones((4, 6))]) @ VIEW.projection.T
    return clip[..., 2] / clip[..., 3] / 2 + 0.5


@pytest.mark.parametrize("kind", ["view", "ray", "ray_from_near"])
def test_every_kind_is_what_the_projection_gives(kind):
    at = points()
    to_near = at * (0.5 / -at[..., 2:])
    distance = {
        "view": -at[..., 2],
        "ray": np.linalg.norm(at, axis=-1),
        "ray_from_near": np.linalg.norm(at - to_near, axis=-1),
    }[kind]
    depth = window_depth(distance[..., np.newaxis], kind, VIEW)
    assert depth.dtype == np.float32
    assert np.abs(depth[..., 0] - by_the_matrix(at)).max() <= 2.0**-24 + 1e-12  # rounded once to float32


def test_by_hand():
    near_and_far = window_depth(np.full((4, 6, 1), [[[0.5]]] * 4), "view", VIEW)
    assert (near_and_far == 0).all()
    exact = float(Fraction(20) / Fraction(39, 2) * (1 - Fraction(1, 4)))
    assert (window_depth(np.full((4, 6, 1), 2.0), "view", VIEW) == np.float32(exact)).all()


@pytest.mark.parametrize("nothing", [1e10, np.inf, 20.0, 65504.0])
def test_what_lies_beyond_the_far_plane_is_nothing(nothing):
    assert (window_depth(np.full((4, 6, 1), nothing), "view", VIEW) == 1).all()


def test_rays_are_longest_in_the_corners():
    cosines = ray_cosines(VIEW)
    assert cosines[0, 0] == cosines[3, 5] < cosines[1, 2] < 1


@pytest.mark.parametrize(("kind", "dtype", "loss"), [("view", "f2", "float16"), ("ray", "f4", "float32")])
def test_the_loss_encloses_what_rounding_the_distance_does(kind, dtype, loss):
    for seed in range(20):
        at = points(seed)
        distance = (-at[..., 2] if kind == "view" else np.linalg.norm(at, axis=-1))[..., np.newaxis]
        stored = distance.astype(dtype).astype(np.float32)
        depth = window_depth(stored, kind, VIEW)
        least = window_loss(LOSSES.get(loss, Loss()), depth, VIEW).least
        assert np.abs(depth[..., 0] - by_the_matrix(at)).max() <= least
        assert least < (2e-3 if dtype == "f2" else 1e-6)


@pytest.mark.parametrize(
    ("depths", "z"), [([0.0, 0.5, 0.75, 1.0], 10 / 10.25), ([0.75, 0.9], 10 / 5.375), ([0.0, 1.0], 20.0)]
)
def test_the_nearest_that_is_drawn_loses_most(depths, z):
    """By the derivative f n / (f - n) / z^2 where f = 20 and n = 0.5; where nothing is drawn at the far plane."""
    depth, slope = np.float32([depths]), 10 / 19.5 / z**2
    assert window_loss(Loss(least=0.1), depth, VIEW).least == pytest.approx(slope * 0.1 + ROUNDING, rel=1e-12)
    moved = window_loss(Loss(relative=0.01), depth, VIEW).least
    assert moved == pytest.approx(slope * z * (0.01 + ROUNDING) + ROUNDING, rel=1e-12)


FLAT = View("camera", np.zeros(3), np.array([0, 0, -1.0]), np.array([0, 1.0, 0]), Orthographic(3.0), 0.5, 20.5, 6, 4)


@pytest.mark.parametrize(("kind", "distance"), [("view", 5.5), ("ray", 5.5), ("ray_from_near", 5.0)])
def test_parallel_rays_have_even_depths(kind, distance):
    depth = window_depth(np.full((4, 6, 1), distance), kind, FLAT)
    assert (depth == 0.25).all()  # 5 of 20 units behind the near plane


def test_a_loss_is_even_where_depths_are():
    """A step of .2 units is .01 of the 20 that the depth has; a share counts at the farthest that was drawn, 15.5."""
    depth = np.float32([[0.25, 0.75, 1.0]])
    assert window_loss(Loss(least=0.2), depth, FLAT).least == 0.2 / 20 + ROUNDING
    assert window_loss(Loss(relative=0.1), depth, FLAT).least == (0.1 + ROUNDING) * 15.5 / 20 + ROUNDING
