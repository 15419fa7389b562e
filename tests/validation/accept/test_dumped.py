"""What files tell of what shaders wrote and read, by hand."""

import numpy as np
import pytest

from sss_ref.dump.loss import Loss
from sss_ref.validation.accept.dumped import Drawing
from sss_ref.validation.accept.known import KnownBuffer

BYTE = 1 / 255
TENTH = Loss(least=0.1)


def test_file_and_texture_both_round():
    drawing = Drawing({}, {"lit": TENTH}, {"lit": Loss(least=0.25)})
    before = drawing.before("lit", np.float32([[1.0]]))
    assert np.allclose(np.ravel((before.low, before.high)), (0.65, 1.35), rtol=0, atol=1e-12)  # sums of floats
    exact = Drawing({}).before("lit", np.float32([[1.0]]))
    assert exact.low.tolist() == exact.high.tolist() == [[1]]


DIFFERENT = np.array([[False, False, True, True, True]])


@pytest.mark.parametrize("storages", [{"stored": {"lit": TENTH}}, {"rounded": {"lit": TENTH}}])
def test_what_storage_may_make_of_a_value_does_not_differ(storages):
    exact = np.float32([[1, 1, 1, 1, 1]])
    got = np.float32([[1, 1.09, 1.11, np.inf, np.nan]])
    assert np.array_equal(Drawing({"lit": got}, **storages).differs("lit", exact), DIFFERENT)


def test_without_storage_any_bit_differs():
    exact = np.float32([[[0, 1], [0, 1], [0, 1]]])
    got = np.float32([[[0, 1], [-0.0, 1], [0, 1 + 2.0**-23]]])
    assert Drawing({"lit": got}).differs("lit", exact).tolist() == [[False, True, True]]
    assert Drawing({}).differs("lit", exact).tolist() == [[False] * 3]


def test_one_channel_that_differs_is_enough():
    exact, got = np.float32([[[1, 1], [1, 1]]]), np.float32([[[1.05, 1.2], [1.05, 0.95]]])
    assert Drawing({"lit": got}, {"lit": TENTH}).differs("lit", exact).tolist() == [[True, False]]


def test_coarse_storages_are_those_that_round():
    drawing = Drawing({}, {"a": "float32", "b": "float16", "c": TENTH})
    assert drawing.coarse.stored == {"b": "float16", "c": TENTH}
    assert Drawing({}, {"a": "float16"}, {"a": "unorm8"}).texture("a") == "unorm8"
    assert drawing.texture("b") == "float16" and drawing.texture("d") == "float32"


def test_a_texture_of_bytes_is_read_with_its_span():
    buffer = np.float32([[0.5]])
    assert Drawing({}, {"a": "unorm8"}).as_read("a", buffer).span == 1
    plain = Drawing({}).as_read("a", buffer)
    assert plain.span == 0 and plain.is_exact
    rounded = Drawing({}, {"a": TENTH}, {"a": "unorm8"}).as_read("a", buffer)
    assert np.allclose(np.ravel((rounded.low, rounded.high)), (0.4, 0.6), rtol=0, atol=1e-7) and rounded.span == 1
    decoded = Drawing({}, {"a": "srgb8"}).as_read("a", buffer)
    assert decoded.low < 0.5 < decoded.high and decoded.exact is buffer


def test_what_was_not_dumped_was_kept_by_its_texture():
    given = KnownBuffer.exactly(np.float32([[0.5]]))
    kept = Drawing({}, {"a": "unorm8"}).kept("a", given)
    assert np.allclose(np.ravel((kept.low, kept.high)), (0.5 - BYTE, 0.5 + BYTE), rtol=0, atol=1e-12) and kept.span == 1
    assert Drawing({}).kept("a", given) is given


def test_a_stage_got_a_value_before_it_was_rounded():
    at = np.array([0]), np.array([1])
    drawing = Drawing({"a": np.float32([[1, 2]])}, {"a": TENTH})
    known = drawing.handed_on("a", float, at)
    ends = np.ravel((known.bounds.low, known.bounds.high))
    assert known.exact.tolist() == [2] and np.allclose(ends, (1.9, 2.1), rtol=0, atol=1e-12)
    plain = Drawing(drawing.buffers).handed_on("a", float, at)
    assert plain.bounds is plain.exact
