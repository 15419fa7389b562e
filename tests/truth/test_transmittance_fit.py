"""Where the paper's power holds, and the laws of a slab that only absorbs."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from sss_ref.truth import transmittance_fit
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import TRANSMITTED, Volume
from sss_ref.truth.transmittance_fit import STEPS, fitted_transmittance

PAPER_AT = (1.5, 0.7, 0.35)  # mm, of skin1 without border, from slabs an octave apart


def test_the_papers_power_is_met_at_one_thickness_of_each_colour():
    for volume, at in zip(volumes("skin1", 1.0), PAPER_AT, strict=True):
        found = fitted_transmittance(volume, 30_000)
        assert found.paper_at == pytest.approx(at, rel=0.25)
        assert found.fading_worst < 0.2 < found.worst < 0.8


def test_a_law_is_as_wrong_as_it_says():
    found = fitted_transmittance(volumes("skin1", 1.0)[2], 20_000)
    law = found.factor / np.maximum(found.thickness, found.d_min) ** found.exponent
    certain = found.share > 10 * found.error
    assert np.abs(law / found.share - 1)[certain].max() == pytest.approx(found.worst, rel=1e-9)
    exponential = found.amplitude * np.exp(-found.fading * found.thickness)
    assert np.abs(exponential / found.share - 1)[certain].max() == pytest.approx(found.fading_worst, rel=1e-9)


def test_units_go_into_y():
    found = fitted_transmittance(volumes("skin1")[1], 5_000)
    for unit in (1.0, 150.0):
        d = 2.0 / unit
        assert 2 ** found.y(unit) / d**found.exponent == pytest.approx(found.factor / 2.0**found.exponent, rel=1e-12)


def test_thicknesses_are_diffusion_lengths_and_each_is_told():
    told = []
    found = fitted_transmittance(
        Volume(1.0, 0.5), 2_000, on_slab=lambda done, all_of_them: told.append((done, all_of_them))
    )
    assert found.thickness == pytest.approx(STEPS / 1.5, rel=1e-12)  # sqrt(3 * .5 * 1.5) = 1.5
    assert told == [(k, 13) for k in range(1, 14)]
    assert (np.diff(found.share) < 0).all()


LENGTHS = 2.0 ** np.arange(-4, 2.5, 0.5)  # the thicknesses in diffusion lengths; of UNIT these are mm
UNIT = Volume(0.0, 3**-0.5)


@pytest.fixture
def through(monkeypatch):
    """The fit to a law: thickness, mm -> what comes through, and how many times its standard error that is."""

    def fit(law, certainty=lambda d: 1e9):
        def slab(volume, thickness, photons, threads):
            share = law(thickness)
            return SimpleNamespace(
                share=lambda fate: share if fate == TRANSMITTED else 0.0,
                share_error=lambda fate: share / certainty(thickness),
            )

        monkeypatch.setattr(transmittance_fit, "slab", slab)
        return fitted_transmittance(UNIT, 1)

    return fit


def test_slabs_are_a_sixteenth_to_four_diffusion_lengths_thick(through):
    assert through(lambda d: 0.5 / d).thickness == pytest.approx(LENGTHS, rel=1e-12)


@pytest.mark.parametrize("first", [0, 4, 10])
def test_a_power_law_that_ends_is_found_again(through, first):
    """Three thicknesses are the fewest that a law is fitted to."""
    found = through(lambda d: 0.3 * max(d, LENGTHS[first]) ** -0.8)
    assert found.factor == pytest.approx(0.3, rel=1e-9) and found.exponent == pytest.approx(0.8, rel=1e-9)
    assert found.d_min == pytest.approx(LENGTHS[first], rel=1e-9) and found.worst < 1e-9


def test_an_exponential_is_found_again(through):
    """It falls by -d ln T / d ln d = k * (b - a) / ln(b/a) between a and b, so by .6 between .25 and .5."""
    found = through(lambda d: 0.9 * math.exp(-1.5 * d))
    assert found.amplitude == pytest.approx(0.9, rel=1e-9) and found.fading == pytest.approx(1.5, rel=1e-9)
    assert found.fading_worst < 1e-9 < found.worst
    near, far = (1.5 * (b - a) / math.log(b / a) for a, b in ((0.25, 0.125**0.5), (0.125**0.5, 0.5)))
    share = (0.6 - near) / (far - near)
    assert 0 < share < 1 and found.paper_at == pytest.approx(2.0 ** (-1.75 + share / 2), rel=1e-9)


def test_where_the_papers_power_is_nowhere_met(through):
    assert math.isnan(through(lambda d: d**-0.5).paper_at)
    assert math.isnan(through(lambda d: d**-0.7).paper_at)
    at_once = through(lambda d: d**-0.7 if d < 0.1 else 0.1**-0.3 * d**-0.4)
    assert at_once.paper_at == pytest.approx(2.0**-3.75, rel=1e-9)  # the middle of the first two


def test_what_is_known_to_less_than_a_tenth_counts(through):
    """At ten standard errors it does not."""

    def law(d):
        return 0.1 if 0.9 < d < 1.1 else 0.1 * d**-0.8

    def wrong(d):
        return 0.4 if 0.9 < d < 1.1 else law(d)

    assert through(wrong).worst > 0.1
    for errors, counts in ((10.0, False), (10.1, True)):
        found = through(wrong, lambda d, errors=errors: errors if 0.9 < d < 1.1 else 1e9)
        assert (found.worst > 0.1) == counts
        assert found.share[8] == 0.4 and found.error[8] == pytest.approx(0.4 / errors, rel=1e-12)


def test_the_largest_deviation_is_of_the_law_in_the_truth(through):
    """e^x - 1 of a logarithm that is x off: above the truth more than below."""
    found = through(lambda d: 0.5 * math.exp(-d) * (2.0 if d > 3.9 else 1.0))
    off = found.amplitude * np.exp(-found.fading * found.thickness) / found.share - 1
    assert found.fading_worst == pytest.approx(np.abs(off).max(), rel=1e-9)


def test_y_is_the_power_of_2_that_gives_the_factor_in_scene_units(through):
    found = through(lambda d: 0.25 * d**-0.5)
    assert found.y(1.0) == pytest.approx(-2, rel=1e-9) and found.y(16.0) == pytest.approx(-4, rel=1e-9)
