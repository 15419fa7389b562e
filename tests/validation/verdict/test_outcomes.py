"""What becomes of a pixel, one case each."""

import numpy as np

from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.verdict.outcomes import (
    AMBIGUOUS,
    CERTAIN,
    FAIL,
    NOT_COMPARED,
    UNBOUNDED,
    UNDEFINED,
    compared,
    outcome_map,
)

NAN, INF = np.nan, np.inf
CASES = [  # expected, got, reach, undecided, what becomes of it
    (1, 1, 0, False, CERTAIN),
    (1, 1.25, 0.25, False, CERTAIN),
    (1, 1.25, 0.25, True, AMBIGUOUS),
    (1, 1.5, 0.25, True, FAIL),
    (1, 1.5, 0.25, False, FAIL),
    (1, 99, INF, True, UNBOUNDED),
    (1, NAN, 0.25, False, FAIL),
    (1, INF, 1e30, False, FAIL),
    (1, NAN, INF, False, UNDEFINED),
    (1, INF, INF, False, UNDEFINED),
    (NAN, NAN, INF, False, UNDEFINED),
    (NAN, 1, INF, False, UNDEFINED),
]


def check_of(expected, got, reach, undecided, where):
    arrays = (np.array(each, np.float32) for each in (expected, got))
    return Check("pass", "stage", "lit", where, *arrays, np.array(reach, np.float64), np.array(undecided))


def test_every_case():
    expected, got, reach, undecided, outcomes = zip(*CASES, strict=True)
    where = np.ones((1, len(CASES)), bool)
    found = compared(check_of([expected], [got], [reach], [undecided], where))
    assert found.outcome.tolist() == list(outcomes)
    assert [found.count(each) for each in range(5)] == [2, 1, 4, 4, 1]


def test_one_wrong_channel_makes_a_pixel_wrong():
    """Even where nothing can be said of another channel."""
    check = check_of([[[1, 1, 1]]], [[[NAN, 1, 2]]], [[[INF, 0, 0.5]]], [[True]], np.ones((1, 1), bool))
    assert compared(check).outcome.tolist() == [FAIL]


def test_the_map_is_of_all_pixels():
    where = np.array([[True, False], [False, True]])
    check = check_of([[1, 1], [1, 1]], [[1, 2], [1, 2]], np.zeros((2, 2)), np.zeros((2, 2), bool), where)
    assert outcome_map(check).tolist() == [[CERTAIN, NOT_COMPARED], [NOT_COMPARED, FAIL]]


def test_an_interval_that_holds_all_that_the_buffer_holds_says_nothing():
    """0 counts as well; of several channels each must."""
    expected, reach = np.array([[0.5, 2.0, 1.0, 1.0]]), np.array([[1.5, 2.0, 1.0, 0.5]])
    check = check_of(expected, expected, reach, np.zeros((1, 4), bool), np.ones((1, 4), bool))
    assert compared(check).outcome.tolist() == [UNBOUNDED, UNBOUNDED, UNBOUNDED, CERTAIN]
    beyond = check_of(expected, expected + 9, reach, np.zeros((1, 4), bool), np.ones((1, 4), bool))
    assert set(compared(beyond).outcome.tolist()) == {FAIL}
    colours, wide = np.array([[[1.0, 0, 2], [2.0, 0, 1]]]), np.array([[[1.0, 0, 0.5], [2.0, 0, 1]]])
    found = compared(check_of(colours, colours, wide, np.zeros((1, 2), bool), np.ones((1, 2), bool)))
    assert found.outcome.tolist() == [CERTAIN, UNBOUNDED]
