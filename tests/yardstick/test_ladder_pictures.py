"""The pictures of a ladder: exposure, colours of what is too bright or too dark, and of the regions."""

from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.pictures.tiles import GROUND
from sss_ref.yardstick import ladder_pictures

TRUTH = SimpleNamespace(mean=np.full((1, 5, 3), 0.5), white=2.0)
COLOURS = {
    "lit": "#e2e4e9",
    "dark": "#3a3e4a",
    "thin": "#e8823c",
    "terminator": "#5480be",
    "shadow edge": "#2f8f5b",
    "silhouette": "#9268be",
    "seam": "#d6463c",
    "everywhere": "",
}


def test_white_of_the_truth_is_white_of_the_picture():
    assert ladder_pictures.exposed(np.array([[[2.0, 0.0, 1.0]]]), TRUTH).tolist() == [[[255, 0, 188]]]


def test_a_fifth_of_white_has_the_last_colour_and_equal_light_none():
    """Off by -.2 and .2 of a white of 2, so by .4; by half of that; by nothing on the mean of three channels."""
    off = np.array([[-0.4] * 3, [-0.2] * 3, [0.5, 0, -0.5], [0.2] * 3, [9.0] * 3])[np.newaxis]
    covered = np.array([[True] * 5])
    blue, light_blue, white, light_red, red = ladder_pictures.signed(TRUTH.mean + off, TRUTH, covered)[0].tolist()
    assert (blue, red) == ([36, 92, 196], [190, 40, 30])
    assert (light_blue, light_red) == ([120, 168, 232], [238, 152, 104])
    assert white == [238, 237, 234]  # the 128th of 255 steps, a little to the red of the middle
    assert ladder_pictures.signed(TRUTH.mean + off, TRUTH, ~covered).tolist() == [[[*GROUND]] * 5]


def test_the_bar_runs_from_too_dark_to_too_bright():
    bar = ladder_pictures.colour_bar(5, 2)
    assert bar.shape == (2, 5, 3) and (bar[0] == bar[1]).all() and bar.flags.c_contiguous
    assert bar[0, [0, 1, 3, 4]].tolist() == [[36, 92, 196], [120, 168, 232], [238, 152, 104], [190, 40, 30]]


@pytest.mark.parametrize("name", COLOURS)
def test_the_colour_of_a_region(name):
    assert ladder_pictures.region_colour(name) == COLOURS[name]


def test_of_several_regions_the_last_is_shown():
    masks = {
        "everywhere": np.array([[True, True, True, False]]),
        "seam": np.array([[False, True, False, False]]),
        "lit": np.array([[True, True, False, False]]),
    }
    shown = ladder_pictures.region_map(SimpleNamespace(masks=masks))
    assert shown.tolist() == [[[226, 228, 233], [214, 70, 60], [*GROUND], [*GROUND]]]
