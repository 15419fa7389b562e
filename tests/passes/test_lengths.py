"""Lengths in mm, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.language import vec2
from sss_ref.passes.lengths import offset_length, pixel_length, texel_length


def test_pixel_length():
    # At a depth of w = 3 a pixel of 1/8 at w = 1 spans 3/8 units, of 2 mm each.
    clip_from_world = np.float32([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1, 4]])
    lens = {"camera_clip_from_world": clip_from_world, "camera_pixel_size": 0.125, "mm_per_unit": 2}
    assert call(pixel_length, position_world=(7, 5, 1), **lens) == (0.75,)
    assert call(pixel_length, position_world=(7, 5, -2), **lens) == (1.5,)  # twice as far, twice as long


def test_texel_length():
    stretch = np.float32([[1, 2], [0.25, 0.5]])
    assert call(texel_length, triangle=1, triangle_stretch=stretch, mm_per_unit=10) == ((2.5, 5),)


def test_offset_length():
    assert call(offset_length, mm_per_pixel=0.5, mm_per_offset=2) == (4,)
    assert call(offset_length, mm_per_pixel=0, mm_per_offset=2) == (4096,)  # nothing is drawn there
    along_both = offset_length.retyped(mm_per_pixel=vec2, pixels_per_offset=vec2)
    assert call(along_both, mm_per_pixel=(0.5, 8), mm_per_offset=2) == ((4, 0.25),)
