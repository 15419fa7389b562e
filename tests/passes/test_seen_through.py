"""What passes between two bodies, worked by hand."""

import math

import numpy as np
import pytest
from one_stage import call

from sss_ref.passes.seen_through import light_inside, seen_through

GREY = {"extinction_per_mm": (0, 0.5, 1), "mm_per_unit": 0.5}
ROOT_E, E = (np.float32(math.exp(-exponent)) for exponent in (0.5, 1))  # what is left of 1 after 1 mm of .5 and of 1


@pytest.mark.parametrize(
    ("shadow_uv", "entered", "triangle", "expected"),
    [
        ((0.5, 0.5), 3, 7, (1, 2 * ROOT_E, 4 * E)),  # from 3 to 5: 2 units are 1 mm
        ((0.5, 0.5), 5, 7, (1, 2, 4)),  # both surfaces at one place
        ((0.5, 0.5), 6, 7, (1, 2, 4)),  # it reaches out of the mesh
        ((0.5, 0.5), 3, -1, (1, 2, 4)),  # background of the mesh's map
        ((-1, -1), 3, 7, (1, 2, 4)),  # outside the map
    ],
)
def test_light_inside(shadow_uv, entered, triangle, expected):
    around = {"around_distance": [[entered]], "around_triangle": [[triangle]]}
    light = {"light_around": (1, 2, 4), "shadow_uv": shadow_uv, "stored_distance": 5}
    assert call(light_inside, **light, **around, **GREY) == (expected,)


@pytest.mark.parametrize(
    ("depth", "covered", "way", "expected"),
    [
        (5, True, 1, (1.5, 0.25 + 2 * ROOT_E, 4 * E)),
        (3, True, 0, (1.5, 2.25, 4)),
        (2, True, 0, (1.5, 2.25, 4)),  # before the outer surface
        (5, False, 0, (1.5, 2.25, 4)),  # cleared to black where it is not drawn; here it is not, to show the way
    ],
)
def test_seen_through(depth, covered, way, expected):
    inner = {"inner_lit": (1, 2, 4), "inner_position_world": (0, 0, -depth), "inner_coverage": covered}
    outer = {"lit": (0.5, 0.25, 0), "position_world": (0, 0, -3), "camera_position": (0, 0, 0)}
    assert call(seen_through, **outer, **inner, **GREY) == (way, expected)
