"""The keys that are fitted to a material: what is in them, and which law of translucency is nearer."""

import pytest

from sss_ref.scene.load import load_scene
from sss_ref.truth.material_fit import fitted_material
from sss_ref.truth.media import volumes
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
