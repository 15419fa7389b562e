"""Six Gaussians on the layout, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.passes.gaussian_blur import gaussian_along, irradiance_of_gaussians, normal_at_light

MAP = np.repeat(np.float32([[8, 2, 4, 0]])[..., None], 3, axis=2)
CHARTS = np.uint8([[1, 1, 1, 0]])
WEIGHTS = np.float32([0, 0, 0.25, 0.5, 0.25, 0, 0])  # of all seven taps only the middle ones
PLACES = np.float32([[k, 0] for k in range(-3, 4)])
ROW = {
    "irradiance": MAP,
    "irradiance_mask": CHARTS,
    "spread_offset": PLACES,
    "spread_weight": WEIGHTS,
    "spread_mm": 2,
    "pixel": (1, 0),
}


def test_gaussian_along():
    # Taps a texel apart: a quarter of 8, half of 2, a quarter of 4.
    assert call(gaussian_along, texels_per_mm=(0.5, 9), **ROW) == ((4, 4, 4),)
    # Half a texel apart: (8 + 2)/2 and (2 + 4)/2 beside 2.
    assert call(gaussian_along, texels_per_mm=(0.25, 9), **ROW) == ((3, 3, 3),)
    # Beside the chart nothing counts: (.25*2 + .5*4)/.75; where nothing is on a chart, what is there stays.
    end = {**ROW, "pixel": (2, 0)}
    assert call(gaussian_along, texels_per_mm=(0.5, 9), **end)[0][0] == np.float32(2.5) / np.float32(0.75)
    bare = {**ROW, "irradiance_mask": np.zeros_like(CHARTS)}
    assert call(gaussian_along, texels_per_mm=(0.5, 9), **bare) == ((2, 2, 2),)


def test_between_four_texels():
    """A quarter and three quarters of a texel away: 3/16, 1/16, 9/16 and 3/16 of them, or of those on a chart."""
    four = np.pad(np.float32([[16, 32], [64, 128]]), 1, constant_values=1000)
    irradiance = np.repeat(four[..., None], 3, axis=2)
    offsets = {"spread_offset": np.tile(np.float32([[0.25, 0.75]]), (7, 1)), "texels_per_mm": (1, 1), "spread_mm": 1}
    square = {**ROW, **offsets, "irradiance": irradiance, "pixel": (1, 1)}
    for beside, expected in (
        (None, 3 + 2 + 36 + 24),
        ((1, 1), 62 / (13 / 16)),
        ((1, 2), 63 / (15 / 16)),
        ((2, 1), 29 / (7 / 16)),
        ((2, 2), 41 / (13 / 16)),
    ):
        charts = np.ones((4, 4), np.uint8)
        if beside:
            charts[beside] = 0
        assert call(gaussian_along, **{**square, "irradiance_mask": charts})[0][0] == np.float32(expected)


def test_the_other_axis():
    upright = {name: np.swapaxes(ROW[name], 0, 1) for name in ("irradiance", "irradiance_mask")}
    column = {**ROW, **upright, "pixel": (0, 1), "spread_offset": PLACES[:, ::-1]}
    assert call(gaussian_along, texels_per_mm=(9, 0.5), **column) == ((4, 4, 4),)
    assert call(gaussian_along, texels_per_mm=(0.5, 0.5), **{**column, "spread_offset": PLACES}) == ((2, 2, 2),)


def test_normal_at_light():
    assert call(normal_at_light, fragment_normal=(0, 0, 4)) == ((0, 0, 1),)
    assert call(normal_at_light, fragment_normal=(0, 0, 0)) == ((0, 0, 0),)


FLAT = np.ones((1, 1, 3), np.float32)
FRAGMENT = {
    **{f"spread_{letter}": FLAT * 2**k for k, letter in enumerate("abcdef")},
    "profile_weight": np.float32([[1, 0, 0], [0.5, 1, 0], [0, 0, 1], [0, 0, 0], [0, 0, 0], [0, 0.25, 0]]),
    "profile_variance": np.float32([1, 4, 9, 16, 25, 36]),
    "uv": (0.5, 0.5),
    "irradiance_uv": (0.5, 0.5),
    "shadow_uv": (0.5, 0.5),
    "position_world": (0, 0, 0),
    "light_position": (0, 0, 5),
    "mm_per_unit": 2,
}


def used(facing, shadow_valid=True, thickness=0.0, entered=(0, 0, 0)):
    light_normal = np.float32([[entered]])
    scene = {"shadow_valid": shadow_valid, "thickness": thickness, "light_normal": light_normal}
    return call(irradiance_of_gaussians, **FRAGMENT, **scene, normal_world=facing)[0]


def test_irradiance_of_gaussians():
    # Red 1*1 + 2*.5, green 2*1 + 32*.25, blue 4*1; from behind nothing comes to what faces the light, nor from nowhere,
    # nor where both ends are one place.
    own = (2, 10, 4)
    assert used((0, 0, 1), thickness=3) == used((0, 0, -1), shadow_valid=False, thickness=3) == own
    assert used((0, 0, -1)) == own
    # 18 mm away, blue has sigma 3 and counts in full: 4 times e^(-18^2/18) more, opposite or not, at N.L = -1.
    for entered in ((0, 0, 0), (0, 0, 1)):
        assert used((0, 0, -1), thickness=9, entered=entered)[2] == 4 + 4 * np.float32(np.exp(-18.0))
    # Askew, at N.L = -.6, opposite ends are 1.8 mm apart where the way is 3: e^(-.18), and 3/18 of it.
    (_, _, blue) = used((0.8, 0, -0.6), thickness=1.5, entered=(-0.8, 0, 0.6))
    np.testing.assert_allclose(blue, 4 + 4 * np.exp(-(1.8**2) / 18) / 6, rtol=1e-6)
    (_, _, blue) = used((0.8, 0, -0.6), thickness=1.5, entered=(0.8, 0, -0.6))
    np.testing.assert_allclose(blue, 4 + 4 * np.exp(-(3.0**2) / 18) / 6, rtol=1e-6)
