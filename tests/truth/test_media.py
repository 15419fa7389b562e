"""Names of media."""

import pytest

from sss_ref.errors import SceneError
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume


def test_a_name_is_three_volumes():
    assert volumes("skin1")[0] == Volume(0.74, 0.032, 0.0, 1.3)
    assert volumes("marble", ior=1.0)[2] == Volume(3.00, 0.0071, 0.0, 1.0)


def test_another_name_is_told_the_nearest():
    with pytest.raises(SceneError, match="material: expected the name of a medium, got 'skin'; did you mean skin"):
        volumes("skin")


MEASURED = {  # Jensen et al. (2001), table 1: reduced scattering and absorption per mm, of red, green and blue
    "skin1": ((0.74, 0.88, 1.01), (0.032, 0.17, 0.48), 1.3),
    "skin2": ((1.09, 1.59, 1.79), (0.013, 0.070, 0.145), 1.3),
    "marble": ((2.19, 2.62, 3.00), (0.0021, 0.0041, 0.0071), 1.5),
    "milk": ((2.55, 3.21, 3.77), (0.0011, 0.0024, 0.014), 1.3),
}


@pytest.mark.parametrize("name", MEASURED)
def test_what_was_measured(name):
    scattering, absorption, ior = MEASURED[name]
    assert volumes(name) == tuple(Volume(s, a, 0, ior) for s, a in zip(scattering, absorption, strict=True))
