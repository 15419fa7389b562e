"""The stages of the irradiance map, worked by hand, and the order in which a chart grows."""

import naive_stages
import numpy as np
import pytest
from one_stage import Inputs, assert_same_bits, call, run, run_naively

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.passes.irradiance import dilate, irradiance_distance, irradiance_lambert, irradiance_paper

# The light 4 above the fragment; the normal is of length .5, so that N.L = .5 exactly.
ABOVE = {
    "position_world": (1, 2, 0),
    "normal_world": (0, 0, 0.5),
    "light_position": (1, 2, 4),
    "incident_light": (1, 0.5, 0.25),
}
BELOW = {**ABOVE, "light_position": (1, 2, -4)}

# Rule R8: (columns to the right, rows up) of the neighbours, the first covered one is copied.
ORDER = [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)]


def test_irradiance_paper():
    # e * (4 * .5).
    assert call(irradiance_paper, **ABOVE) == ((2, 1, 0.5),)
    assert call(irradiance_paper, **BELOW) == ((0, 0, 0),)


def test_irradiance_lambert():
    # e * .5 where the light arrives, and where its map does not know.
    for lit, valid in ((True, True), (True, False), (False, False)):
        assert call(irradiance_lambert, **ABOVE, directly_lit=lit, shadow_valid=valid) == ((0.5, 0.25, 0.125),)
        assert call(irradiance_lambert, **BELOW, directly_lit=lit, shadow_valid=valid) == ((0, 0, 0),)
    assert call(irradiance_lambert, **ABOVE, directly_lit=False, shadow_valid=True) == ((0, 0, 0),)


def test_irradiance_distance():
    inputs = {name: ABOVE[name] for name in ("position_world", "light_position", "incident_light")}
    assert call(irradiance_distance, **inputs) == ((4, 2, 1),)


def islands(*neighbours):
    """A map of 3 x 3 texels in which these neighbours of the middle are covered; texel (column, row) is its colour."""
    irradiance = np.float32([[(column, row, 7) for column in range(3)] for row in range(3)])
    mask = np.zeros((3, 3), bool)
    for x, y in neighbours:
        mask[1 + y, 1 + x] = True
    return {"irradiance": irradiance, "irradiance_mask": mask}


def test_dilate():
    # Right (column 2) before above (row 2); a covered texel is left alone, whatever stands around it.
    assert call(dilate, **islands((1, 0), (0, 1)), pixel=(1, 1)) == ((2, 1, 7), True)
    assert call(dilate, **islands((0, 0), *ORDER), pixel=(1, 1)) == ((1, 1, 7), True)


@pytest.mark.parametrize("rank", range(8))
def test_dilate_takes_a_neighbour_only_if_none_before_it_is_covered(rank):
    x, y = ORDER[rank]
    for covered in (ORDER[rank:], ORDER[rank : rank + 1]):
        assert call(dilate, **islands(*covered), pixel=(1, 1)) == ((1 + x, 1 + y, 7), True)


@pytest.mark.parametrize(("column", "row"), [(0, 0), (2, 0), (0, 2), (2, 2)])
def test_dilate_does_not_look_beyond_the_map(column, row):
    """A map has no other side to go round to."""
    mirrored = [(1 - column, y) for y in (-1, 0, 1)] + [(x, 1 - row) for x in (-1, 0, 1)]
    assert call(dilate, **islands(*mirrored), pixel=(column, row)) == ((column, row, 7), False)


@pytest.mark.parametrize("interpreter", [arrays, kernel])
@pytest.mark.parametrize(("width", "height"), [(9, 6), (1, 5), (1, 1)])
@pytest.mark.parametrize("share", [0, 0.05, 1], ids=["empty", "sparse", "full"])
def test_dilate_of_any_mask_has_the_bits_of_the_naive_form(interpreter, width, height, share):
    rng = np.random.default_rng(7)
    irradiance = rng.random((height, width, 3)).astype(np.float32)
    mask = (rng.random((height, width)) < share).astype(np.uint8)
    inputs = Inputs(width, height, {"irradiance": irradiance, "irradiance_mask": mask}, {})
    filled = run(interpreter, dilate, inputs)
    assert_same_bits(filled, run_naively(naive_stages.dilate, dilate, inputs))
    if share in (0, 1):
        assert_same_bits(filled, {"irradiance_filled": irradiance, "irradiance_filled_mask": mask})
