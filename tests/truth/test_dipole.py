"""The dipole's density adds up to its reflectance."""

import numpy as np
import pytest

from sss_ref.truth.dipole import dipole, dipole_density, dipole_reflectance, internal_reflectance
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume

SKIN1 = (0.436, 0.227, 0.131)  # printed as .44, .22, .13 by Jensen et al., table 1


def test_the_density_adds_up_to_the_reflectance():
    for volume in volumes("skin1"):
        source = dipole(volume)
        radius = np.linspace(0, 1, 20_001) ** 3 * 60
        rings = np.pi * np.diff(radius**2)
        total = (dipole_density(source, (radius[1:] + radius[:-1]) / 2) * rings).sum()
        assert total == pytest.approx(dipole_reflectance(source), rel=1e-4)  # of the midpoint rule


def test_the_reflectance_of_skin_is_the_published_one():
    found = [dipole_reflectance(dipole(volume)) for volume in volumes("skin1")]
    assert found == pytest.approx(SKIN1, abs=5e-4)


def test_no_border_throws_nothing_back():
    assert internal_reflectance(1.0) == 0
    assert internal_reflectance(1.3) == pytest.approx(0.44476, abs=1e-5)
    assert dipole(Volume(1.0, 0.1)).border == 1


def test_anisotropy_goes_into_the_reduced_coefficient():
    assert dipole(Volume(10.0, 0.1, 0.75)) == dipole(Volume(2.5, 0.1))
