"""The surface stage, worked by hand."""

import numpy as np

from passes.one_stage import call
from sss_ref.passes.camera import surface


def test_surface():
    # |(0, 3, 4)| = 5, so the unit normal is (0, 3/5, 4/5), each rounded once; all else passes through.
    position, normal, uv, albedo = call(
        surface,
        fragment_position=(1, 2, 3),
        fragment_normal=(0, 3, 4),
        fragment_uv=(0.25, 0.5),
        mesh_color=(0.75, 0.5, 0.25),
    )
    assert normal == (0.0, np.float32(0.6), np.float32(0.8))
    assert (position, uv, albedo) == ((1, 2, 3), (0.25, 0.5), (0.75, 0.5, 0.25))


def test_surface_without_normal():
    _, normal, *_ = call(
        surface, fragment_position=(0, 0, 0), fragment_normal=(0, 0, 0), fragment_uv=(0, 0), mesh_color=(1, 1, 1)
    )
    assert normal == (0, 0, 0)  # not NaN: rule A3
