"""What is known of values at pixels."""

import numpy as np

from sss_ref.numerics.interval import Interval
from sss_ref.validation.accept.known import Known


def test_one_value_for_all_pixels_has_a_reach_at_each():
    """As of a stage that reads uniforms alone."""
    known = Known(np.float32(1), Interval(np.array([1.0, 0.5, 1.0]), np.array([1.0, 1.0, 3.0])))
    assert known.reach.tolist() == [[0.0], [0.5], [2.0]]
