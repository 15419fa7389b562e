"""Pictures of a surface's detail at the border of what is refused."""

import numpy as np
import pytest
from bodies import body

from sss_ref.errors import SceneError
from sss_ref.scene import surface_maps
from sss_ref.scene.surface_maps import normal_map_of, specular_map_of

MESH = body([(0, 0, 0), (1, 0, 0), (0, 1, 0)], uvs=[(0, 0), (1, 0), (0, 1)])


@pytest.fixture
def texels(monkeypatch):
    """Has every picture hold these."""
    return lambda values: monkeypatch.setattr(surface_maps, "load_linear", lambda path: np.array(values, np.float32))


@pytest.mark.parametrize(("blue", "is_one"), [(0.5, False), (0.51, True), (1.0, True), (0.0, False)])
def test_one_texel_of_a_normal_map_points_outwards(tmp_path, texels, blue, is_one):
    texels([[(0.9, 0.9, 0.1), (0.9, 0.9, blue)]])
    if is_one:
        assert normal_map_of(MESH, tmp_path / "a.png").shape == (1, 2, 3)
    else:
        with pytest.raises(SceneError, match=r"expected a normal map, whose blue is above a half, got a\.png; check"):
            normal_map_of(MESH, tmp_path / "a.png")


@pytest.mark.parametrize("colored", [0, 1, 2])
def test_a_specular_map_has_three_channels_alike(tmp_path, texels, colored):
    grey = np.full((2, 2, 3), 0.25)
    texels(grey)
    assert specular_map_of(MESH, tmp_path / "a.png").tolist() == grey.tolist()
    grey[1, 1, colored] = 0.3
    texels(grey)
    with pytest.raises(SceneError, match=r"expected a grey picture, got a\.png with colours; save it as grey"):
        specular_map_of(MESH, tmp_path / "a.png")


@pytest.mark.parametrize("read", [normal_map_of, specular_map_of])
def test_both_lie_over_uvs(tmp_path, read):
    with pytest.raises(
        SceneError, match=r"expected a mesh with UVs, got body\.obj without; give the mesh it was made for"
    ):
        read(body([(0, 0, 0), (1, 0, 0), (0, 1, 0)]), tmp_path / "a.png")
