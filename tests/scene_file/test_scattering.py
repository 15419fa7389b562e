import pytest
from pydantic import ValidationError

from sss_ref.scene_file.kernels import HBH09, normalized
from sss_ref.scene_file.profiles import SKIN
from sss_ref.scene_file.scattering import Blur, TranslucencySettings


def test_parameters_survive_rounding_to_float32():
    with pytest.raises(ValidationError):
        TranslucencySettings(form="beer", combine="add", x=1e-46, y=1, scale=1, d_min=1)
    with pytest.raises(ValidationError):
        TranslucencySettings(form="beer", combine="add", x=1, y=2.0**128 - 2.0**103, scale=1, d_min=1)
    y = float.fromhex("0x1.fffffefffffffp127")  # the largest number that still rounds to the largest float32
    assert TranslucencySettings(form="beer", combine="add", x=1e-45, y=y, scale=1, d_min=1).y == y


ONE = {"form": "ratio", "combine": "add", "x": 1, "y": 1, "scale": 1, "d_min": 1}


def test_one_number_or_three_for_each_channel():
    assert not TranslucencySettings(**ONE).by_channel
    for key in ("x", "y", "exponent", "scale", "d_min"):
        three = TranslucencySettings(**{**ONE, key: [1, 2, 3]})
        assert three.by_channel and getattr(three, key) == (1, 2, 3)
    assert TranslucencySettings(**{**ONE, "form": "gaussians"}).by_channel


@pytest.mark.parametrize("wrong", [[1, 2], [1, 2, 3, 4], [1, -2, 3], [1, True, 3], True])
def test_channels_that_are_none(wrong):
    with pytest.raises(ValidationError):
        TranslucencySettings(**{**ONE, "x": wrong})


def test_terms_of_a_sum_of_gaussians():
    assert TranslucencySettings(**ONE).terms == SKIN
    own = TranslucencySettings(**ONE, gaussians=[[2, 1, 0.5, -0.5]])
    assert own.terms == ((2, 1, 0.5, -0.5),)
    for wrong in ([], [[0, 1, 1, 1]], [[1, 1, 1]], [[1, 1, 1, 1]] * 65, "water"):
        with pytest.raises(ValidationError):
            TranslucencySettings(**ONE, gaussians=wrong)


def test_a_surface_is_followed_by_lengths():
    with pytest.raises(ValidationError, match=r'expected false with blur\.unit = "pixel"; set blur\.unit = "mm"'):
        Blur(kernel="hbh09", pixel_scale=1, mask="taps", follow_surface=True)
    assert Blur(kernel="hbh09", pixel_scale=1, mask="taps", unit="mm", follow_surface=True).follow_surface


def test_reach_is_that_of_the_farthest_tap():
    assert Blur(kernel=[[3, -4, 1, 1, 1], [0, 4, 1, 1, 1]], pixel_scale=9, mask="none").reach == 5


def test_taps_stay_within_reach_in_their_own_unit():
    far = [[2000, 0, 1, 1, 1]]
    with pytest.raises(ValidationError, match="taps within 16384 pixels"):
        Blur(kernel=far, pixel_scale=9, mask="none")
    assert Blur(kernel=far, pixel_scale=9, unit="mm", mask="none").reach == 2000  # where pixel_scale says nothing
    for unit, scale in (("pixel", 2), ("mm", 9)):
        farthest = 8192 if unit == "pixel" else 16384
        assert Blur(kernel=[[0, -farthest, 1, 1, 1]], pixel_scale=scale, unit=unit, mask="none").reach == farthest
        with pytest.raises(ValidationError, match=r"taps within 16384 pixels \(the farthest is at"):
            Blur(kernel=[[0, -farthest - 0.5, 1, 1, 1]], pixel_scale=scale, unit=unit, mask="none")


def test_taps_of_a_blur():
    own = [[0, 0, 1, 2, 4], [1, 0, 3, 2, 4]]
    blur = Blur(kernel=own, pixel_scale=1, mask="none")
    assert blur.taps == ((0, 0, 1, 2, 4), (1, 0, 3, 2, 4))
    assert Blur(kernel=own, pixel_scale=1, mask="none", normalize=True).taps == (
        (0, 0, 0.25, 0.5, 0.5),
        (1, 0, 0.75, 0.5, 0.5),
    )
    assert Blur(kernel="hbh09", pixel_scale=1, mask="none", normalize=True).taps == normalized(HBH09)
