"""What render targets keep: the neighbours of a value, and the values that have a given neighbour."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sss_ref.numerics.interval import Interval, point
from sss_ref.numerics.storage import before_storage, stored

F = np.float32


def kept(x, encoding):
    """What a target that rounds to nearest holds."""
    if encoding == "float16":
        return float(np.float16(x))
    steps = {"unorm8": 255, "unorm16": 65535}[encoding]
    return float(F(np.rint(min(max(x, 0.0), 1.0) * steps) / steps))


@pytest.mark.parametrize("encoding", ["float16", "unorm8", "unorm16"])
@given(x=st.floats(-2, 2, width=32), up=st.floats(0, 0.5, width=32))
@settings(max_examples=200)
def test_a_target_holds_a_neighbour_and_a_neighbour_tells_of_the_value(encoding, x, up):
    held = kept(x, encoding)
    holds = stored(Interval(np.float64(x), np.float64(x + up)), encoding)
    assert holds.low <= held <= holds.high
    given = before_storage(np.array([held], F), encoding)
    assert given.low[0] <= x <= given.high[0]


def test_by_hand():
    eight = stored(point(np.array([0.5, 0.0, 1.0, -3.0, 7.0])), "unorm8")
    assert np.allclose(eight.low * 255, [127, 0, 255, 0, 255]) and np.allclose(eight.high * 255, [128, 0, 255, 0, 255])
    half = stored(point(np.array([1.0, 1.0001, 1e6, -1e6])), "float16")
    assert half.low.tolist() == [1.0, 1.0, 65504.0, -np.inf]
    assert half.high.tolist() == [1.0, 1.0 + 2.0**-10, np.inf, -65504.0]
    back = before_storage(np.array([0.0, 1.0, 51 / 255]), "unorm8")
    assert back.low[:2].tolist() == [-np.inf, 254 / 255] and back.high[:2].tolist() == [1 / 255, np.inf]
    assert (back.low[2], back.high[2]) == (50 / 255, 52 / 255)
    assert before_storage(np.array([1.0]), "float16").low[0] == 1 - 2.0**-11


def test_float32_is_kept():
    a = point(np.array([0.1], F))
    assert stored(a, "float32") is a
    assert before_storage(a.low, "float32").is_point
