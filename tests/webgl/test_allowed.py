"""What the page is told of a buffer: steps from the middle to the ends, and what is known of each pixel."""

import numpy as np

from sss_ref.numerics.inward import ordered
from sss_ref.validation.accept.rebased import Check
from sss_ref.webgl.allowed import (
    BACKGROUND,
    COMPARED,
    NOT_COMPARED,
    SEVERAL,
    UNDEFINED,
    allowed,
)

F = np.float32


def check_of(expected, reach, **more):
    where = more.pop("where", np.ones(expected.shape[:2], bool))
    return Check("pass", "stage", "buffer", where, expected, expected, reach, **more)


def test_steps_lead_from_the_middle_to_the_ends():
    middle = np.array([[1.0, -1.0, 0.0, -0.0]], F)
    found = allowed(check_of(middle, np.array([[2.0**-23, 2.0**-23, 2.0**-149, 2.0**-149]])))
    assert found.below.tolist() == [[2, 1, 1, 1]] and found.above.tolist() == [[1, 2, 1, 1]]
    assert np.array_equal(ordered(middle) - found.below, ordered(found.low))


def test_states():
    middle = np.array([[1, 2, np.nan, 4, 5]], F)
    flags = {
        "where": np.array([[True, True, True, False, False]]),
        "undecided": np.array([[False, True, True, True, False]]),
        "outside": np.array([[False, False, False, False, True]]),
    }
    found = allowed(check_of(middle, np.ones(middle.shape), **flags))
    assert found.state.tolist() == [[COMPARED, SEVERAL, UNDEFINED, NOT_COMPARED, BACKGROUND]]
    assert found.low[0, 4] == 4 and found.low[0, 3] == 4  # the reach of what is compared, and nothing elsewhere


def test_of_several_channels_all_must_be_numbers():
    """And nothing is known of a buffer that says nothing of its undecided and its outside."""
    middle = np.array([[(1, 2), (np.nan, 2)], [(1, np.inf), (3, 4)]], F)
    found = allowed(check_of(middle, np.full(middle.shape, 0.5), where=np.array([[True, True], [True, False]])))
    assert found.state.tolist() == [[COMPARED, UNDEFINED], [UNDEFINED, NOT_COMPARED]]
    assert found.low[0, 0].tolist() == [0.5, 1.5] and found.high[0, 0].tolist() == [1.5, 2.5]
    assert found.low[1, 1].tolist() == found.high[1, 1].tolist() == [3, 4]
    assert found.high[0, 1, 1] == 2.5 and np.isnan(found.high[0, 1, 0])


def test_what_the_page_is_told_by_number():
    assert (NOT_COMPARED, COMPARED, SEVERAL, UNDEFINED, BACKGROUND) == (0, 1, 2, 3, 4)
