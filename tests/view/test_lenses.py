"""How much of the world each lens shows."""

import numpy as np
import pytest

from sss_ref.view.lenses import Orthographic, Perspective


def test_half_of_what_a_perspective_shows_grows_with_the_distance():
    """The tangent of half of 90 degrees is 1."""
    assert Perspective(90).half_height(np.array([0.5, 3.0])) == pytest.approx([0.5, 3], rel=1e-15)


def test_half_of_what_parallel_rays_show_is_the_same_at_every_distance():
    assert Orthographic(3.0).half_height(np.array([0.5, 3.0])).tolist() == [1.5, 1.5]
    assert Orthographic(3.0).height_at_1 == 3.0


def test_a_perspective_of_a_right_angle_shows_twice_the_distance():
    assert Perspective(90).height_at_1 == pytest.approx(2, rel=1e-15)
