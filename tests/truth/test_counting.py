"""Which ring light falls into."""

import numpy as np
import pytest

from sss_ref.truth.counting import ring


@pytest.mark.parametrize(("square", "expected"), [(0.0, 0), (1.0, 0), (1.1, 1), (4.0, 1), (9.0, 2), (9.1, 3), (1e9, 3)])
def test_a_ring_ends_with_its_radius(square, expected):
    assert ring(np.array([1.0, 4.0, 9.0]), square) == expected
