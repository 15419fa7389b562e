"""UDIM tiles: which triangles move, by how much, and what becomes of shared vertices (rule R7)."""

import numpy as np
import pytest

from sss_ref.mesh.uv_tiles import into_unit_square
from sss_ref.scene import load_mesh

F = np.float32
ONE = np.array([[0, 1, 2]], np.int32)


@pytest.mark.parametrize(
    ("corners", "moved"),
    [
        ([(0.25, 0.5), (0.5, 0.5), (0.25, 1)], (0, 0)),
        ([(1, 0), (2, 0), (1, 1)], (-1, 0)),  # the tile to the right, edges included
        ([(1.5, 3.25), (1.75, 3.25), (1.5, 4)], (-1, -3)),
        ([(-0.5, 0), (0, 0), (-0.5, 1)], (1, 0)),
        ([(-1.5, -2.5), (-1.25, -2.5), (-1.5, -2.25)], (2, 3)),
        ([(0.5, 0), (1.5, 0), (1.5, 1)], (0, 0)),  # reaches inside
        ([(-0.5, 0), (0.25, 0), (-0.5, 1)], (0, 0)),
        ([(0, 0), (0, 1), (0, 0.5)], (0, 0)),  # on the border: its mean lies in the square already
        ([(1, 0), (1, 1), (1, 0.5)], (-1, 0)),
        ([(1, 0), (3.5, 0), (3.5, 1)], (-2, 0)),  # over several tiles: by the tile of the mean
    ],
)
def test_one_triangle(corners, moved):
    tiled = into_unit_square(F(corners), ONE)
    assert np.array_equal(tiled.uvs, F(corners) + F(moved))
    assert tiled.shifted == (moved != (0, 0)) and np.array_equal(tiled.triangles, ONE)


@pytest.mark.parametrize(("order", "tile"), [((0, 1, 2), 4), ((0, 2, 1), 3), ((1, 2, 0), 3)])
def test_the_mean_is_summed_in_order_in_float32(order, tile):
    """Added from the left these three make 12, in another order one ulp less."""
    u = F([float.fromhex("0x1.a93bep+1"), float.fromhex("0x1.c1bdeep+0"), float.fromhex("0x1.baf292p+2")])[list(order)]
    tiled = into_unit_square(np.column_stack([u, F([0, 0.5, 1])]), ONE)
    assert np.array_equal(tiled.uvs[:, 0], u - F(tile))


def test_shared_vertices_are_split_once_for_each_tile():
    uvs = F([(-0.0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (9, 9)])
    triangles = np.array([(0, 1, 2), (1, 3, 2), (3, 4, 2)], np.int32)
    tiled = into_unit_square(uvs, triangles)
    assert tiled.shifted == 2
    assert np.array_equal(tiled.uvs[tiled.triangles[0]], uvs[triangles[0]])
    assert np.array_equal(tiled.uvs[tiled.triangles[1:]], uvs[triangles[1:]] - F([1, 0]))
    assert np.array_equal(tiled.vertices[tiled.triangles], triangles)
    assert tiled.vertices.tolist() == [0, 1, 2, 3, 4, 5, 1, 2]  # 1 and 2 twice; vertices of one tile stay what they are
    assert np.signbit(tiled.uvs[0, 0]) and (tiled.uvs[5] == 9).all()  # what nothing moves keeps its bits


def test_uvs_beyond_float32_sums_stay():
    corners = F([(3e38, 0), (3e38, 0), (3e38, 1)])
    assert np.array_equal(into_unit_square(corners, ONE).uvs, corners)


def test_a_loaded_mesh_tells_of_its_tiles(tmp_path):
    path = tmp_path / "tiles.obj"
    path.write_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 2 0\nf 1/1 2/2 3/3\nf 2/2 4/4 3/3\n"
    )
    mesh = load_mesh(path)
    assert mesh.shifted == 1 and mesh.notes == ("1 triangles lie in other UV tiles and were moved to 0..1",)
    assert np.array_equal(mesh.uvs[mesh.triangles], [[(0, 0), (1, 0), (1, 1)], [(0, 0), (1, 0), (0, 1)]])
    expected = [[(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0), (0, 1, 0)]]
    assert np.array_equal(mesh.positions[mesh.triangles], expected)
    assert len(mesh.normals) == len(mesh.positions) == len(mesh.uvs) == 6


def test_asset_with_tiles(asset):
    mesh = load_mesh(asset("ict_face/generic_neutral_mesh.obj"))
    assert len(mesh.triangles) == 52220 and mesh.shifted == 26924
    assert mesh.uvs[mesh.triangles].min() >= 0 and mesh.uvs[mesh.triangles].max() <= 1
