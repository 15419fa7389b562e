"""Kernels that are fitted come nearer than the published one, and 1.2 mm an offset is what its red wants."""

import numpy as np
import pytest

from sss_ref.scene_file.kernels import HBH09
from sss_ref.truth.kernel_fit import GROUPS, OFFSETS, fitted_kernel
from sss_ref.truth.media import volumes
from sss_ref.truth.searchlight import searchlight


@pytest.fixture(scope="module")
def skin():
    """Refractive index -> the kernel that is fitted to it."""
    profiles = {ior: [searchlight(volume, 30_000) for volume in volumes("skin1", ior)] for ior in (1.0, 1.3)}
    return {ior: fitted_kernel(each) for ior, each in profiles.items()}


def test_1_2_mm_an_offset_is_between_the_best_of_hbh09s_red_without_and_with_a_border(skin):
    """The kernel's green and blue are narrower than skin1's: alone they want more."""
    without, with_border = skin[1.0], skin[1.3]
    assert without.published_mm[0] < 1.2 < with_border.published_mm[0]
    assert without.published_mm[0] > 0.9 and with_border.published_mm[0] < 1.5
    assert min(with_border.published_mm[1:]) > 1.5


def test_the_fit_is_nearer_than_the_published_weights_and_as_round_as_the_points_allow(skin):
    found = skin[1.3]
    assert all(own < 0.6 * theirs for own, theirs in zip(found.misplaced, found.published_misplaced, strict=True))
    weights = np.array(found.taps)[:, 2:]
    assert weights.sum(axis=0) == pytest.approx([1, 1, 1], abs=1e-5)  # six decimals each
    assert all(len(set(map(tuple, weights[group == GROUPS]))) == 1 for group in range(4))
    assert [tap[:2] for tap in found.taps] == [tap[:2] for tap in HBH09]
    assert [GROUPS.tolist().count(group) for group in range(4)] == [1, 3, 3, 6] and OFFSETS[0] == 0


def test_twice_the_lengths_are_twice_the_scale(skin):
    """The same photons, as half the coefficients walk them: every length doubles."""
    half = [v._replace(scattering=v.scattering / 2, absorption=v.absorption / 2) for v in volumes("skin1", 1.3)]
    one, two = skin[1.3], fitted_kernel([searchlight(volume, 30_000) for volume in half])
    assert two.mm_per_offset == pytest.approx(2 * one.mm_per_offset, rel=1e-9)  # all other roundings
    assert two.misplaced == pytest.approx(one.misplaced, rel=1e-6)
