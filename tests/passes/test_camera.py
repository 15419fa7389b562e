"""The stages of the surface and its colour, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.passes.camera import albedo_by_material, albedo_constant, albedo_textured, surface


def test_surface():
    # |(0, 3, 4)| = 5, so the unit normal is (0, 3/5, 4/5), each rounded once; all else passes through.
    position, normal, uv = call(
        surface, fragment_position=(1, 2, 3), fragment_normal=(0, 3, 4), fragment_uv=(0.25, 0.5)
    )
    assert normal == (0.0, np.float32(0.6), np.float32(0.8))
    assert (position, uv) == ((1, 2, 3), (0.25, 0.5))


def test_surface_without_normal():
    _, normal, _ = call(surface, fragment_position=(0, 0, 0), fragment_normal=(0, 0, 0), fragment_uv=(0, 0))
    assert normal == (0, 0, 0)  # not NaN: rule A3


def test_albedo_constant():
    assert call(albedo_constant, mesh_color=(0.75, 0.5, 0.25)) == ((0.75, 0.5, 0.25),)


# Two rows of four grey texels, the lower row first; a pixel between two texel centres is their mean.
GREYS = np.repeat(np.float32([[1, 2, 4, 8], [16, 32, 64, 128]])[..., np.newaxis], 3, axis=2)


@pytest.mark.parametrize(
    ("uv", "grey"),
    [
        ((0.375, 0.25), 2),  # the centre of texel (1, 0)
        ((0.5, 0.25), 3),  # between 2 and 4
        ((0.0, 0.25), 4.5),  # between the last texel and the first: (8 + 1) / 2
        ((1.0, 0.25), 4.5),
        ((-1e-30, 0.25), 4.5),  # u - floor(u) rounds to 1
        ((0.375, 0.0), 17),  # between the upper row and the lower one: (32 + 2) / 2
        ((-2.625, 7.25), 2),  # (1.5, 0.25) tiles away
    ],
)
def test_albedo_textured(uv, grey):
    assert call(albedo_textured, uv=uv, albedo_map=GREYS) == ((grey,) * 3,)


def test_albedo_by_material():
    red, green = (1, 0, 0), (0, 1, 0)
    for triangle, color in ((0, green), (1, red), (2, green)):
        inputs = {"triangle_material": [1, 0, 1], "material_color": [red, green]}
        assert call(albedo_by_material, triangle=triangle, **inputs) == (color,)
