"""The stages of soft shadows, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.language import mat4
from sss_ref.passes.soft_shadow import (
    gloss_soft,
    irradiance_lambert_soft,
    light_visible_kernel,
    lit_multiply_soft,
    lit_transmit_soft,
    lit_transmit_wrapped_soft,
    map_direction,
)

# The map's four texels in a row cover x from -1 to 1, half a unit each. The point lies at the start of the third; its
# one neighbour on the kernel, an offset of 1, at the start of the fourth. Blue has no weights.
POINT = {"position_world": (0, 0, 0), "normal_world": (0, 0, 1), "light_position": (0, 0, 4)}
MAP = {"light_clip_from_world": np.eye(4, dtype=np.float32), "light_texel_size": 0.5, "lookup_inset": 1}
TAPS = {"tap_offset": np.float32([(0, 0), (1, 0)]), "tap_weight": np.float32([(1, 0.5, 0), (1, 1.5, 0)])}
KERNEL = {**TAPS, "tap_count": 2, "kernel_scale": 1, "bias_abs": 0.25, "bias_slope": 0}
SURFACE = np.int32([[0, 0, 0, 0]])


def visible(stored, surface=SURFACE, **given):
    distances = np.float32([[0, 0, *stored]])
    inputs = {**POINT, **MAP, **KERNEL, "light_distance": distances, "light_triangle": surface, **given}
    return call(light_visible_kernel, **inputs)


@pytest.mark.parametrize(
    ("stored", "expected"),
    [
        ((4, 4.1), (1, 1, 1)),
        ((4, 3), (0.5, 0.25, 1)),  # at the neighbour something stands before it
        ((3, 4.1), (0.5, 0.75, 1)),
        ((3, 3), (0, 0, 1)),
    ],
)
def test_light_visible_kernel(stored, expected):
    assert visible(stored) == (expected,)


def test_where_the_map_knows_nothing_light_is_seen_and_none_from_behind():
    assert visible((4, 3), np.int32([[0, 0, 0, -1]])) == ((1, 1, 1),)
    assert visible((3, 3), position_world=(3, 0, 0)) == ((1, 1, 1),)  # beside the map
    assert visible((4, 4.1), light_position=(0, 0, -4)) == ((0, 0, 0),)


def test_weights_below_0_leave_a_share_between_0_and_1():
    """Of red .5 in all, of green -1: of one tap alone 2 and -1 of it, of the other -1 and 2. Blue has none."""
    below_0 = {"tap_weight": np.float32([(1, 1, 0), (-0.5, -2, 0)])}
    assert visible((4, 3), **below_0) == ((1, 0, 1),)
    assert visible((3, 4.1), **below_0) == ((0, 1, 1),)


def test_light_along_the_surface_is_not_seen():
    assert visible((9, 9), normal_world=(1, 0, 0)) == ((0, 0, 0),)


def test_each_tap_has_a_bias_of_its_own():
    # Where light falls straight on it: at the point .5*1, at the neighbour .5*(1 + .125), of sqrt(16.25) = 4.031129.
    slope = {"bias_abs": 0, "bias_slope": 1}
    assert visible((3.5, 3.46863), **slope) == ((1, 1, 1),)
    assert visible((3.4999, 3.46862), **slope) == ((0, 0, 1),)


def test_the_kernel_lies_on_the_surface_in_texels_of_the_map():
    # Twice as far out the neighbour lies at the map's edge, beyond it from there on.
    assert visible((4, 3), kernel_scale=1.999) == ((0.5, 0.25, 1),)
    assert visible((4, 3), kernel_scale=2.001) == ((1, 1, 1),)
    # On a surface inclined by atan(3/4) it lies at x = .4, still in the third texel, and farther from the light.
    assert visible((3, 9), normal_world=(0.6, 0, 0.8), bias_abs=0) == ((0, 0, 1),)


def test_the_rows_of_a_map_run_along_the_first_three_numbers_of_its_first_row():
    """Where the light stands is in the fourth."""
    numbers = [(1, 2, 3, 4), (5, 6, 7, 8), (9, 10, 11, 12), (13, 14, 15, 16)]
    assert tuple(map_direction(mat4(numbers))) == (1, 2, 3)


def test_lit_multiply_soft():
    # (.5, 1, 2)*.25 where nothing is seen, (.5, 1, 2) where all is, half of both for green.
    inputs = {"phong": (0.5, 1, 2), "light_visible": (0, 0.5, 1), "translucency": 0.25}
    assert call(lit_multiply_soft, **inputs) == ((0.125, 0.625, 2),)


BLENDED = {"phong": (0.25, 0.5, 1), "albedo": (0.5, 0.5, 0.25), "incident_light": (1, 2, 4), "light_count": 2}
BLENDED |= {"light_visible": (0, 0.5, 1), "ambient": 0.5, "translucency": 4, "translucency_scale": 0.125}
BLENDED |= {"position_world": (0, 0, 0), "normal_world": (0, 0, 1)}


@pytest.mark.parametrize("stage", [lit_transmit_soft, lit_transmit_wrapped_soft])
def test_between_ambient_and_phong(stage):
    # Ambient .5/2*albedo = (.125, .125, .0625); from behind plus albedo*e*(4*.125)*1 = (.5, 1, 1)*.5.
    inputs = BLENDED | ({"wrap": 0.25} if stage is lit_transmit_wrapped_soft else {})
    assert call(stage, **inputs, light_position=(0, 0, 2)) == ((0.125, 0.3125, 1),)
    assert call(stage, **inputs, light_position=(0, 0, -2)) == ((0.375, 0.8125, 1.5),)


def test_lit_transmit_soft():
    assert call(lit_transmit_soft, **BLENDED, light_position=(2, 0, 0)) == ((0.125, 0.3125, 1),)


def test_lit_transmit_wrapped_soft():
    # At N.L = 0 with wrap 1 half of (.5, 1, 1)*.5.
    assert call(lit_transmit_wrapped_soft, **BLENDED, wrap=1, light_position=(2, 0, 0)) == ((0.25, 0.5625, 1.25),)


SHARE = {"position_world": (0, 0, 0), "light_position": (0, 0, 2), "incident_light": (1, 2, 4)}
SHARE |= {"light_visible": (0, 0.5, 1)}


def test_irradiance_lambert_soft():
    assert call(irradiance_lambert_soft, **SHARE, normal_world=(0, 0, 0.5)) == ((0, 0.5, 2),)
    assert call(irradiance_lambert_soft, **SHARE, normal_world=(0, 0, -1)) == ((0, 0, 0),)


def test_gloss_soft():
    # As in gloss_where_lit: V.R = .125, squared 1/64, times specular 8 makes .125.
    eye = {"camera_position": (0, 0, 3), "normal_world": (0, 0, 0.75), "specular": 8, "shininess": 2}
    assert call(gloss_soft, **SHARE, **eye) == ((0, 0.125, 0.5),)
