"""The pictures of a wrong buffer: which colour each pixel and each block of pixels has."""

import base64
import io

import imageio.v3 as imageio
import numpy as np
import pytest
from checked import check_of

from sss_ref.pictures import tiles
from sss_ref.validation.report.report_pictures import _most_in_blocks, css_colour, legend, pictures

GREEN, YELLOW, RED, VIOLET, BLUE = (47, 143, 91), (214, 162, 58), (226, 70, 52), (146, 104, 190), (84, 128, 190)
OFF = "how far off: dark far within its reach, bright far beyond"
BECAME = "what became of each pixel"


def shown(check):
    """Caption -> the picture, (H, W, 3)."""
    found = {}
    for caption, url in pictures(check):
        found[caption] = imageio.imread(io.BytesIO(base64.b64decode(url.partition(",")[2])))[..., :3]
    return found


def test_outcomes_have_their_colours():
    expected = np.array([[1.0, 1, 1, 1, np.nan, 1]])
    got = np.array([[1.0, 1.25, 2, 9, 1, 5]])
    reach = np.array([[0.0, 0.5, 0.5, np.inf, 0, 0]])
    where, undecided = [[True] * 5 + [False]], np.array([[False, True, True, False, False, False]])
    became = shown(check_of(expected, got, reach, where, undecided=undecided))[BECAME][0]
    assert became.tolist() == [list(each) for each in (GREEN, YELLOW, RED, BLUE, VIOLET, tiles.GROUND)]


def test_outcomes_have_their_colours_in_the_legend():
    assert [css_colour(name) for name in ("certain", "ambiguous", "fail")] == ["#2f8f5b", "#d6a23a", "#e24634"]
    assert legend().startswith('<p class="legend"><span><i style="background:#2f8f5b"></i>certain</span><span>')


@pytest.mark.parametrize(("side", "pixels"), [(640, 640), (641, 321), (1280, 640), (1281, 427)])
def test_a_large_picture_is_thinned_and_loses_no_wrong_pixel(side, pixels):
    expected = np.ones((2, side), np.float32)
    got = expected.copy()
    got[1, side // 2] = 2
    found = shown(check_of(expected, got))
    assert {picture.shape[1] for picture in found.values()} == {pixels}
    assert (found[BECAME] == RED).all(axis=-1).sum() == 1
    assert (found[OFF] == tiles.RAMP[255]).all(axis=-1).sum() == 1


def test_the_worst_outcome_of_a_block_is_shown():
    """Of a block of 2 by 2: nothing, certain, ambiguous, unbounded, undefined, wrong, in this order."""
    expected = np.ones((2, 1282), np.float32)
    got, reach, where = expected.copy(), np.zeros(expected.shape), np.zeros(expected.shape, bool)
    undecided = np.zeros(expected.shape, bool)
    where[0], undecided[0, 2], reach[0, 4], expected[0, 6], got[0, 8] = True, True, np.inf, np.nan, 2
    where[0, 10:12] = False
    for column in (5, 7, 9):  # what is worse than its neighbour
        undecided[0, column] = True
    reach[0, 12], expected[0, 13] = np.inf, np.nan
    check = check_of(expected, got, reach, where, undecided=undecided)
    became = shown(check)[BECAME][0]
    assert became.shape[0] == 428  # in threes
    names = {GREEN: "c", YELLOW: "a", RED: "f", VIOLET: "d", BLUE: "b", tuple(map(int, tiles.GROUND)): "-"}
    assert "".join(names[tuple(map(int, each))] for each in became[:5]) == "abfad"


def test_how_far_off_is_told_in_decades_of_the_reach():
    """From a thousandth of it to a thousand times as far; where nothing is compared the ground is seen."""
    expected = np.zeros((1, 7))
    got = np.array([[0.0, 1e-4, 1e-3, 1.0, 1e3, 1e4, 5.0]])
    where = [[True] * 6 + [False]]
    off = shown(check_of(expected, got, 1.0, where))[OFF][0]
    assert off[0].tolist() == off[1].tolist() == off[2].tolist() == tiles.RAMP[0].tolist()
    assert off[4].tolist() == off[5].tolist() == tiles.RAMP[255].tolist() and off[6].tolist() == [*tiles.GROUND]
    assert off[3].tolist() in (tiles.RAMP[127].tolist(), tiles.RAMP[128].tolist())
    exact = shown(check_of(expected, got, 0.0))[OFF][0]
    assert exact[0].tolist() == tiles.RAMP[0].tolist() and exact[1].tolist() == tiles.RAMP[255].tolist()
    nothing = shown(check_of(expected, got * np.nan))[OFF][0]
    assert nothing[1].tolist() == tiles.RAMP[255].tolist()
    undefined = shown(check_of(expected * np.nan, got * np.nan))[OFF][0]
    assert undefined[1].tolist() == tiles.RAMP[0].tolist()


def test_what_must_and_may_be_covered_has_colours():
    covered = np.uint8([[0, 1, 2]])
    found = shown(check_of(np.int32([[1, 2, 3]]), np.int32([[1, 2, 3]]), covered=covered))
    assert found["green must be covered, yellow may be"][0].tolist() == [[*tiles.GROUND], [*YELLOW], [*GREEN]]
    assert OFF not in found and [*found] == [
        "as drawn",
        "as it should be",
        BECAME,
        "green must be covered, yellow may be",
    ]


@pytest.mark.parametrize("step", [1, 2, 3])
def test_blocks_hold_their_largest_value(step):
    values = np.random.default_rng(3).permutation(35).reshape(5, 7)
    naive = [[values[y : y + step, x : x + step].max() for x in range(0, 7, step)] for y in range(0, 5, step)]
    assert _most_in_blocks(values, step).tolist() == naive
