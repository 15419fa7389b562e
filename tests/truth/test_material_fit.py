"""The keys that are fitted to a material: what is in them, and which law of translucency is nearer."""

from types import SimpleNamespace

import pytest

from sss_ref.scene.load import load_scene
from sss_ref.truth.material_fit import MaterialFit, fitted_material
from sss_ref.truth.media import volumes
from sss_ref.truth.photon import Volume
from sss_ref.truth.searchlight import searchlight


@pytest.fixture(scope="module")
def skin():
    told = []
    found = fitted_material(volumes("skin2"), 2_000, diffuse=True, on_step=told.append)
    assert told == ["walking: red", "walking: green", "walking: blue", "fitting"]
    return found


@pytest.mark.parametrize("method", ["screen_space", "burley", "gaussian_texture"])
@pytest.mark.parametrize("law", ["ratio", "beer"])
def test_its_keys_are_a_scenes(skin, method, law):
    settings = load_scene("sphere", method=method, **skin.keys(10.0, law)).settings
    assert settings.translucency.form == law and settings.mm_per_unit == 10
    assert settings.mesh.color == pytest.approx(skin.color, rel=1e-12)


def test_the_mean_free_path_is_the_mediums(skin):
    assert skin.keys(1.0)["diffusion"]["mean_free_path_mm"] == [
        1 / (1.09 + 0.013),
        1 / (1.59 + 0.07),
        1 / (1.79 + 0.145),
    ]


def test_the_nearer_law_has_the_smaller_of_the_largest_deviations(skin):
    power, fading = (max(getattr(law, name) for law in skin.laws) for name in ("worst", "fading_worst"))
    assert fading < power and skin.nearer_law == "beer"


def test_light_from_all_sides_leaves_more_often_than_a_beam():
    """It is scattered nearer to the surface."""
    volume = volumes("skin2", 1.0)[1]
    beam, wide = (searchlight(volume, 4_000, diffuse=diffuse) for diffuse in (False, True))
    assert wide.reflectance - beam.reflectance > 4 * (wide.reflectance_error + beam.reflectance_error)


def known(colors=(0.5, 0.25, 0.0), worst=((0.1, 0.3), (0.2, 0.1), (0.1, 0.1))):
    """A fit of given numbers; a profile's quantile is ten times its share and color, a thickness is doubled in y."""
    profiles = [SimpleNamespace(reflectance=c, quantile=lambda share, c=c: 10 * share * (c + 1)) for c in colors]
    laws = [
        SimpleNamespace(
            exponent=0.5 + k, d_min=1.5 * k, fading=0.25 + k, amplitude=0.5 + k, worst=power, fading_worst=fading,
            y=lambda unit, k=k: unit + k,
        )
        for k, (power, fading) in enumerate(worst)
    ]  # fmt: skip
    kernel, gaussians = SimpleNamespace(mm_per_offset=1.25, taps="taps"), SimpleNamespace(rows="rows")
    media = Volume(0.75, 0.25), Volume(1.5, 0.5), Volume(2.0, 2.0)
    return MaterialFit(media, tuple(profiles), tuple(laws), kernel, gaussians)


def test_the_keys_of_a_fit():
    """4 mm a unit; what leaves again is divided out of T, and of black a billionth."""
    found = known().keys(4.0)
    assert (found["mm_per_unit"], found["mesh"]) == (4, {"color": [0.5, 0.25, 0.0]})
    assert found["blur"] == {"unit": "mm", "mm_per_offset": 1.25, "kernel": "taps"}
    assert found["diffusion"] == {
        "profile": "rows",
        "reach_mm": pytest.approx(10 * 0.99 * 1.5, rel=1e-12),
        "albedo": [0.5, 0.25, 0.0],
        "mean_free_path_mm": [1, 0.5, 0.25],
    }
    assert found["translucency"] == {
        "form": "ratio",
        "combine": "transmit_wrapped",
        "wrap": 0,
        "x": 2,
        "y": [4, 5, 6],
        "exponent": [0.5, 1.5, 2.5],
        "d_min": [0, 0.375, 0.75],
        "scale": [2, 4, 1 / 1e-9],
    }


def test_the_exponential_has_its_amplitude_in_the_scale():
    assert known().keys(4.0, "beer")["translucency"] == {
        "form": "beer",
        "combine": "transmit_wrapped",
        "wrap": 0,
        "x": [1, 5, 9],
        "scale": [1, 6, 2.5 / 1e-9],
    }


@pytest.mark.parametrize(("power", "fading", "nearer"), [(0.1, 0.2, "ratio"), (0.2, 0.1, "beer"), (0.2, 0.2, "beer")])
def test_the_worst_channel_decides_between_the_laws(power, fading, nearer):
    assert known(worst=((0.0, 0.0), (power, 0.0), (0.0, fading))).nearer_law == nearer


def test_it_is_walked_straight_down_unless_it_is_asked_for():
    found = fitted_material(volumes("skin2"), 50)
    assert not found.profiles[0].tally.of.setup.diffuse and found.profiles[0].tally.photons == 50
