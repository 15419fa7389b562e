"""The separable blur, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.passes.separable_blur import scatter_columns, scatter_rows

# Three pixels in a row, at depths 0, 1 and 5; the kernel reaches 2 units.
LIT = np.repeat(np.float32([[8, 2, 4]])[..., None], 3, axis=2)
POSITIONS = np.float32([[[0, 0, 0], [0, 0, -1], [0, 0, -5]]])
COVERAGE = np.uint8([[1, 1, 1]])
KERNEL = {
    "kernel_place": np.float32([-1, 0, 1]),
    "kernel_weight": np.float32([[0.25, 0.5, 0], [0.5, 0.5, 1], [0.25, 0, 0]]),
    "kernel_count": 3,
}
ROW = {"position_world": POSITIONS, "coverage": COVERAGE, "pixel": (1, 0), "ahead": (0, 0, -0.5), **KERNEL}


def on_end(pictures):
    return {name: np.swapaxes(value, 0, 1) if np.ndim(value) > 1 and name != "kernel_weight" else value
            for name, value in pictures.items()}  # fmt: skip


def test_scatter_rows():
    # On the left half of its own 8 and half of the pixel's 2: 5, for it lies half the reach before; on the right 2.
    # Red .25*5 + .5*2 + .25*2, green .5*5 + .5*2.
    assert call(scatter_rows, lit=LIT, pixels_per_offset=1, **ROW) == ((2.75, 3.5, 2),)
    # At half a pixel: half of what each of both pixels has, so 3.5 on the left and 2 on the right.
    assert call(scatter_rows, lit=LIT, pixels_per_offset=0.5, **ROW) == ((2.375, 2.75, 2),)
    # What the model does not cover counts as the pixel itself.
    bare = {**ROW, "coverage": np.uint8([[0, 1, 1]])}
    assert call(scatter_rows, lit=LIT, pixels_per_offset=1, **bare) == ((2, 2, 2),)


def test_scatter_columns():
    column = on_end({**ROW, "scattered_rows": LIT}) | {"pixel": (0, 1)}
    assert call(scatter_columns, pixels_per_offset=1, **column) == ((2.75, 3.5, 2),)
    assert call(scatter_columns, pixels_per_offset=0.5, **column) == ((2.375, 2.75, 2),)


def test_each_stage_keeps_to_its_axis():
    row = {**ROW, "lit": LIT, "pixels_per_offset": 1}
    assert call(scatter_rows, **on_end(row) | {"pixel": (0, 1)}) == ((2, 2, 2),)
    column = {**ROW, "scattered_rows": LIT, "pixels_per_offset": 1}
    assert call(scatter_columns, **column) == ((2, 2, 2),)
