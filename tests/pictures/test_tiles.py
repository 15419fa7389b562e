"""The colours that every picture of a buffer is made of, as they were chosen."""

import numpy as np

from sss_ref.pictures import lettering, tiles


def test_the_ramp_is_as_it_was_chosen():
    """Six colours, 51 steps apart, and half-way between the first two the mean of them, cut off."""
    chosen = [(58, 32, 104), (57, 84, 158), (33, 138, 148), (84, 188, 110), (200, 222, 78), (255, 247, 194)]
    assert tiles.RAMP.shape == (256, 3) and tiles.RAMP.dtype == np.uint8
    assert [tuple(colour) for colour in tiles.RAMP[::51].tolist()] == chosen
    assert tiles.RAMP[[25, 26]].tolist() == [[57, 57, 130], [57, 58, 131]]


def test_the_ground_the_mask_and_the_inks():
    assert (tiles.GROUND, tiles.MASK) == ((22, 24, 29), (226, 228, 233))
    inks = (lettering.BRIGHT, lettering.SOFT, lettering.FAINT)
    assert inks == ((238, 240, 244), (158, 164, 176), (104, 110, 122))


def test_no_number_has_a_dark_colour():
    assert (tiles.BRIGHTENED[0], tiles.BRIGHTENED[128], tiles.BRIGHTENED[255]) == (60, 157, 255)
    assert tiles.BRIGHTENED.shape == (256,)


def test_texture_coordinates_have_a_place_from_0_on_and_points_the_range_of_all_channels():
    uv = np.array([[[0, 0], [1, 0.5], [-0.001, 1]]], np.float32)
    shown = tiles.picture("uv", uv, np.ones((1, 3), bool))
    assert shown.tolist() == [[[0, 0, 90], [255, 128, 90], [*tiles.GROUND]]]
    points = np.array([[[0, 5, 10], [2, 4, 6]]], np.float32)
    assert tiles.picture("position_world", points, np.ones((1, 2), bool)).tolist() == [[[0, 128, 255], [51, 102, 153]]]


def test_what_lies_over_the_ground():
    colours, covered = np.full((1, 2, 3), 7, np.uint8), np.array([[True, False]])
    assert tiles.over_ground(colours, covered).tolist() == [[[7, 7, 7], [*tiles.GROUND]]]
    assert tiles.value_range(np.array([[3.0, 9.0]]), covered) == (3, 3)
    assert tiles.value_range(np.array([[3.0, 9.0]]), covered & False) == (0, 0)
