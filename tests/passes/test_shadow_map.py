"""The stages of the shadow map, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.passes.shadow_map import (
    back_point,
    back_point_parallel,
    directly_lit_literal,
    directly_lit_slope,
    distance_to_light,
    shadow_lookup_bilinear,
    shadow_lookup_nearest,
    uv_at_light,
)

# A light at the origin that looks along -Z with a field of view of 90 degrees: clip = (x, y, -z - 1, -z).
CLIP_FROM_WORLD = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, -1], [0, 0, -1, 0]]
DISTANCES = np.float32([[1, 2, 3, 4], [5, 6, 7, 8]])  # row 0 is the bottom
FULL = np.zeros((2, 4), np.int32)


def look_up(stage, position, triangles=FULL, inset=1.0, distances=DISTANCES, clip_from_world=CLIP_FROM_WORLD):
    return call(
        stage,
        position_world=position,
        light_position=(0, 0, 0),
        light_clip_from_world=clip_from_world,
        lookup_inset=inset,
        light_distance=distances,
        light_triangle=triangles,
    )


def test_distance_to_light():
    # (1, 2, 3) - (1, -1, -1) = (0, 3, 4), of length 5.
    assert call(distance_to_light, fragment_position=(1, 2, 3), light_position=(1, -1, -1)) == (5,)


def test_uv_at_light():
    assert call(uv_at_light, fragment_uv=(0.25, 1)) == ((0.25, 1),)


@pytest.mark.parametrize(
    ("position", "uv", "stored"),
    [
        ((1, 0, -2), (0.75, 0.5), 8),  # (1/2 + 1)/2 = .75, texel floor(.75*4) = 3; (0 + 1)/2, texel floor(.5*2) = 1
        ((-2, -2, -2), (0, 0), 1),  # the lower left corner
        ((2, 2, -2), (1, 1), 8),  # u = 1 and v = 1 belong to the last texel
        ((-0.5, -1.5, -2), (0.375, 0.125), 2),  # texel floor(1.5) = 1 of row floor(.25) = 0
    ],
)
def test_shadow_lookup_nearest(position, uv, stored):
    assert look_up(shadow_lookup_nearest, position) == (uv, True, stored)


def test_shadow_lookup_nearest_with_inset():
    # (1/2*.5 + 1)/2 = .625: texel floor(2.5) = 2 of row floor(1) = 1.
    assert look_up(shadow_lookup_nearest, (1, 0, -2), inset=0.5) == ((0.625, 0.5), True, 7)


@pytest.mark.parametrize("stage", [shadow_lookup_nearest, shadow_lookup_bilinear])
@pytest.mark.parametrize(
    ("position", "distance"),
    [
        ((0, 3, 4), 5),  # behind the light: w = -4
        ((3, 4, 0), 5),  # beside it: w = 0
        ((0, 0, 0), 0),  # at it
        ((8, 4, -1), 9),  # to the right of its map: 64 + 16 + 1 = 81
    ],
)
def test_outside_the_map_there_is_no_uv_and_the_own_distance(stage, position, distance):
    assert look_up(stage, position) == ((-1, -1), False, distance)


@pytest.mark.parametrize("stage", [shadow_lookup_nearest, shadow_lookup_bilinear])
def test_on_background_the_uv_stands_but_the_distance_is_the_own(stage):
    background = np.where(DISTANCES == 8, -1, 0).astype(np.int32)
    assert look_up(stage, (1, 0, -2), background) == ((0.75, 0.5), False, np.float32(np.sqrt(np.float32(5))))


def test_shadow_lookup_bilinear():
    # At uv (.5, .5), in texels 2 - .5 = 1.5 and 1 - .5 = .5: the mean of 2, 3, 6 and 7.
    assert look_up(shadow_lookup_bilinear, (0, 0, -2)) == ((0.5, 0.5), True, 4.5)
    # At uv (.625, .25), in texels 2 and 0: a texel centre.
    assert look_up(shadow_lookup_bilinear, (0.5, -1, -2)) == ((0.625, 0.25), True, 3)


def test_shadow_lookup_bilinear_at_an_outline_reads_the_nearest():
    outline = np.where(DISTANCES == 2, -1, 0).astype(np.int32)
    assert look_up(shadow_lookup_bilinear, (0, 0, -2), outline) == ((0.5, 0.5), True, 7)


@pytest.mark.parametrize(("stage", "stored"), [(shadow_lookup_nearest, 8), (shadow_lookup_bilinear, 5.5)])
def test_the_view_of_a_light_elsewhere(stage, stored):
    # The view is moved by 1: clip = (x - 1, y, ...), so (2, 0, -2) falls on uv (.75, .5), between 3, 4, 7 and 8.
    moved = [[1, 0, 0, -1], *CLIP_FROM_WORLD[1:]]
    assert look_up(stage, (2, 0, -2), clip_from_world=moved) == ((0.75, 0.5), True, stored)


@pytest.mark.parametrize("missing", [(1, 2), (2, 1), (2, 2)])  # row and column
def test_each_of_the_four_texels_may_be_the_outline(missing):
    # 1 + column + 4*row, at 4*.4375 - .5 = 1.25 in both: 1 + 1.25 + 5; the nearest, of row 1 and column 1, has 6.
    distances = np.arange(1, 17, dtype=np.float32).reshape(4, 4)
    four_alone = np.full((4, 4), -1, np.int32)
    four_alone[1:3, 1:3] = 0
    uv, position = (0.4375, 0.4375), (-0.25, -0.25, -2)
    assert look_up(shadow_lookup_bilinear, position, four_alone, distances=distances) == (uv, True, 7.25)
    outline = np.zeros((4, 4), np.int32)
    outline[missing] = -1
    assert look_up(shadow_lookup_bilinear, position, outline, distances=distances) == (uv, True, 6)


def test_back_point():
    # From (0, 0, 1) five units straight down to (0, 0, -4); the surface lies 3 units from the light: 2 are left.
    inputs = {"position_world": (0, 0, -4), "light_position": (0, 0, 1), "stored_distance": 3}
    assert call(back_point, **inputs, shadow_valid=True) == ((0, 0, -2), 2)
    assert call(back_point, **inputs, shadow_valid=False) == ((0, 0, -4), 0)


def test_back_point_on_a_slant():
    # From (3, 0, 0) along (-3, 0, -4)/5; half of the way of 5 is left.
    inputs = {"position_world": (0, 0, -4), "light_position": (3, 0, 0), "stored_distance": 2.5}
    assert call(back_point, **inputs, shadow_valid=True) == ((1.5, 0, -2), 2.5)


def test_back_point_parallel():
    # The rays go down, 5 units from the plane z = 1 to the fragment; the surface lies 3 from it: 2 are left.
    inputs = {
        "position_world": (7, 0, -4),
        "light_position": (0, 0, 1),
        "light_direction": (0, 0, -1),
        "stored_distance": 3,
    }
    assert call(back_point_parallel, **inputs, shadow_valid=True) == ((7, 0, -2), 2)
    assert call(back_point_parallel, **inputs, shadow_valid=False) == ((7, 0, -4), 0)


def lit_slope(normal, stored, position=(0, 0, -4), bias_abs=0.0, light=(0, 0, 0), clip_from_world=CLIP_FROM_WORLD):
    return call(
        directly_lit_slope,
        position_world=position,
        normal_world=normal,
        light_position=light,
        light_clip_from_world=clip_from_world,
        light_texel_size=0.125,
        stored_distance=stored,
        bias_abs=bias_abs,
        bias_slope=1.5,
    )


@pytest.mark.parametrize(
    ("normal", "behind", "lit"),
    [
        # D = w = 4, so a texel covers 4/8 = .5. Facing the light, tan 0: the bias is 1.5*.5 = .75.
        ((0, 0, 1), 0.75, True),
        ((0, 0, 1), 0.7500002, False),
        ((0, 0, 1.0000001), 0.75, True),  # a cosine that rounding made larger than 1
        # cos = 3/5, tan = 4/3: 1.5*(.5*7/3) = 1.75.
        ((0.8, 0, 0.6), 1.7499, True),
        ((0.8, 0, 0.6), 1.7501, False),
        # cos = 1/100 counts as 1/20: tan = sqrt(399) = 19.97498, 1.5*(.5*20.97498) = 15.73124.
        ((0.99995, 0, 0.01), 15.7312, True),
        ((0.99995, 0, 0.01), 15.7313, False),
        # Turned away, and exactly edge on.
        ((0, 0, -1), 0, False),
        ((1, 0, 0), 0, False),
        ((0, 0, 0), 0, False),
    ],
)
def test_directly_lit_slope(normal, behind, lit):
    assert lit_slope(normal, 4 - behind) == (lit,)


def test_directly_lit_slope_close_to_the_light():
    # w = 1/2: a texel covers 1/16, and the bias is 1.5/16 = .09375.
    assert lit_slope((0, 0, 1), 0.5 - 0.09375, (0, 0, -0.5)) == (True,)
    assert lit_slope((0, 0, 1), 0.5 - 0.09376, (0, 0, -0.5)) == (False,)


def test_directly_lit_slope_from_a_light_elsewhere():
    # The light is at z = 1, so w = 1 - z: 4 as above, and the bias .75.
    above = {"light": (0, 0, 1), "clip_from_world": [*CLIP_FROM_WORLD[:3], [0, 0, -1, 1]]}
    assert lit_slope((0, 0, 1), 4 - 0.75, (0, 0, -3), **above) == (True,)
    assert lit_slope((0, 0, 1), 4 - 0.8, (0, 0, -3), **above) == (False,)


def test_directly_lit_slope_adds_the_constant_bias():
    assert lit_slope((0, 0, 1), 4 - 0.875, bias_abs=0.125) == (True,)  # .75 + .125
    assert lit_slope((0, 0, 1), 4 - 0.876, bias_abs=0.125) == (False,)


def test_directly_lit_slope_behind_the_light():
    """The light shines outside its cone too: no map there, so stored = D, and the fragment faces the light."""
    assert lit_slope((0, 0, -1), 4, position=(0, 0, 4)) == (True,)
    assert lit_slope((0, 0, -1), np.nextafter(np.float32(4), np.float32(0)), position=(0, 0, 4)) == (False,)  # no bias


def test_directly_lit_literal():
    inputs = {"position_world": (0, 3, 4), "light_position": (0, 0, 0)}
    assert call(directly_lit_literal, **inputs, stored_distance=5, bias_abs=0) == (True,)
    assert call(directly_lit_literal, **inputs, stored_distance=4.75, bias_abs=0.25) == (True,)  # 5 - 4.75 = .25
    assert call(directly_lit_literal, **inputs, stored_distance=4.75, bias_abs=0.125) == (False,)
