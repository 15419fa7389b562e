"""The sum over several lights, worked by hand."""

from one_stage import call

from sss_ref.passes.light_sum import plus


def test_plus():
    assert call(plus, first=(0.5, -1, 0), second=(0.25, 1, 2)) == ((0.75, 0, 2),)
