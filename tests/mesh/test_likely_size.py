from pathlib import Path

import numpy as np
import pytest
from scenes import cube, written

from sss_ref.mesh.likely_size import LikelySize
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.scene_file.presets import ROBUST

BUST = Path(__file__).parents[2] / "data" / "meshes" / "bust.glb"


def test_the_longest_side_is_a_quarter_of_a_metre(tmp_path):
    """A box of 2 x 6 x 1 units: 250 mm / 6 = 41.666... mm a unit, and 1.5 % of 6 is 0.09."""
    positions, triangles = cube()
    path = written(tmp_path / "box.obj", positions * (1, 3, 0.5) + (7, 0, -9), triangles)
    assert LikelySize.of(load_mesh(Path(path))) == LikelySize(6.0, 41.7, 0.09)


def test_the_share_of_d_min_is_that_of_preset_robust_on_the_bust():
    bust = LikelySize.of(load_mesh(BUST))
    assert round(bust.d_min, 2) == ROBUST["translucency"]["d_min"]


@pytest.mark.parametrize("unit", [1e-30, 1e30])
def test_any_unit(tmp_path, unit):
    positions, triangles = cube()
    size = LikelySize.of(load_mesh(Path(written(tmp_path / "cube.obj", positions * unit, triangles))))
    assert np.float32(size.longest) == np.float32(2 * unit)
    assert (size.mm_per_unit, size.d_min) == (float(f"{125 / unit:.3g}"), float(f"{0.03 * unit:.3g}"))
