"""The stages of translucency, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.language import vec3
from sss_ref.passes.translucency import (
    lit_add,
    lit_multiply,
    lit_transmit,
    translucency_beer,
    translucency_exponent,
    translucency_gaussians,
    translucency_ratio,
)

MATERIAL = {"x": 2, "y": -1, "exponent": 0.5, "d_min": 0.25, "translucency_neutral": 1}
SHADED = {"directly_lit": False, "shadow_uv": (0, 0.5)}
OUTSIDE = (-1, -1)
FROM_BEHIND = {"position_world": (0, 0, 0), "normal_world": (0, 0, 1), "light_position": (0, 0, -2)}


@pytest.mark.parametrize(
    ("thickness", "expected"),
    [
        (4, 0.25),  # 2^-1 / 4^.5 = .5/2
        (0.25, 1),  # 2^-1 / .25^.5 = .5/.5
        (0.125, 1),  # as thin as d_min
        (0, 1),
    ],
)
def test_translucency_ratio(thickness, expected):
    assert call(translucency_ratio, thickness=thickness, **SHADED, **MATERIAL) == (expected,)


def test_translucency_ratio_with_the_papers_exponent():
    # 32^.6 = 8, but .6 rounded to float32 is .60000002384: 8*2^(5*2.384e-8) = 8.00000066, nearest to 8.000001.
    assert call(translucency_ratio, thickness=32, **SHADED, **{**MATERIAL, "y": 3, "exponent": 0.6}) == (
        np.float32(8) / np.float32(8.000001),
    )


@pytest.mark.parametrize(
    ("thickness", "expected"),
    [
        (4, 4),  # 2^(4 / 4^.5) = 2^2
        (1, 16),  # 2^(4/1)
        (0, 256),  # 2^(4 / .25^.5) = 2^8
    ],
)
def test_translucency_exponent(thickness, expected):
    assert call(translucency_exponent, thickness=thickness, **SHADED, **{**MATERIAL, "y": 4}) == (expected,)


def test_translucency_beer():
    # e^(-2*.5) = 0.36787944117...
    beer = {**SHADED, "x": 2, "translucency_neutral": 1}
    assert call(translucency_beer, thickness=0.5, **beer) == (np.float32(0.36787944117),)
    assert call(translucency_beer, thickness=0, **beer) == (1,)
    assert call(translucency_beer, thickness=1e30, **beer) == (0,)


GAUSSIANS = {"gaussian_weight": [[0.5, 0.25, 0], [0.25, 0.5, 1]], "gaussian_variance": [4, 16], "gaussian_count": 2}


def test_translucency_gaussians():
    # d = 2 units of 2 mm: e^(-16/4) = 0.01831563889, e^(-16/16) = 0.36787944117; .5*a + .25*b, .25*a + .5*b, b.
    inputs = {**SHADED, **GAUSSIANS, "mm_per_unit": 2, "translucency_neutral": 0}
    ((red, green, blue),) = call(translucency_gaussians, thickness=2, **inputs)
    assert (red, green) == pytest.approx((0.10112767974, 0.18851863031), rel=1e-7)
    assert blue == np.float32(0.36787944117)
    assert call(translucency_gaussians, thickness=0, **inputs) == ((0.75, 0.75, 1),)
    assert call(translucency_gaussians, thickness=1e30, **inputs) == ((0, 0, 0),)
    assert call(translucency_gaussians, thickness=2, **{**inputs, "directly_lit": True}) == ((0, 0, 0),)


def test_one_number_for_each_channel():
    three = translucency_ratio.retyped(x=vec3, y=vec3, exponent=vec3, d_min=vec3, translucency=vec3)
    # 2^-1 / 4^.5, 3^2 / 4^1, 1^5 / 16^2 for its d_min.
    material = {"x": (2, 3, 1), "y": (-1, 2, 5), "exponent": (0.5, 1, 2), "d_min": (0.25, 0, 16)}
    assert call(three, thickness=4, **SHADED, **material, translucency_neutral=1) == ((0.25, 2.25, 1 / 256),)
    lit = {**SHADED, "directly_lit": True}
    assert call(three, thickness=4, **lit, **material, translucency_neutral=1) == ((1, 1, 1),)


@pytest.mark.parametrize("neutral", [0, 1])
@pytest.mark.parametrize(("directly_lit", "shadow_uv"), [(True, (0, 0.5)), (True, OUTSIDE), (False, OUTSIDE)])
@pytest.mark.parametrize("stage", [translucency_ratio, translucency_exponent, translucency_beer])
def test_where_no_light_comes_through_it_is_neutral(stage, directly_lit, shadow_uv, neutral):
    inputs = {**MATERIAL, "translucency_neutral": neutral}
    inputs = {name: value for name, value in inputs.items() if name in stage.parameters}
    assert call(stage, thickness=4, directly_lit=directly_lit, shadow_uv=shadow_uv, **inputs) == (neutral,)


def test_bounded_by_the_largest_half_float():
    huge = {**MATERIAL, "x": 3, "y": 90}  # 3^90 = 8.7e42 is infinite as float32
    assert call(translucency_ratio, thickness=1, **SHADED, **huge) == (65504,)
    assert call(translucency_exponent, thickness=1, **SHADED, **huge) == (65504,)
    assert call(translucency_beer, thickness=1, **SHADED, x=-12, translucency_neutral=1) == (65504,)  # e^12 = 162755


def test_lit_multiply():
    assert call(lit_multiply, phong=(0.5, 1, 2), directly_lit=True, translucency=0.25) == ((0.5, 1, 2),)
    assert call(lit_multiply, phong=(0.5, 1, 2), directly_lit=False, translucency=0.25) == ((0.125, 0.25, 0.5),)


@pytest.mark.parametrize(
    ("light_position", "expected"),
    [
        ((0, 0, 2), (0.25, 0.5, 1)),  # N.L = 1: nothing is added
        ((2, 0, 0), (0.75, 1, 1.25)),  # N.L = 0: albedo*(4*.25) is
        ((0, 0, -2), (0.75, 1, 1.25)),  # N.L = -1 counts as 0
    ],
)
def test_lit_add(light_position, expected):
    inputs = {**FROM_BEHIND, "light_position": light_position}
    inputs |= {"phong": (0.25, 0.5, 1), "albedo": (0.5, 0.5, 0.25), "translucency": 4, "translucency_scale": 0.25}
    assert call(lit_add, **inputs) == (expected,)


@pytest.mark.parametrize(
    ("directly_lit", "light_position", "expected"),
    [
        # Ambient .5/2*albedo = (.125, .125, .0625), plus albedo*e*(4*.125)*1 = (.5, 1, 1)*.5.
        (False, (0, 0, -2), (0.375, 0.625, 0.5625)),
        (True, (0, 0, -2), (0.5, 1, 1.5)),  # phong instead of ambient
        (False, (0, 0, 2), (0.125, 0.125, 0.0625)),  # from the front nothing is transmitted
        (True, (0, 0, 2), (0.25, 0.5, 1)),
    ],
)
def test_lit_transmit(directly_lit, light_position, expected):
    inputs = {**FROM_BEHIND, "light_position": light_position, "directly_lit": directly_lit}
    inputs |= {"phong": (0.25, 0.5, 1), "albedo": (0.5, 0.5, 0.25), "incident_light": (1, 2, 4)}
    inputs |= {"translucency": 4, "translucency_scale": 0.125, "ambient": 0.5, "light_count": 2}
    assert call(lit_transmit, **inputs) == (expected,)
