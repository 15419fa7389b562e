import math

import numpy as np
import pytest

from sss_ref.dump.vectors import in_world, octahedral, unit_range
from sss_ref.view.lenses import Perspective
from sss_ref.view.views import View


def encoded(x, y, z):
    """A unit vector folded onto the octahedron, as shaders write it."""
    size = abs(x) + abs(y) + abs(z)
    u, v = x / size, y / size
    if z < 0:
        u, v = (1 - abs(v)) * math.copysign(1, u), (1 - abs(u)) * math.copysign(1, v)
    return u, v


@pytest.mark.parametrize(
    ("stored", "normal"),
    [
        ((0, 0), (0, 0, 1)),
        ((1, 0), (1, 0, 0)),
        ((0, -1), (0, -1, 0)),
        ((1, 1), (0, 0, -1)),
        ((-1, 1), (0, 0, -1)),
        ((0.5, 0.5), (0.70710678118, 0.70710678118, 0)),
        ((0.75, 0.75), (0.25 / math.sqrt(0.375), 0.25 / math.sqrt(0.375), -0.5 / math.sqrt(0.375))),
    ],
)
def test_octahedral_by_hand(stored, normal):
    assert octahedral(np.float32([[stored]])).tolist() == [[np.float32(normal).tolist()]]


def test_octahedral_undoes_what_shaders_do():
    vectors = np.random.default_rng(1).normal(size=(500, 3))
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    stored = np.float64([encoded(*vector) for vector in vectors])[np.newaxis]
    error = np.abs(octahedral(stored)[0] - vectors).max()
    assert error <= 2.0**-24  # half a unit in the last place of numbers below 1, and float64's own


def test_unit_range():
    values = unit_range(np.float32([[[0, 0.5, 1, 0.1, 128 / 255]]]))
    assert values.dtype == np.float32
    assert values[0, 0].tolist() == [-1, 0, 1, *np.float32(2 * np.float64(np.float32([0.1, 128 / 255])) - 1).tolist()]


def view(eye, target):
    return View(
        "camera", np.float64(eye), np.float64(target), np.float64([0, 1, 0]), Perspective(40.0), 0.1, 100.0, 4, 4
    )


def test_view_space_by_hand():
    # From (5, 2, 0) towards -X: to the right is -Z, up is +Y, and backward, the view's +Z, is +X.
    camera = view((5, 2, 0), (0, 2, 0))
    stored = np.float32([[[1, 2, -3], [0, 0, 0], [0, 0, 1]]])
    assert in_world(stored, camera, is_direction=False)[0].tolist() == [[2, 4, -1], [0, 0, 0], [6, 2, 0]]
    assert in_world(stored, camera, is_direction=True)[0].tolist() == [[-3, 2, -1], [0, 0, 0], [1, 0, 0]]


def test_view_space_undoes_the_view_matrix():
    camera = view((1.3, -2.1, 4.7), (0.2, 0.1, -0.3))
    points = np.random.default_rng(2).normal(size=(200, 3))
    stored = (camera.view[:3, :3] @ points.T).T + camera.view[:3, 3]
    found = in_world(stored[np.newaxis], camera, is_direction=False)[0]
    assert np.abs(found - points).max() <= 2.0**-23  # float32 of numbers below 4


@pytest.mark.filterwarnings("error")
def test_what_is_no_number_comes_through_without_a_warning():
    stored = np.float32([[[np.inf, np.nan], [3e38, -np.inf], [1, 0]]])
    assert np.isnan(octahedral(stored)[0, :2]).any(axis=-1).all() and octahedral(stored)[0, 2].tolist() == [1, 0, 0]
    assert unit_range(stored)[0, 0, 0] == np.inf and unit_range(stored)[0, 1, 0] == np.inf
    largest = np.full((1, 1, 3), np.finfo(np.float32).max)
    assert np.isinf(in_world(largest, view((1, 2, 3), (0, 0, 0)), is_direction=True)).any()


def test_nan_stays_where_it_is():
    found = in_world(np.float32([[[np.nan, 0, 0], [1, 0, 0]]]), view((0, 0, 5), (0, 0, 0)), is_direction=True)
    assert np.isnan(found[0, 0, 0]) and found[0, 1].tolist() == [1, 0, 0]
