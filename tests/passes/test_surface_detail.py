"""The stages of normal map and specular map, worked by hand."""

import numpy as np
import pytest
from one_stage import call

from sss_ref.passes.surface_detail import normal_mapped, specular_mapped

MIDDLE = {"uv": (0.5, 0.5), "normal_scale": (1, 1)}


def one_texel(*color):
    return np.float32([[color]])


@pytest.mark.parametrize(
    ("texel", "w", "expected"),
    [
        ((0.5, 0.5, 1), 1, (0, 0, 1)),  # straight up: the normal of the surface
        ((1, 0.5, 0.5), 1, (1, 0, 0)),  # along the tangent
        ((0.5, 1, 0.5), 1, (0, 1, 0)),  # across it: cross(z, x) = y
        ((0.5, 1, 0.5), -1, (0, -1, 0)),  # seen in a mirror
        ((0.5, 0, 0.5), -1, (0, 1, 0)),
        ((0.5, 1, 0.5), 0, (0, 1, 0)),  # between corners of both kinds
        ((0.5, 1, 0.5), 0.25, (0, 1, 0)),
        ((0.5, 1, 0.5), -0.25, (0, -1, 0)),
        ((0.5, 0.5, 0.5), 1, (0, 0, 0)),  # a texel without direction
    ],
)
def test_normal_mapped(texel, w, expected):
    # T = (2, 0, 5) loses what it has along N = (0, 0, 1) and becomes (1, 0, 0).
    inputs = {"unmapped_normal_world": (0, 0, 1), "fragment_tangent": (2, 0, 5, w), "normal_map": one_texel(*texel)}
    assert call(normal_mapped, **inputs, **MIDDLE) == (expected,)


def test_the_strength_bends():
    # (1, .5, .5) -> x = 1, y = 0, z = 0; (0.875, 0.5, 1) -> (.75, 0, 1), scaled by 2 (1.5, 0, 1), length sqrt(3.25).
    inputs = {"unmapped_normal_world": (0, 0, 1), "fragment_tangent": (1, 0, 0, 1), "uv": (0.5, 0.5)}
    length = np.sqrt(np.float32(3.25))
    expected = (np.float32(1.5) / length, 0, np.float32(1) / length)
    assert call(normal_mapped, normal_map=one_texel(0.875, 0.5, 1), normal_scale=(2, 1), **inputs) == (expected,)


def test_without_a_tangent_the_normal_stays():
    inputs = {
        "unmapped_normal_world": (0, 1, 0),
        "fragment_tangent": (0, 3, 0, 1),
        "normal_map": one_texel(1, 0.5, 0.5),
    }
    assert call(normal_mapped, **inputs, **MIDDLE) == ((0, 1, 0),)


def test_specular_mapped():
    # Halfway between texels of .25 and .75.
    picture = np.float32([[[0.25] * 3, [0.75] * 3]])
    assert call(specular_mapped, uv=(0.5, 0.5), specular_map=picture, specular=3) == (1.5,)
