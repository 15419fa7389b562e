"""The blur that stays on the surface, worked by hand."""

import numpy as np
from fragments import taps
from one_stage import call

from sss_ref.passes.blur import scatter_inside
from sss_ref.passes.blur_on_surface import scatter_inside_surface, scatter_on_surface

# Three pixels in a row, at depths 0, 1 and 5; the kernel reaches 2 units.
LIT = np.repeat(np.float32([[8, 2, 4]])[..., None], 3, axis=2)
COVERAGE = np.uint8([[1, 1, 1]])
POSITIONS = np.float32([[[0, 0, 0], [0, 0, -1], [0, 0, -5]]])
SCENE = {"lit": LIT, "position_world": POSITIONS, "pixel": (1, 0), "pixel_scale": 1, "ahead": (0, 0, -0.5)}
BOTH_SIDES = taps([(0, 0, 0.5, 0.5, 1), (-1, 0, 0.25, 0.5, 0), (1, 0, 0.25, 0.5, 1)])


def test_scatter_on_surface():
    # The right pixel is 4 units farther: it counts as the centre, 2.
    # Red .5*2 + .25*8 + .25*2, green .5*2 + .5*8 + .5*2.
    assert call(scatter_on_surface, **SCENE, coverage=COVERAGE, **BOTH_SIDES) == ((3.5, 6, 4),)
    # Where the model does not cover the left pixel, that too counts as the centre.
    assert call(scatter_on_surface, **SCENE, coverage=np.uint8([[0, 1, 1]]), **BOTH_SIDES) == ((2, 3, 4),)


def test_scatter_inside_surface():
    # The right pixel is left out. Red (.5*2 + .25*8)/.75, green (.5*2 + .5*8)*1.5/1, blue 1*2*2/1.
    assert call(scatter_inside_surface, **SCENE, coverage=COVERAGE, **BOTH_SIDES) == ((4, 7.5, 4),)


def test_a_tap_half_on_the_surface_counts_half():
    # Half way to the right pixel: red .5*2 + .5*(.5*2) = 1.5, of which .5 + .5*.5 of the weight 1 is kept.
    half = taps([(0, 0, 0.5, 0.5, 1), (0.5, 0, 0.5, 0.5, 0)])
    assert call(scatter_inside_surface, **SCENE, coverage=COVERAGE, **half) == ((2, 2, 2),)
    assert call(scatter_on_surface, **SCENE, coverage=COVERAGE, **half) == ((2, 2, 2),)


def test_before_and_behind_are_the_same():
    nearer = {**SCENE, "position_world": -POSITIONS}
    assert call(scatter_inside_surface, **nearer, coverage=COVERAGE, **BOTH_SIDES) == ((4, 7.5, 4),)


def test_a_flat_model_blurs_as_without_a_surface_to_follow():
    rng = np.random.default_rng(3)
    flat = {"lit": rng.random((9, 9, 3)).astype(np.float32), "coverage": np.ones((9, 9), np.uint8), "pixel": (4, 4)}
    kernel = {**taps([(*rng.uniform(-4, 4, 2), *rng.random(3)) for _ in range(7)]), "pixel_scale": 0.7}
    followed = {"position_world": np.zeros((9, 9, 3), np.float32), "ahead": (0, 0, 1)}
    assert call(scatter_inside_surface, **flat, **kernel, **followed) == call(scatter_inside, **flat, **kernel)
