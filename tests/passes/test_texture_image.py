"""The stages that make the picture from the irradiance map, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.passes.texture_image import (
    gloss_where_lit,
    image_product,
    image_sqrt,
    irradiance_added,
    irradiance_lookup,
    irradiance_replaced,
)

LIGHT_UV = np.float32([[(0.25, 0.75), (0.5, 0.125)]])  # a shadow map of two texels
IRRADIANCE = np.float32([[(1, 2, 4), (3, 4, 8)]])  # and an irradiance map of two

# Half way between both texels lie (2, 3, 6); the entry point lies in the middle of the left one.
UVS = {"uv": (0.5, 0.5), "irradiance_uv": (0.25, 0.5), "scattered_irradiance": IRRADIANCE}


@pytest.mark.parametrize(
    ("lit", "valid", "expected"),
    [(True, True, (1, 0)), (True, False, (1, 0)), (False, False, (1, 0)), (False, True, (0.5, 0.125))],
)
def test_irradiance_lookup(lit, valid, expected):
    inputs = {"uv": (1, 0), "shadow_uv": (0.75, 0.5), "light_uv": LIGHT_UV}
    assert call(irradiance_lookup, **inputs, directly_lit=lit, shadow_valid=valid) == (expected,)


@pytest.mark.parametrize(("shadow_uv", "expected"), [((0.49, 1), (0.25, 0.75)), ((0.5, 0), (0.5, 0.125))])
def test_irradiance_lookup_does_not_blend(shadow_uv, expected):
    inputs = {"uv": (1, 0), "shadow_uv": shadow_uv, "light_uv": LIGHT_UV}
    assert call(irradiance_lookup, **inputs, directly_lit=False, shadow_valid=True) == (expected,)


def test_irradiance_replaced():
    assert call(irradiance_replaced, **UVS, directly_lit=True, translucency=0.5) == ((2, 3, 6),)
    assert call(irradiance_replaced, **UVS, directly_lit=False, translucency=0.5) == ((0.5, 1, 2),)


def test_irradiance_replaced_at_the_edge_of_the_map():
    for uv, expected in (((0, 0), (1, 2, 4)), ((1, 1), (3, 4, 8)), ((0.25, 0), (1, 2, 4)), ((0.625, 1), (2.5, 3.5, 7))):
        assert call(irradiance_replaced, **{**UVS, "uv": uv}, directly_lit=True, translucency=9) == (expected,)


def test_irradiance_added():
    # From behind, N.L = -.5: (2, 3, 6) + (1, 2, 4) * ((4*.25)*.5).
    inputs = {**UVS, "translucency": 4, "translucency_scale": 0.25, "position_world": (0, 0, 0)}
    behind = {"normal_world": (0, 0, -0.5), "light_position": (0, 0, 4)}
    assert call(irradiance_added, **inputs, **behind) == ((2.5, 4, 8),)
    # From before, nothing comes through.
    assert call(irradiance_added, **inputs, **{**behind, "normal_world": (0, 0, 0.5)}) == ((2, 3, 6),)


def test_image_sqrt():
    # A negative product, as a kernel with negative weights may give, is black.
    assert call(image_sqrt, irradiance_used=(0.5, 2, -1), phong=(0.5, 8, 1)) == ((0.5, 4, 0),)


def test_gloss_where_lit():
    # The normal is of length .75: R = (0, 0, -1) + (0, 0, .75)*1.5 mirrored is (0, 0, .125), V.R = .125, squared 1/64.
    inputs = {
        "position_world": (0, 0, 0),
        "normal_world": (0, 0, 0.75),
        "light_position": (0, 0, 2),
        "camera_position": (0, 0, 3),
        "incident_light": (1, 2, 4),
        "specular": 0.5,
        "shininess": 2,
    }
    assert call(gloss_where_lit, **inputs, directly_lit=True) == ((1 / 128, 1 / 64, 1 / 32),)
    assert call(gloss_where_lit, **inputs, directly_lit=False) == ((0, 0, 0),)
    behind = {**inputs, "light_position": (0, 0, -2)}
    assert call(gloss_where_lit, **behind, directly_lit=True) == ((0, 0, 0),)


def test_image_product():
    # ((.25 + i) + gloss)*albedo: (.25 + .5 + .25)*.5, (.25 + .25 + 0)*1, (.25 + 0 + .5)*2.
    inputs = {"irradiance_used": (0.5, 0.25, 0), "gloss": (0.25, 0, 0.5), "albedo": (0.5, 1, 2)}
    assert call(image_product, **inputs, ambient=0.25) == ((0.5, 0.5, 1.5),)
