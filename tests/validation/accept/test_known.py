"""What is known of values at pixels."""

from dataclasses import replace

import numpy as np
import pytest

from sss_ref.language import vec2
from sss_ref.numerics.interval import Interval
from sss_ref.validation.accept.known import Known, KnownBuffer, pixels_of, stacked


def test_one_value_for_all_pixels_has_a_reach_at_each():
    """As of a stage that reads uniforms alone."""
    known = Known(np.float32(1), Interval(np.array([1.0, 0.5, 1.0]), np.array([1.0, 1.0, 3.0])))
    assert known.reach.tolist() == [[0.0], [0.5], [2.0]]


def buffer_of(exact, low, high, kind=np.float32):
    exact, low, high = (np.array(each, kind) for each in (exact, low, high))
    return KnownBuffer(exact, low, high, np.zeros(exact.shape[:2], bool))


def test_a_reach_is_the_farther_end_and_infinite_where_there_is_none():
    buffer = buffer_of([[1, 2, 3, 4, 5]], [[0.5, 1, 3, -np.inf, np.nan]], [[1.25, 4, 3, 4, 5]])
    assert buffer.reach.tolist() == [[0.5, 2, 0, np.inf, np.inf]]
    assert buffer_of([[1.0]], [[1.5]], [[2.0]]).reach.tolist() == [[1]] and buffer_of([[5]], [[1]], [[4]]).reach[0] == 4


def test_a_buffer_is_exact_if_its_ends_are_itself():
    exact = KnownBuffer.exactly(np.float32([[1, 2]]))
    assert exact.span == 0 and exact.is_exact and not replace(exact, low=exact.low - 1).is_exact
    assert not replace(exact, high=exact.high + 1).is_exact and exact.doubt.tolist() == [[False, False]]


def test_what_is_put_is_in_doubt_where_its_ends_differ():
    at = np.array([0, 0]), np.array([0, 2])
    one = buffer_of([[0] * 3], [[0] * 3], [[0] * 3])
    one.put(at, np.float32([1, 2]), np.float32([1, 1.5]), np.float32([1, 3]))
    assert one.exact.tolist() == [[1, 0, 2]] and one.low.tolist() == [[1, 0, 1.5]] and one.high.tolist() == [[1, 0, 3]]
    assert one.doubt.tolist() == [[False, False, True]]
    three = buffer_of([[[0] * 3] * 3], [[[0] * 3] * 3], [[[0] * 3] * 3])
    same = np.float32([[1, 2, 3], [4, 5, 6]])
    three.put(at, same, same, same + np.float32([[0, 0, 0], [0, 1, 0]]))
    assert three.doubt.tolist() == [[False, False, True]]


@pytest.mark.parametrize(("kind", "held"), [(np.uint8, [0, 1, 1]), (np.int32, [-7, 2, 2**31 - 1])])
def test_what_a_type_cannot_hold_is_cut_off(kind, held):
    buffer = buffer_of([[0] * 3], [[0] * 3], [[0] * 3], kind)
    values = np.array([-7.0, 2.0, 2.0**31 - 1])
    buffer.put((np.zeros(3, int), np.arange(3)), values, values, values)
    assert buffer.exact.tolist() == [held]


def test_what_a_stage_wrote_stands_where_it_wrote_it():
    buffer = buffer_of([[[0] * 2] * 2], [[[0] * 2] * 2], [[[0] * 2] * 2])
    known = Known(
        vec2(np.float32([1, 2]), np.float32([3, 4])),
        vec2(Interval(np.float32([0, 1]), np.float32([5, 6])), Interval(np.float32([3, 4]), np.float32([3, 4]))),
        np.uint8([0, 2]),
    )
    buffer.write(known, (np.array([0, 0]), np.array([1, 0])))
    assert buffer.exact.tolist() == [[[2, 4], [1, 3]]] and buffer.low.tolist() == [[[1, 4], [0, 3]]]
    assert buffer.high.tolist() == [[[6, 4], [5, 3]]] and buffer.doubt.tolist() == [[True, False]]


def test_other_values_are_included_where_a_mask_says_so():
    buffer = buffer_of([[1, 1, 1]], [[0, 0, 0]], [[2, 2, 2]])
    buffer.include(np.float32([[5, -5, 9]]), np.array([[True, True, False]]))
    assert buffer.low.tolist() == [[0, -5, 0]] and buffer.high.tolist() == [[5, 2, 2]]


def test_the_pixels_of_a_mask_go_row_by_row():
    rows, columns = pixels_of(np.array([[False, True], [True, True]]))
    assert [*zip(rows.tolist(), columns.tolist(), strict=True)] == [(0, 1), (1, 0), (1, 1)]
    assert stacked(vec2(np.float32([1, 2]), np.float32(3))).tolist() == [[1, 3], [2, 3]]
    assert stacked(np.float32(3)).tolist() == [[3]]
