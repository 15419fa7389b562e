"""Pre-integrated skin, worked by hand."""

import numpy as np
from one_stage import call

from sss_ref.passes.preintegrated_skin import directly_lit_round, phong_preintegrated, surface_curvature


def test_surface_curvature():
    # g.P + c = .5*2 + 1 = 2 per unit of 4 mm.
    planes = np.float32([[9, 9, 9, 9], [0.5, 0, 0, 1]])
    scene = {"triangle": 1, "triangle_curvature": planes, "mm_per_unit": 4}
    assert call(surface_curvature, **scene, position_world=(2, 7, 7), sharpest_curvature=3) == (0.5,)
    assert call(surface_curvature, **scene, position_world=(2, 7, 7), sharpest_curvature=0.25) == (0.25,)
    assert call(surface_curvature, **scene, position_world=(-3, 7, 7), sharpest_curvature=3) == (0,)


SHADOW = {
    "light_position": (0, 0, 2),
    "light_clip_from_world": np.float32([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    "light_texel_size": 0.125,
    "bias_abs": 0.25,
    "bias_slope": 1,
    "position_world": (0, 0, 0),
}


def test_directly_lit_round():
    # It faces the light: 2 units away, allowed to lie .25 + .125 behind what is stored.
    for stored, lit in ((1.625, True), (1.5, False)):
        assert call(directly_lit_round, **SHADOW, normal_world=(0, 0, 1), stored_distance=stored) == (lit,)
        # It faces away, or lies across: whatever is stored, the table decides.
        for normal in ((0, 0, -1), (1, 0, 0)):
            assert call(directly_lit_round, **SHADOW, normal_world=normal, stored_distance=stored) == (True,)


def test_directly_lit_round_close_to_the_light():
    # At w = 1/2 a texel is half as wide: .25 + .0625. Behind the light, w < 0, it has no width.
    for w, allowed in ((0.5, 0.3125), (-1, 0.25)):
        clip_from_world = np.diag(np.float32([1, 1, 1, w]))
        for behind, lit in ((allowed, True), (allowed + 2**-10, False)):
            inputs = {**SHADOW, "light_clip_from_world": clip_from_world, "stored_distance": 2 - behind}
            assert call(directly_lit_round, **inputs, normal_world=(0, 0, 1)) == (lit,)


TABLE = np.float32([[[0, 0, 0], [0, 0, 0], [1, 1, 1]], [[0, 0, 0], [0.5, 0.25, 0], [1, 0.5, 0.5]]])
SHADED = {
    "position_world": (0, 0, 0),
    "albedo": (1, 1, 0.5),
    "camera_position": (0, 0, -1),
    "incident_light": (2, 2, 2),
    "diffusion_table": TABLE,
    "sharpest_curvature": 0.5,
    "ambient": 0.5,
    "diffuse": 1,
    "specular": 0,
    "shininess": 1,
    "light_count": 2,
}


def test_phong_preintegrated():
    def of(light, curvature):
        return call(phong_preintegrated, **SHADED, light_position=light, curvature=curvature, normal_world=(0, 0, 1))[0]

    # Ambient .5/2, then twice the table: its right end, its middle in each row, half way between both rows.
    assert of((0, 0, 3), 0) == (2.25, 2.25, 1.125)
    assert of((3, 0, 0), 0) == (0.25, 0.25, 0.125)
    assert of((3, 0, 0), 0.5) == (1.25, 0.75, 0.125)
    assert of((3, 0, 0), 0.25) == (0.75, 0.5, 0.125)
    assert of((0, 0, -3), 0.5) == (0.25, 0.25, 0.125)
