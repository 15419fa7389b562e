"""Candidates in the order of their pixels."""

import numpy as np

from sss_ref.validation.accept.rasterizer.candidates import by_pixel


def test_candidates_of_a_pixel_lie_side_by_side_each_as_it_came() -> None:
    pixel = np.random.default_rng(5).integers(0, 40, 300)
    np.testing.assert_array_equal(by_pixel(pixel, 40), np.argsort(pixel, kind="stable"))
    assert len(by_pixel(pixel[:0], 40)) == 0
