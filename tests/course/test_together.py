"""The right picture stands beside the reader's, whatever the reader's stage does."""

import textwrap

import numpy as np
import pytest
from drawn_figure import told
from matplotlib import pyplot

from sss_ref.course import checks, together
from sss_ref.course.together import compared, right_and_yours


@pytest.fixture(autouse=True)
def no_window():
    pyplot.switch_backend("agg")
    yield
    pyplot.close("all")


@pytest.mark.parametrize(
    ("own", "title"),
    [
        ([0.0, 1.0], "yours, the same bits"),
        ([0.0, np.nextafter(np.float32(1), 0)], "yours: to the eye the same, other bits in 50%"),
        ([0.0, 0.5], "yours"),
        ([0.0, 0.9961], "yours: to the eye the same, other bits in 50%"),
        ([0.0, 0.9959], "yours"),
    ],
)
def test_a_title_says_how_the_two_compare(own, title):
    right, mine = np.array([[0, 1]], np.float32), np.array([own], np.float32)
    assert compared(right, mine) == title


def test_of_a_wide_range_as_much_may_differ_as_the_eye_sees_of_it():
    """.4 % of 10; and of many pixels one that differs is told as a hundredth."""
    right = np.linspace(0, 10, 400, dtype=np.float32).reshape(20, 20)
    for off, title in ((0.039, "yours: to the eye the same, other bits in 1%"), (0.041, "yours")):
        own = right.copy()
        own[3, 4] += off
        assert compared(right, own) == title


PAIR = [
    "6.6 2.9 inches at 110, ConstrainedLayoutEngine",
    "axes: 'right' '' '', aspect 1.0",
    "axes: 'yours' '' '', aspect auto",
]


def test_what_keeps_a_picture_from_being_drawn_is_said_in_its_middle(monkeypatch):
    """In lines of 40 letters."""
    said = "normal_world: expected a buffer that is written before it, got none"
    monkeypatch.setattr(together, "right_and_own", lambda *_: (np.zeros((2, 2, 3), np.float32), said))
    right_and_yours(checks.stencilled, None, "bust")
    found = told(pyplot.gcf())
    assert [line for line in found if not line.startswith(" ")] == PAIR
    words = textwrap.fill(said, 40)
    assert f"  words {words!r} at 0.5 0.5, 8, center" in found and max(map(len, words.splitlines())) <= 40


def test_numbers_have_the_range_of_the_right_ones(monkeypatch):
    right, own = np.array([[1.0, 3.0]], np.float32), np.array([[0.0, 5.0]], np.float32)
    monkeypatch.setattr(together, "right_and_own", lambda *_: (right, own))
    right_and_yours(checks.stencilled, None, "bust")
    found = told(pyplot.gcf())
    assert "  image 1 3, 1 3" in found and "  image 0 5, 1 3" in found
    assert "axes: 'yours' '' '', aspect 1.0" in found
