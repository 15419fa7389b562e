import numpy as np
import pytest

from sss_ref.interpret.finite import is_finite
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language.pipeline import Pass, ScreenDraw

LARGEST = np.finfo(np.float32).max


def work_with(**outputs):
    """A pass without stages that has filled these buffers."""
    height, width = next(iter(outputs.values())).shape[:2]
    return Work(Pass("none", "camera", ScreenDraw(), ()), Fragments(width, height), {}, {}, outputs, {})


def test_finite_numbers_pass():
    numbers = np.float32([[0.0, -0.0, 1e-45], [LARGEST, -LARGEST, 3.0]])
    assert is_finite(work_with(first=numbers, second=np.dstack([numbers] * 3)))


@pytest.mark.parametrize("bad", [np.nan, -np.nan, np.inf, -np.inf])
def test_every_value_is_looked_at(bad):
    for at in np.ndindex(4, 3, 3):
        numbers = np.full((4, 3, 3), LARGEST, np.float32)
        numbers[at] = bad
        work = work_with(first=np.zeros((4, 3), np.float32), second=numbers)
        assert not is_finite(work)
        assert [is_finite(work, slice(row, row + 2)) for row in (0, 2)] == [at[0] >= 2, at[0] < 2]


def test_integers_are_never_taken_for_floats():
    assert is_finite(work_with(triangle=np.array([[0x7F800000, -1]], np.int32)))
