"""Which explanations fit, in which order, and how they are told."""

import pytest

from sss_ref.validation.cause.hypothesis import SOURCE, Charge, Hypothesis, any_of, fitting


def fits(share, kept=1.0, rank=0):
    return Hypothesis("told", share, kept, rank, SOURCE)


@pytest.mark.parametrize(
    ("share", "kept", "fit"), [(0.98, 1, True), (0.979, 1, False), (1, 0.98, True), (1, 0.979, False)]
)
def test_an_explanation_fits_if_nearly_all_is_within_reach_then(share, kept, fit):
    assert bool(fitting([fits(share, kept)])) is fit


def test_what_explains_all_comes_first_then_what_is_simple_then_what_explains_more():
    ranked = [
        fits(0.999, 1.0, 1),  # as good as all
        fits(1.0, 0.999, 4),
        fits(0.9989, 1.0, 0),
        fits(1.0, 0.9989, 0),
        fits(0.985, 0.99, 0),
        fits(0.98, 0.99, 0),
        fits(0.99, 0.975, 0),
        fits(0.9989, 0.9989, 2),
    ]
    assert sorted(ranked, key=lambda each: each.order) == ranked
    assert fits(0.999).order[0] is False and fits(0.9989).order[0] is True and fits(1.0, 0.9989).order[0] is True
    assert fits(0.99, 0.985, 3).order == (True, 3, -0.99 - 0.985)


def test_a_charge_becomes_an_explanation():
    charge = Charge("it is late", SOURCE, ("clock",))
    assert charge.fitting((0.5, 0.75), 2) == Hypothesis("it is late", 0.5, 0.75, 2, SOURCE, ("clock",))


@pytest.mark.parametrize(
    ("count", "told"),
    [
        (1, "0"),
        (4, "0, or 1, or 2, or 3"),
        (5, "0, or 1, or 2, or 3, or one of 1 more that compute the same"),
        (9, "0, or 1, or 2, or 3, or one of 5 more that compute the same"),
    ],
)
def test_of_many_that_compute_the_same_four_are_told(count, told):
    assert any_of([str(number) for number in range(count)]) == told
