"""The stages of Phong shading, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.passes.phong import light_constant, light_inverse_square, phong_shading

SCENE = {
    "position_world": (0, 0, 0),
    "normal_world": (0, 0, 1),
    "albedo": (0.5, 0.5, 1),
    "light_position": (0, 0, 2),
    "camera_position": (0, 0, 3),
    "incident_light": (1, 2, 4),
    "ambient": 0.5,
    "diffuse": 0.75,
    "specular": 0.25,
    "shininess": 32,
    "light_count": 2,
}


def test_light_constant():
    assert call(light_constant, light_color=(1, 0.5, 0.25), light_intensity=3) == ((3, 1.5, 0.75),)


def test_light_inverse_square():
    inputs = {"light_position": (0, 0, 2), "light_color": (1, 0.5, 0.25), "light_intensity": 3}
    # D = 2, falloff 1/4.
    assert call(light_inverse_square, position_world=(0, 0, 0), **inputs) == ((0.75, 0.375, 0.1875),)
    # D = 0: 1 / 1e-8.
    ((red, _, _),) = call(light_inverse_square, position_world=(0, 0, 2), **inputs)
    assert red == np.float32(3) * (np.float32(1) / np.float32(1e-8))


def test_phong_shading():
    # N.L = V.R = 1: (.5/2 + e*.75 + e*.25)*albedo = (.25 + e)*albedo, that is 1.25/2, 2.25/2, 4.25.
    assert call(phong_shading, **SCENE) == ((0.625, 1.125, 4.25),)


def test_phong_shading_beside_the_highlight():
    # The eye on the surface's plane: V.R = 0, no highlight; (.25 + e*.75)*albedo.
    assert call(phong_shading, **{**SCENE, "camera_position": (3, 0, 0)}) == ((0.5, 0.875, 3.25),)


def test_phong_shading_has_no_highlight_at_a_right_angle_even_where_a_power_is_1():
    # Shininess 0: s = 1 wherever there is a highlight. Light along the surface, seen from where its mirror image is.
    inputs = {**SCENE, "shininess": 0}
    assert call(phong_shading, **{**inputs, "light_position": (2, 0, 0), "camera_position": (-3, 0, 0)}) == (
        (0.125, 0.125, 0.25),
    )
    assert call(phong_shading, **{**inputs, "camera_position": (3, 0, 0)}) == ((0.5, 0.875, 3.25),)
    assert call(phong_shading, **inputs) == ((0.625, 1.125, 4.25),)


def test_phong_shading_of_an_oblique_highlight():
    # V = (0, 4/5, 3/5), V.R = 3/5, shininess 2: s = .36; white light of intensity 1: .25 + .75 + .25*.36 = 1.09.
    inputs = {**SCENE, "camera_position": (0, 4, 3), "incident_light": (1, 1, 1), "albedo": (1, 1, 1), "shininess": 2}
    assert call(phong_shading, **inputs) == ((np.float32(1.09),) * 3,)


def test_phong_shading_turned_away():
    # N.L < 0: ambient alone, .5/2*albedo, though the eye sees the mirror image of the light from behind.
    inputs = {**SCENE, "light_position": (0, 0, -2), "camera_position": (0, 0, -3)}
    assert call(phong_shading, **inputs) == ((0.125, 0.125, 0.25),)


def test_phong_shading_at_the_light_and_without_normal():
    ambient = (0.125, 0.125, 0.25)
    assert call(phong_shading, **{**SCENE, "light_position": (0, 0, 0)}) == (ambient,)
    assert call(phong_shading, **{**SCENE, "normal_world": (0, 0, 0)}) == (ambient,)
