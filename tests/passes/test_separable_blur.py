"""The separable blur, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.passes.separable_blur import scatter_along

# Three pixels in a row, at depths 0, 1 and 5; the kernel reaches 2 units.
LIT = np.repeat(np.float32([[8, 2, 4]])[..., None], 3, axis=2)
POSITIONS = np.float32([[[0, 0, 0], [0, 0, -1], [0, 0, -5]]])
COVERAGE = np.uint8([[1, 1, 1]])
ROW = {
    "kernel_offset": np.float32([[-1, 0], [0, 0], [1, 0]]),
    "kernel_weight": np.float32([[0.25, 0.5, 0], [0.5, 0.5, 1], [0.25, 0, 0]]),
    "kernel_count": 3,
    "lit": LIT,
    "position_world": POSITIONS,
    "coverage": COVERAGE,
    "pixel": (1, 0),
    "ahead": (0, 0, -0.5),
}


def test_scatter_along():
    # On the left half of its own 8 and half of the pixel's 2: 5, for it lies half the reach before; on the right 2.
    # Red .25*5 + .5*2 + .25*2, green .5*5 + .5*2.
    assert call(scatter_along, pixels_per_offset=1, **ROW) == ((2.75, 3.5, 2),)
    # At half a pixel: half of what each of both pixels has, so 3.5 on the left and 2 on the right.
    assert call(scatter_along, pixels_per_offset=0.5, **ROW) == ((2.375, 2.75, 2),)
    # What the model does not cover counts as the pixel itself.
    bare = {**ROW, "coverage": np.uint8([[0, 1, 1]])}
    assert call(scatter_along, pixels_per_offset=1, **bare) == ((2, 2, 2),)


def test_between_four_pixels():
    """Half-way to the neighbour on the diagonal: a quarter of each of four; what is off the model has the pixel's 8."""
    four = np.pad(np.float32([[8, 4], [2, 6]]), 1, constant_values=1000)
    square = {"lit": np.repeat(four[..., None], 3, axis=2), "position_world": np.zeros((4, 4, 3), np.float32)}
    kernel = {"kernel_offset": np.float32([[0.5, 0.5]]), "kernel_weight": np.float32([[1, 1, 1]]), "kernel_count": 1}
    for beside, expected in ((None, 5), ((1, 2), 6), ((2, 1), 6.5), ((2, 2), 5.5)):
        covered = np.ones((4, 4), np.uint8)
        if beside:
            covered[beside] = 0
        inputs = {**ROW, **square, **kernel, "coverage": covered, "pixel": (1, 1)}
        assert call(scatter_along, pixels_per_offset=1, **inputs) == ((expected,) * 3,)


def test_the_other_axis():
    upright = {name: np.swapaxes(ROW[name], 0, 1) for name in ("lit", "position_world", "coverage")}
    column = {**ROW, **upright, "pixel": (0, 1), "kernel_offset": ROW["kernel_offset"][:, ::-1]}
    assert call(scatter_along, pixels_per_offset=1, **column) == ((2.75, 3.5, 2),)
    across = {**column, "kernel_offset": ROW["kernel_offset"]}
    assert call(scatter_along, pixels_per_offset=1, **across) == ((2, 2, 2),)
