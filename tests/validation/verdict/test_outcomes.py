"""What becomes of a pixel, one case each."""

from dataclasses import replace

import numpy as np
import pytest

from sss_ref.validation.accept.rebased import Check
from sss_ref.validation.accept.sparing import NEEDED, SAMPLED
from sss_ref.validation.verdict.outcomes import (
    AMBIGUOUS,
    CERTAIN,
    FAIL,
    NOT_COMPARED,
    UNBOUNDED,
    UNDEFINED,
    Compared,
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


def pixels(outcomes, bounded=None):
    """Compared pixels with these outcomes; bounded: why bounds were worked out at each, if not everywhere."""
    zero, some = np.zeros((len(outcomes), 1)), np.array(outcomes, np.uint8)
    reasons = None if bounded is None else np.array(bounded, np.uint8)
    return Compared(zero, zero, zero, np.zeros(len(outcomes), bool), some, reasons)


def test_pixels_that_were_spared_count_as_those_like_them():
    """Of four sampled ones a quarter is ambiguous, so are two of eight spared ones; what differs speaks for itself."""
    sampled = [AMBIGUOUS, CERTAIN, CERTAIN, UNBOUNDED]
    spared = [CERTAIN] * 8
    found = pixels([*sampled, *spared, AMBIGUOUS, FAIL], [*[SAMPLED] * 4, *[0] * 8, NEEDED, NEEDED])
    assert found.count(AMBIGUOUS) == 1 + 1 + 2 and found.count(UNBOUNDED) == 1 + 2
    assert found.count(FAIL) == 1 and found.count(CERTAIN) == 10
    assert found.sample.tolist() == [True] * 4 + [False] * 8 + [False] * 2


def test_what_is_undefined_is_no_part_of_a_sample():
    found = pixels([AMBIGUOUS, UNDEFINED, CERTAIN, UNDEFINED], [SAMPLED, SAMPLED, 0, 0])
    assert found.count(AMBIGUOUS) == 2 and found.count(UNDEFINED) == 2
    assert found.sample.tolist() == [True, False, False, False]
    assert pixels([CERTAIN, UNDEFINED, FAIL]).sample.tolist() == [True, False, True]
    assert pixels([CERTAIN, CERTAIN], [0, 0]).count(AMBIGUOUS) == 0


def test_where_bounds_were_not_worked_out_a_pixel_is_certain():
    check = check_of([[1, 1, 1]], [[1, 1, 2]], [[0.0, INF, 0.0]], [[False] * 3], np.ones((1, 3), bool))
    check = replace(check, bounded=np.uint8([[0, SAMPLED, SAMPLED]]))
    found = compared(check)
    assert found.outcome.tolist() == [CERTAIN, UNBOUNDED, FAIL] and found.reach[:, 0].tolist() == [0, INF, 0]
    assert found.differs.tolist() == [False, False, True] and found.bounded.tolist() == [0, SAMPLED, SAMPLED]


@pytest.mark.parametrize(
    ("expected", "reach", "outcome"),
    [
        ([2.0, 0.0], [2.0, 0.0], [UNBOUNDED, CERTAIN]),
        ([2.0, 0.0], [1.999, 0.0], [CERTAIN, CERTAIN]),
        ([1.0, 2.0], [1.0, 0.0], [UNBOUNDED, CERTAIN]),
        ([1.0, 2.0], [0.999, 0.0], [CERTAIN, CERTAIN]),
        ([-1.0, 1.0], [0.0, 2.0], [CERTAIN, UNBOUNDED]),
        ([0.0, 0.0], [1.0, 1.0], [CERTAIN, CERTAIN]),  # there is nothing to hold
    ],
)
def test_an_interval_holds_all_up_to_its_ends(expected, reach, outcome):
    check = check_of([expected], [expected], [reach], [[False] * 2], np.ones((1, 2), bool))
    assert compared(check).outcome.tolist() == outcome


def test_of_integers_no_interval_says_nothing():
    check = check_of([[1, 2]], [[1, 2]], [[5.0, 5.0]], [[False] * 2], np.ones((1, 2), bool))
    check = replace(check, expected=np.int32([[1, 2]]), got=np.int32([[1, 2]]))
    assert compared(check).outcome.tolist() == [CERTAIN, CERTAIN]
