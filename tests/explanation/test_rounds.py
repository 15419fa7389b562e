"""Of a pass that runs in rounds the last one is explained: what it reads is what the one before has written."""

from types import SimpleNamespace

import pytest

from sss_ref.explanation import explain


def in_rounds(count):
    """A pass whose rounds each add one to a number; what is read in the first is 10."""

    def folded(buffers, shaded):
        for _ in range(count):
            buffers = shaded(buffers)

    return SimpleNamespace(fed_back={"n": "n"}, folded=folded)


@pytest.mark.parametrize(("count", "read"), [(1, 10), (2, 11), (5, 14)])
def test_what_the_last_round_reads(monkeypatch, count, read):
    monkeypatch.setattr(explain, "shade", lambda scene, this_pass, fragments, buffers, *rest: {"n": buffers["n"] + 1})
    result = SimpleNamespace(scene=None, buffers={"n": 10})
    assert explain._inputs(result, in_rounds(count), None) == {"n": read}


def test_without_a_round_nothing_is_read_and_without_feedback_the_buffers_are():
    result = SimpleNamespace(scene=None, buffers={"n": 10})
    assert explain._inputs(result, in_rounds(0), None) is None
    assert explain._inputs(result, SimpleNamespace(fed_back={}), None) is result.buffers
