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
