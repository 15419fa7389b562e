"""How much of the world each lens shows."""

import numpy as np
import pytest

from sss_ref.view.lenses import Perspective


def test_half_of_what_a_perspective_shows_grows_with_the_distance():
    """The tangent of half of 90 degrees is 1."""
    assert Perspective(90).half_height(np.array([0.5, 3.0])) == pytest.approx([0.5, 3], rel=1e-15)
