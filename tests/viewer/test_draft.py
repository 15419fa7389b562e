"""Small pictures while something moves: how large, and that they show what the large one does."""

import numpy as np
import pytest
from tabs import SMALL

from sss_ref.rendering.fold import render
from sss_ref.scene.load import load_scene
from sss_ref.viewer.draft import SIDES, SLOWEST, Pace
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
