"""Small pictures while something moves: how large, and that they show what the large one does."""

import numpy as np
import pytest
from tabs import SMALL

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.viewer.draft import SIDES, SLOWEST, Pace, draft_settings
from sss_ref.viewer.studio import smaller


def test_the_pace_finds_the_largest_size_that_is_fast_enough():
    pace = Pace()
    for _ in range(30):
        pace.took(SLOWEST * (pace.side / 200) ** 2)  # 200^2 take as long as a draft may
    assert pace.side == 192
    for _ in range(30):
        pace.took(9.0)
    assert pace.side == min(SIDES)
    for _ in range(30):
        pace.took(0.001)
    assert pace.side == max(SIDES)


def test_the_pace_rests_where_it_is_right():
    pace, seen = Pace(), []
    for _ in range(40):
        pace.took(SLOWEST * (pace.side / 256) ** 2 * 0.99)
        seen.append(pace.side)
    assert set(seen[5:]) == {256}


@pytest.mark.parametrize("method", ["screen_space", "texture_space"])
def test_a_small_picture_looks_as_the_large_one(method):
    size = dict.fromkeys(SMALL, 256)
    large = load_scene("figure3_with", method=method, **size)
    small = smaller(large, 64)
    camera = small.settings.camera
    assert (camera.width, camera.height, small.settings.shadow_map.width) == (64, 64, 64)
    one, other = render(large).image, render(small).image
    averaged = one.reshape(64, 4, 64, 4, 3).mean((1, 3))
    assert np.abs(averaged - other).mean() < 0.02 < np.ptp(averaged)


def test_a_picture_that_is_small_enough_stays_what_it_is():
    scene = load_scene("default", **SMALL)
    assert smaller(scene, 64) is scene


def test_a_thin_picture_keeps_a_pixel():
    scene = load_scene("default", **SMALL | {"camera.width": 900, "camera.height": 2})
    assert (smaller(scene, 96).settings.camera.width, smaller(scene, 96).settings.camera.height) == (96, 1)


def test_what_counts_in_pixels_or_texels_shrinks_with_them():
    changes = {"blur.unit": "pixel", "blur.follow_surface": False, "blur.pixel_scale": 2.0, "camera.width": 256}
    scene = load_scene("figure3_with", **changes, **{"shadow_map.width": 1024, "shadow_map.height": 512})
    small = smaller(scene, 128).settings
    assert small.blur.pixel_scale == 2.0 * 128 / max(256, scene.settings.camera.height)
    assert small.shadow_map.kernel_scale == scene.settings.shadow_map.kernel_scale / 8
    assert small.shadow_map.lookup_depth == scene.settings.shadow_map.lookup_depth / 8
    assert (small.shadow_map.width, small.shadow_map.height) == (128, 64)


def sides(seconds, count=14):
    """The sides of drafts that all take as long."""
    pace = Pace()
    for _ in range(count):
        yield pace.side
        pace.took(seconds)


def test_the_sides_of_drafts():
    assert [*sides(9.0)] == [256, 224, 192, 160, 128, *[96] * 9]
    assert [*sides(0.0)] == [256, 320, 384, 448, 512, *[768] * 9]


@pytest.mark.parametrize(
    ("seconds", "side"),
    [(0.030, 256), (0.0301, 224), (0.01536, 256), (0.0153, 320)],  # of which .8 of .03 s would be taken: .0154
)
def test_how_long_a_draft_may_take(seconds, side):
    assert [*sides(seconds, 2)][1] == side


def test_maps_that_are_small_enough_stay_as_they_are():
    """Each by its own longer side; a blur in texture space counts in charts."""
    sizes = {"camera.width": 400, "camera.height": 300, "shadow_map.width": 64, "shadow_map.height": 100}
    charts = {"irradiance_map.width": 200, "irradiance_map.height": 500}
    scene = load_scene("figure3_with", method="texture_space", **sizes, **charts)
    before, after = scene.settings, draft_settings(scene.settings, 100)
    assert (after.camera.width, after.camera.height) == (100, 75)
    assert after.shadow_map == before.shadow_map
    assert (after.irradiance_map.width, after.irradiance_map.height) == (40, 100)
    assert after.blur.pixel_scale == before.blur.pixel_scale * 0.2
    assert draft_settings(before, 600).camera is before.camera
    tall = load_scene("figure3_with", method="texture_space", **sizes | {"shadow_map.height": 200}, **charts)
    halved = draft_settings(tall.settings, 100).shadow_map
    assert (halved.width, halved.height, halved.kernel_scale) == (32, 100, before.shadow_map.kernel_scale / 2)
    wide = load_scene("figure3_with", method="texture_space", **sizes, **dict.fromkeys(charts, 60))
    kept = draft_settings(wide.settings, 100)
    assert kept.irradiance_map == wide.settings.irradiance_map and kept.blur == wide.settings.blur


@pytest.mark.parametrize(("side", "is_same"), [(400, True), (401, True), (399, False)])
def test_a_picture_as_large_as_a_draft_is_no_draft(side, is_same):
    settings = load_scene("default", **SMALL | {"camera.width": 300, "camera.height": 400}).settings
    assert (draft_settings(settings, side) is settings) == is_same
