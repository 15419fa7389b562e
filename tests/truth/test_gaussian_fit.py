"""Sums of Gaussians that are known are found again, and those of skin come near to its profile."""

import numpy as np
import pytest

from sss_ref.scene.load import load_scene
from sss_ref.truth.gaussian_fit import COUNT, fitted_gaussians
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import REFLECTED
from sss_ref.truth.searchlight import RadialProfile, beam, searchlight
from sss_ref.truth.tally import nothing_walked


def of_gaussian(variance):
    """The profile of one Gaussian, as if a million photons had left by it."""
    empty = nothing_walked(beam(volumes("skin2")[0]))
    within = -np.expm1(-np.square(np.array(empty.of.radii)) / (2 * variance))
    empty.counts[REFLECTED, 1] = np.rint(1e6 * np.diff(within, prepend=0, append=1)).astype(np.int64)
    return RadialProfile(empty)


def test_one_gaussian_is_spread_over_its_neighbours_alone():
    found = fitted_gaussians([of_gaussian(0.5), of_gaussian(1.0), of_gaussian(2.0)])
    rows = np.array(found.rows)
    assert max(found.misplaced) < 0.01
    for channel, variance in zip(rows[:, 1:].T, (0.5, 1.0, 2.0), strict=True):
        assert (channel * rows[:, 0]).sum() == pytest.approx(variance, rel=0.02)  # r^2 has the mean 2*v


def test_of_skin():
    profiles = [searchlight(volume, 20_000, diffuse=True) for volume in volumes("skin2")]
    found = fitted_gaussians(profiles)
    rows = np.array(found.rows)
    assert rows.shape == (COUNT, 4) and (np.diff(rows[:, 0]) > 0).all()
    assert rows[:, 1:].sum(axis=0) == pytest.approx([1, 1, 1], abs=1e-5)  # six decimals each
    assert max(found.misplaced) < 0.06
    for profile, weights, misplaced in zip(profiles, rows[:, 1:].T, found.misplaced, strict=True):
        middle = profile.quantile(0.5)
        assert abs(0.5 - weights @ -np.expm1(-(middle**2) / (2 * rows[:, 0]))) < misplaced + 1e-3  # four digits of v
    profile = [list(row) for row in found.rows]
    assert load_scene("sphere", method="gaussian_texture", **{"diffusion.profile": profile})


def test_few_photons_give_the_same_rows():
    """Six weights to six digits and a variance to four, of 400 photons; what is said to be off is so."""
    found = fitted_gaussians([searchlight(volume, 400, diffuse=True) for volume in volumes("skin1")])
    assert [row[0] for row in found.rows] == [0.0001232, 0.001293, 0.01357, 0.1424, 1.494, 15.68]
    assert np.array(found.rows)[:, 1:] == pytest.approx(
        np.array(
            [
                (0.02594, 0.052035, 0.096226),
                (0.0, 0.0, 0.0),
                (0.04934, 0.089929, 0.208384),
                (0.165654, 0.358126, 0.355976),
                (0.348947, 0.404671, 0.339415),
                (0.410119, 0.095239, 0.0),
            ]
        ),
        abs=1.5e-6,
    )
    assert found.misplaced == pytest.approx([0.0321293449, 0.0576938066, 0.0748057004], abs=1e-9)
