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
