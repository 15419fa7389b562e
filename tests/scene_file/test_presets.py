"""What a preset fills in, in a scene that says next to nothing, and what goes with the figures' passes alone."""

import pytest
from filled_scenes import PRESETS, are_filled_as_ever

from sss_ref.scene_file.layers import filled
from sss_ref.scene_file.presets import misfits

FIXED = {  # key -> its value with preset published, and another
    "material": (None, "wax"),
    "mesh.normal_map": (None, "a.png"),
    "mesh.specular_map": (None, "a.png"),
    "shadow_map.filter": ("bilinear", "nearest"),
    "shadow_map.test": ("exact", "slope"),
    "shadow_map.encoding": ("unorm8", "float32"),
    "shadow_map.lookup_stage": ("vertex", "fragment"),
    "translucency.form": ("exponent", "ratio"),
    "translucency.combine": ("add", "transmit"),
    "translucency.d_min": (0.0, 0.1),
    "blur.unit": ("pixel", "mm"),
    "blur.follow_surface": (False, True),
    "blur.mask": ("none", "taps"),
    "irradiance_map.mode": ("distance", "paper"),
    "irradiance_map.image": ("sqrt_add", "sqrt"),
    "irradiance_map.dilate": (0, 4),
}
NOT_ELSEWHERE = [  # whose value there no other preset has
    "shadow_map.test",
    "shadow_map.encoding",
    "shadow_map.lookup_stage",
    "translucency.d_min",
    "irradiance_map.image",
]


def with_key(key, value, **data):
    table, _, name = key.rpartition(".")
    return {**data, table: {name: value}} if table else {**data, name: value}


def wrong_paths(data):
    return [".".join(map(str, path)) for path, _ in misfits(filled(data))]


def test_presets_fill_in_as_ever(tmp_path):
    are_filled_as_ever(PRESETS, tmp_path)


@pytest.mark.parametrize("key", FIXED)
def test_where_the_passes_of_the_figures_are_fixed(key):
    fixed, other = FIXED[key]
    assert wrong_paths(with_key(key, fixed, preset="published")) == []
    assert wrong_paths(with_key(key, other, preset="published")) == [key]
    for preset in ("paper", "robust"):
        assert wrong_paths(with_key(key, fixed, preset=preset)) == [key] * (key in NOT_ELSEWHERE)
        assert wrong_paths(with_key(key, other, preset=preset)) == []


def test_one_of_three_channels_may_be_fixed_too():
    assert wrong_paths({"translucency": {"d_min": [0.1, 0.1, 0.0]}}) == ["translucency.d_min"]
    assert wrong_paths({"translucency": {"d_min": [0.1, 0.1, 0.2]}}) == []


@pytest.mark.parametrize(
    ("given", "wrong"),
    [
        ({"lights": [{}]}, []),
        ({"lights": [{"type": "point", "falloff": "none"}]}, []),
        ({"lights": [{}, {}]}, ["lights"]),
        ({"lights": [{"type": "directional"}]}, ["lights.0.type"]),
        ({"lights": [{}, {"falloff": "inverse_square"}]}, ["lights", "lights.1.falloff"]),
        ({"lights": 7}, []),
        ({"layers": [{}]}, ["layers"]),
        ({"layers": []}, []),
        ({"camera": {"type": "orthographic"}}, ["camera.type"]),
        ({"camera": {"type": "free"}}, []),
    ],
)
def test_what_the_figures_are_drawn_with(given, wrong):
    assert wrong_paths({"preset": "published", **given}) == wrong
    assert wrong_paths(given) == []
