"""What explains a wrong background, on buffers put together by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from checked import check_of

from sss_ref.validation.cause import beside

OUTSIDE = np.array([[True, True, False], [True, True, True]])
EXPECTED = np.zeros((2, 3, 2), np.float32)


def told(monkeypatch, got, written=(), stencil="coverage", outside=OUTSIDE):
    """What is said of a buffer; written: what its stage gives where it should not run, for the pixels asked for."""
    asked = []

    def run_stage(drawn, at, buffer):
        asked.append([part.tolist() for part in at])
        return SimpleNamespace(written={buffer: SimpleNamespace(columns=np.array(written))})

    monkeypatch.setattr(beside, "run_stage", run_stage)
    drawn = SimpleNamespace(this_pass=SimpleNamespace(draw=SimpleNamespace(stencil=stencil)))
    return [*beside.backgrounds(check_of(EXPECTED, got, outside=outside), drawn)], asked


def picture(*pixels):
    """The buffer with these values at the pixels outside, two numbers each, row by row."""
    got = EXPECTED.copy()
    got[OUTSIDE] = pixels
    return got


def test_a_right_background_needs_no_explanation(monkeypatch):
    assert told(monkeypatch, EXPECTED) == ([], [])
    assert told(monkeypatch, EXPECTED + np.float32(1), outside=None) == ([], [])


def test_one_that_is_the_same_all_over_is_cleared_to_that(monkeypatch):
    found, asked = told(monkeypatch, picture(*[(0.5, 2)] * 5))
    assert found == [("it is cleared to (0.5, 2.0), not to (0.0, 0.0)", 1.0)] and not asked


RELATIVE = 2.0**-16


@pytest.mark.parametrize(
    ("off", "share"),
    [([(0, 0)] * 3, 1), ([(0.9, 0), (0, -0.9), (0, 0)], 1), ([(1.1, 0), (0, 0), (0, -1.1)], 1 / 3), ([(9, 9)] * 3, 0)],
)
def test_another_is_what_the_pass_draws_beside_its_stencil(monkeypatch, off, share):
    """Of its five pixels three are wrong."""
    got = picture((0, 0), (4, 2), (8, -2), (0, 0), (16, 2))
    values = got[[0, 1, 1], [1, 0, 2]].astype(np.float64)
    found, asked = told(monkeypatch, got, values * (1 + RELATIVE * np.array(off)))
    assert found == [("the pass draws beside its stencil, coverage", share)]
    assert asked == [[[0, 1, 1], [1, 0, 2]]]


def test_what_is_as_close_as_may_be_is_drawn(monkeypatch):
    got = picture((0, 0), (1, 1), (0, 0), (0, 0), (2, 2))
    found, _ = told(monkeypatch, got, [(1 + RELATIVE, 1), (2 - 2 * RELATIVE, 2)])
    assert found[0][1] == 1


def test_a_pass_without_a_stencil_draws_beside_none(monkeypatch):
    assert told(monkeypatch, picture((0, 0), (1, 1), (0, 0), (0, 0), (2, 2)), stencil="") == ([], [])
