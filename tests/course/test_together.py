"""The right picture stands beside the reader's, whatever the reader's stage does."""

import numpy as np
import pytest
from exercise_answers import a_text, solutions
from matplotlib import pyplot

from sss_ref.course import checks
from sss_ref.course.right_pictures import PLACES, right_and_own
from sss_ref.course.together import compared, right_and_yours

SOLUTIONS = solutions()


@pytest.fixture(autouse=True)
def no_window():
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


@pytest.mark.parametrize("check", PLACES, ids=lambda check: check.__name__)
def test_a_solution_draws_the_right_picture(check):
    right, own = right_and_own(check, SOLUTIONS[check], "bust")
    assert np.ptp(right) > 0 and np.allclose(own, right, atol=1e-4)


def test_what_is_no_stage_is_said_in_the_place_of_its_picture():
    assert right_and_own(checks.stencilled, a_text, "bust")[1] == "not a stage yet"
    right_and_yours(checks.stencilled, a_text, "bust")
    right, own = pyplot.gcf().axes
    assert right.images and not own.images and own.texts[0].get_text() == "not a stage yet"


@pytest.mark.parametrize(
    ("own", "title"),
    [
        ([0.0, 1.0], "yours, the same bits"),
        ([0.0, np.nextafter(np.float32(1), 0)], "yours: to the eye the same, other bits in 50%"),
        ([0.0, 0.5], "yours"),
    ],
)
def test_a_title_says_how_the_two_compare(own, title):
    right, mine = np.array([[0, 1]], np.float32), np.array([own], np.float32)
    assert compared(right, mine) == title
