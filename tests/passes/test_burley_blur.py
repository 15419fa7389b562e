"""Normalized diffusion on the picture, worked by hand where e^x is exact or cancels."""

import numpy as np
from one_stage import call

from sss_ref.passes.burley_blur import scatter_burley

LIT = np.repeat(np.float32([[8, 2, 4]])[..., None], 3, axis=2)
FLAT = np.zeros((1, 3, 3), np.float32)
SCENE = {
    "lit": LIT,
    "coverage": np.uint8([[1, 1, 1]]),
    "position_world": FLAT,
    "pixel": (1, 0),
    "scatter_distance": (1, 1, 2),
    "reach_mm": 2,
    "pixels_per_offset": 1,
    "ahead": (0, 0, -0.5),
}


def samples(*rows):
    """The uniforms of samples (x, y, radius, area)."""
    table = np.float32(rows)
    columns = {"sample_place": table[:, :2], "sample_radius": table[:, 2], "sample_area": table[:, 3]}
    return {**columns, "sample_count": len(rows)}


BESIDE = samples((-1, 0, 1, 3), (1, 0, 1, 1))


def test_scatter_burley():
    # Both lie 1 mm away, where R is the same: three parts of 8 and one of 4.
    assert call(scatter_burley, **SCENE, **BESIDE) == ((7, 7, 7),)
    # A sample beside the model, or so far behind that nothing comes from there, does not count.
    assert call(scatter_burley, **SCENE | {"coverage": np.uint8([[0, 1, 1]])}, **BESIDE) == ((4, 4, 4),)
    behind = FLAT.copy()
    behind[0, 0] = (0, 0, -1e6)
    assert call(scatter_burley, **SCENE | {"position_world": behind}, **BESIDE) == ((4, 4, 4),)
    # Where none counts the pixel keeps its own.
    assert call(scatter_burley, **SCENE | {"coverage": np.uint8([[0, 1, 0]])}, **BESIDE) == ((2, 2, 2),)


def test_a_sample_reads_the_nearest_texel():
    near = samples((-0.5, 0, 1, 1))
    assert call(scatter_burley, **SCENE, **near) == ((2, 2, 2),)  # half a pixel left belongs to the pixel itself
    assert call(scatter_burley, **SCENE | {"pixels_per_offset": 1.25}, **near) == ((8, 8, 8),)


def test_a_sample_behind_counts_by_its_distance_in_space():
    # The left one lies 3 mm to the side and 4 behind: 5 mm away, R = (e^-5 + e^(-5/3))/5, against (e^-1 + e^(-1/3))/1.
    behind = FLAT.copy()
    behind[0, 0] = (0, 0, 4)
    beside = samples((-1, 0, 3, 1), (1, 0, 1, 1))
    ((red, _, blue),) = call(scatter_burley, **SCENE | {"position_world": behind}, **beside)
    for found, d in ((red, 1.0), (blue, 2.0)):
        far, near = ((np.exp(-r / d) + np.exp(-r / (3 * d))) / r for r in (5.0, 1.0))
        np.testing.assert_allclose(found, (8 * far + 4 * near) / (far + near), rtol=1e-6)
