"""The stages of the composite pass, worked by hand."""

from one_stage import call

from sss_ref.passes.composite import glow, over_background


def test_over_background():
    inputs = {"scattered": (0.5, 0.25, 1), "background": (0.125, 0, 0.75)}
    assert call(over_background, coverage=True, **inputs) == ((0.5, 0.25, 1),)
    assert call(over_background, coverage=False, **inputs) == ((0.125, 0, 0.75),)


def test_glow():
    assert call(glow, scattered=(0.5, 0.25, 1)) == ((0.5, 0.25, 1),)
