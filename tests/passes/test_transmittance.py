"""The stages of light from behind that reaches every fragment, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.language import vec3
from sss_ref.passes.transmittance import (
    below_surface,
    irradiance_added_wrapped,
    irradiance_lookup_throughout,
    lit_transmit_wrapped,
    translucency_beer_throughout,
    translucency_exponent_throughout,
    translucency_gaussians_throughout,
    translucency_ratio_throughout,
)

MATERIAL = {"x": 2, "y": -1, "exponent": 0.5, "d_min": 0.25, "translucency_neutral": 0}
INSIDE, OUTSIDE = {"shadow_uv": (0, 0.5)}, {"shadow_uv": (-1, -1)}
EYE = np.eye(4, dtype=np.float32)
PERSPECTIVE = np.float32([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, -1, 0]])  # w = -z


def test_below_surface():
    # At w = 4 a texel is 4*.125 wide: three of them along the normal (0, .5, 0) are .75.
    inputs = {"normal_world": (0, 0.5, 0), "light_texel_size": 0.125, "lookup_depth": 3}
    at = {"position_world": (1, 2, -4), "light_clip_from_world": PERSPECTIVE}
    assert call(below_surface, **inputs, **at) == ((1, 1.25, -4),)
    # In parallel light w is 1; behind a light (w < 0) the map has no texels.
    assert call(below_surface, **inputs, **{**at, "light_clip_from_world": EYE}) == ((1, 1.8125, -4),)
    assert call(below_surface, **inputs, **{**at, "position_world": (1, 2, 4)}) == ((1, 2, 4),)


@pytest.mark.parametrize(("thickness", "expected"), [(4, 0.25), (0.125, 1), (0, 1)])
def test_translucency_ratio_throughout(thickness, expected):
    assert call(translucency_ratio_throughout, thickness=thickness, **INSIDE, **MATERIAL) == (expected,)


@pytest.mark.parametrize(("thickness", "expected"), [(4, 4), (1, 16), (0, 256)])
def test_translucency_exponent_throughout(thickness, expected):
    material = {**MATERIAL, "y": 4}
    assert call(translucency_exponent_throughout, thickness=thickness, **INSIDE, **material) == (expected,)


def test_translucency_beer_throughout():
    beer = {**INSIDE, "x": 2, "translucency_neutral": 0}
    assert call(translucency_beer_throughout, thickness=0.5, **beer) == (np.float32(0.36787944117),)  # e^-1
    assert call(translucency_beer_throughout, thickness=0, **beer) == (1,)


def test_translucency_gaussians_throughout():
    # d = 2 units of 2 mm: e^(-16/16) = 0.36787944117 times the weights.
    terms = {"gaussian_weight": np.float32([[1, 2, 0]]), "gaussian_variance": np.float32([16]), "gaussian_count": 1}
    inputs = {**terms, "mm_per_unit": 2, "translucency_neutral": 0}
    once = np.float32(0.36787944117)
    assert call(translucency_gaussians_throughout, thickness=2, **INSIDE, **inputs) == ((once, 2 * once, 0),)
    assert call(translucency_gaussians_throughout, thickness=2, **OUTSIDE, **inputs) == ((0, 0, 0),)


@pytest.mark.parametrize(
    "stage", [translucency_ratio_throughout, translucency_exponent_throughout, translucency_beer_throughout]
)
def test_neutral_outside_the_map_and_bounded_within(stage):
    inputs = {name: value for name, value in MATERIAL.items() if name in stage.parameters}
    assert call(stage, thickness=4, **OUTSIDE, **inputs) == (0,)
    huge = {name: value for name, value in {"x": 3, "y": 90}.items() if name in stage.parameters}
    huge |= {"x": -12} if stage is translucency_beer_throughout else {}
    assert call(stage, thickness=1, **INSIDE, **{**inputs, **huge}) == (65504,)


def test_one_number_for_each_channel():
    three = translucency_ratio_throughout.retyped(x=vec3, y=vec3, exponent=vec3, d_min=vec3, translucency=vec3)
    # 2^-1 / 4^.5, 3^2 / 4^1, 1^5 / 16^2 for its d_min.
    material = {"x": (2, 3, 1), "y": (-1, 2, 5), "exponent": (0.5, 1, 2), "d_min": (0.25, 0, 16)}
    assert call(three, thickness=4, **INSIDE, **material, translucency_neutral=0) == ((0.25, 2.25, 1 / 256),)
    assert call(three, thickness=4, **OUTSIDE, **material, translucency_neutral=0) == ((0, 0, 0),)


# With wrap = .25 the factor is max(.25 - N.L, 0) / 1.25: 1 at N.L = -1, .6 at -.5, .2 at 0, 0 from .25 on.
WRAPPED = {"translucency": 4, "translucency_scale": 0.125, "wrap": 0.25, "position_world": (0, 0, 0)}


@pytest.mark.parametrize(
    ("directly_lit", "light_position", "expected"),
    [
        # Ambient .5/2*albedo = (.125, .125, .0625), plus albedo*e*(4*.125)*1 = (.5, 1, 1)*.5.
        (False, (0, 0, -2), (0.375, 0.625, 0.5625)),
        (True, (0, 0, -2), (0.5, 1, 1.5)),  # phong instead of ambient
        (False, (0, 0, 2), (0.125, 0.125, 0.0625)),  # from the front nothing comes through
        (True, (0, 0, 2), (0.25, 0.5, 1)),
        # Along the surface the fifth part does, lit or not: (.5, 1, 1)*(.5*.2).
        (False, (2, 0, 0), np.float32([0.125, 0.125, 0.0625]) + np.float32([0.5, 1, 1]) * np.float32(0.1)),
        (True, (2, 0, 0), np.float32([0.25, 0.5, 1]) + np.float32([0.5, 1, 1]) * np.float32(0.1)),
    ],
)
def test_lit_transmit_wrapped(directly_lit, light_position, expected):
    inputs = {**WRAPPED, "light_position": light_position, "directly_lit": directly_lit, "normal_world": (0, 0, 1)}
    inputs |= {"phong": (0.25, 0.5, 1), "albedo": (0.5, 0.5, 0.25), "incident_light": (1, 2, 4)}
    assert call(lit_transmit_wrapped, **inputs, ambient=0.5, light_count=2) == (tuple(expected),)


@pytest.mark.parametrize(
    ("valid", "shadow_uv", "expected"),
    [(True, (0.49, 1), (0.25, 0.75)), (True, (0.5, 0), (0.5, 0.125)), (False, (0.5, 0), (1, 0))],
)
def test_irradiance_lookup_throughout(valid, shadow_uv, expected):
    light_uv = np.float32([[(0.25, 0.75), (0.5, 0.125)]])  # a shadow map of two texels
    inputs = {"uv": (1, 0), "shadow_uv": shadow_uv, "shadow_valid": valid, "light_uv": light_uv}
    assert call(irradiance_lookup_throughout, **inputs) == (expected,)


def test_irradiance_added_wrapped():
    # Half way between both texels lie (2, 3, 6), at the entry point (1, 2, 4); the factor is (4*.125)*1, then *0.
    uvs = {"uv": (0.5, 0.5), "irradiance_uv": (0.25, 0.5), "scattered_irradiance": np.float32([[(1, 2, 4), (3, 4, 8)]])}
    at = {"normal_world": (0, 0, -1), "light_position": (0, 0, 4)}
    assert call(irradiance_added_wrapped, **WRAPPED, **uvs, **at) == ((2.5, 4, 8),)
    assert call(irradiance_added_wrapped, **WRAPPED, **uvs, **{**at, "normal_world": (0, 0, 1)}) == ((2, 3, 6),)
