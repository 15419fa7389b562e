"""What may stand at pixels that may show one of several pieces, alternative by alternative."""

import numpy as np

from sss_ref.validation.accept.alternatives import Alternatives
from sss_ref.validation.accept.known import KnownBuffer

WHERE = np.array([[True, False], [True, True]])
AT = np.array([0, 1, 1]), np.array([0, 0, 1])
AGREE, NONE = np.ones(3, bool), np.zeros(3, bool)


def alternatives():
    return Alternatives.none_yet(WHERE, {"a": KnownBuffer.exactly(np.zeros((2, 2), np.float32))})


def column(*values):
    return np.array(values, float)[:, None]


def ends(found):
    return found.ends("a")[..., 0].tolist()


def test_alternatives_that_agree_count_alone():
    found = alternatives()
    found.add(AT, np.array([True, False, True]), {"a": (column(1, 2, 3), column(1.5, 2.5, 3.5))})
    found.add(AT, np.array([False, False, True]), {"a": (column(-9, 1, 2), column(9, 4, 3))})
    assert ends(found) == [[1, 1, 2], [1.5, 4, 3.5]]


def test_where_none_agrees_any_may_have_been_drawn():
    found = alternatives()
    found.add(AT, NONE, {"a": (column(1, 2, 3), column(1, 2, 3))})
    found.add(AT, NONE, {"a": (column(0, 5, 3), column(0, 5, 3))})
    assert ends(found) == [[0, 2, 3], [1, 5, 3]]
    found.add(AT, AGREE, {"a": (column(7, 7, 7), column(7, 7, 7))})
    assert ends(found) == [[7, 7, 7]] * 2


def test_they_may_be_of_some_pixels():
    found = alternatives()
    found.add((np.array([1]), np.array([1])), np.array([True]), {"a": (column(4), column(5))})
    found.add((np.array([0]), np.array([0])), np.array([True]), {"a": (column(1), column(2))})
    assert ends(found) == [[1, np.inf, 4], [2, -np.inf, 5]]


def test_buffers_have_channels():
    colours = KnownBuffer.exactly(np.zeros((2, 2, 3), np.float32))
    assert Alternatives.none_yet(WHERE, {"a": colours}).ends("a").shape == (2, 3, 3)
