import pytest
from pydantic import ValidationError

from sss_ref.scene_file.diffusion import Diffusion
from sss_ref.scene_file.profiles import PROFILES, SKIN


def test_a_profile_has_a_name_or_rows():
    assert Diffusion().gaussians == SKIN
    assert Diffusion(profile="milk").gaussians == PROFILES["milk"]
    assert Diffusion(profile=[[2, 1, 0.5, 0.1]]).gaussians == ((2, 1, 0.5, 0.1),)


@pytest.mark.parametrize("rows", [[[1, 1, 1, -0.5]], [[1, 1, 1, 0], [2, 1, 0, 0]], [], [[0, 1, 1, 1]]])
def test_a_profile_that_spreads_no_light(rows):
    with pytest.raises(ValidationError):
        Diffusion(profile=rows)


@pytest.mark.parametrize("taps", [1, 2, 24, 257, 3.0])
def test_taps_lie_on_both_sides_of_the_centre(taps):
    with pytest.raises(ValidationError):
        Diffusion(taps=taps)
