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


def test_few_photons_give_the_same_kernel():
    """Of 400 photons; a weight for the middle and one for each of three rings of points."""
    found = fitted_kernel([searchlight(volume, 400, diffuse=True) for volume in volumes("skin1")])
    assert (found.disc, found.mm_per_offset) == pytest.approx((0.931349584541489, 0.9548290849613026), rel=1e-9)
    assert found.misplaced == pytest.approx([0.0616200973, 0.0472036418, 0.0335046183], abs=1e-9)
    assert found.published_mm == pytest.approx([1.2382601253, 2.2709790829, 2.9450955025], abs=1e-9)
    assert found.published_misplaced == pytest.approx([0.1254421803, 0.1358743404, 0.1346033359], abs=1e-9)
    weights = np.array(found.taps)[:, 2:]
    middle, near, between, far = weights[0], weights[3], weights[1], weights[7]
    assert np.array([middle, near, between, far]) == pytest.approx(
        np.array(
            [
                (0.000487, 0.000007, 0.001111),
                (0.097208, 0.179775, 0.226162),
                (0.122246, 0.112533, 0.089433),
                (0.056858, 0.020512, 0.008684),
            ]
        ),
        abs=1.5e-6,
    )
    assert {tuple(row) for row in weights} == set(map(tuple, (middle, near, between, far)))
    assert weights[4].tolist() == weights[5].tolist() == near.tolist()
