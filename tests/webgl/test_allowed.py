"""The least and the largest number that is right, beside the rule itself: no further from the middle than the reach."""

import numpy as np
import pytest

from sss_ref.validation.accept.rebased import Check
from sss_ref.webgl.allowed import (
    BACKGROUND,
    COMPARED,
    NOT_COMPARED,
    SEVERAL,
    UNDEFINED,
    allowed,
    ordered,
)

F = np.float32


def check_of(expected, reach, **more):
    where = more.pop("where", np.ones(expected.shape[:2], bool))
    return Check("pass", "stage", "buffer", where, expected, expected, reach, **more)


def test_the_ends_are_the_last_that_the_reach_lets_in():
    random = np.random.default_rng(5)
    middle = (random.standard_normal((40, 50)) * 10.0 ** random.integers(-40, 38, (40, 50))).astype(F)
    reach = np.abs(middle.astype(float)) * 10.0 ** random.integers(-12, 3, middle.shape)
    reach[0], reach[1, :9] = 0, np.inf
    found = allowed(check_of(middle, reach))
    for end, outward in ((found.low, -np.inf), (found.high, np.inf)):
        with np.errstate(over="ignore"):
            further = np.nextafter(end, F(outward))
        assert (np.abs(end - middle.astype(float)) <= reach).all()
        assert ((np.abs(further - middle.astype(float)) > reach) | (further == end)).all()
    assert np.isinf(found.low[1, :9]).all() and (found.low[0] == middle[0]).all()


def test_steps_lead_from_the_middle_to_the_ends():
    middle = np.array([[1.0, -1.0, 0.0, -0.0]], F)
    found = allowed(check_of(middle, np.array([[2.0**-23, 2.0**-23, 2.0**-149, 2.0**-149]])))
    assert found.below.tolist() == [[2, 1, 1, 1]] and found.above.tolist() == [[1, 2, 1, 1]]
    assert np.array_equal(ordered(middle) - found.below, ordered(found.low))


def test_neighbours_are_a_step_apart():
    numbers = np.array([-np.inf, -1.5, -1e-45, 0.0, 1e-45, 2.0, np.finfo(F).max], F)
    with np.errstate(over="ignore"):
        assert (ordered(np.nextafter(numbers, F(np.inf))) - ordered(numbers) == 1).all()
    assert ordered(np.array([-0.0], F)) == ordered(np.array([0.0], F)) == [0]


@pytest.mark.parametrize(("dtype", "ends"), [(np.int32, (3, 7)), (np.uint8, (0, 1))])
def test_whole_numbers_stay_whole_and_in_range(dtype, ends):
    middle = np.array([[5 if dtype is np.int32 else 1]], dtype)
    found = allowed(check_of(middle, np.array([[2.9]])))
    assert (found.low.item(), found.high.item()) == ends and found.low.dtype == dtype


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
