"""Where the paper's power holds, and the laws of a slab that only absorbs."""

import numpy as np
import pytest

from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume
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
