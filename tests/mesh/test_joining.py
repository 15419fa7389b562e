"""Parts joined to one mesh."""

from pathlib import Path

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh.joining import joined, joined_triangles
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import FileContent, Part


def part(vertices):
    """A triangle of a part with so many vertices, which take no memory."""
    positions = np.broadcast_to(np.float32(0), (vertices, 3))
    return Part(positions, None, None, np.array([[0, 1, 2]]), Material("m"))


def test_a_part_begins_behind_those_before_it():
    triangles = joined_triangles(Path("a.obj"), [part(3), part(2**31 - 7), part(3)])
    assert triangles.dtype == np.int32
    assert triangles.tolist() == [[0, 1, 2], [3, 4, 5], [2**31 - 4, 2**31 - 3, 2**31 - 2]]


def test_an_index_has_31_bits():
    with pytest.raises(MeshError) as error:
        joined_triangles(Path("a.obj"), [part(3), part(2**31 - 3)])
    assert str(error.value) == "a.obj: expected fewer than 2^31 vertices, got 2147483648; simplify the mesh"


CORNERS = np.float32([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
UP = np.float32([(0, 0, 1)] * 3)
UVS = np.float32([(0, 0), (1, 0), (0, 1)])


def triangle(x, normals=UP, uvs=UVS, material="m"):
    """A part of one triangle."""
    return Part(CORNERS + np.float32([x, 0, 0]), normals, uvs, np.array([[0, 1, 2]]), Material(material))


def mesh_of(*parts, notes=()):
    return joined(Path("a.glb"), FileContent(list(parts), notes))


def test_parts_come_one_after_the_other_each_with_its_material():
    empty = Part(CORNERS, UP, None, np.zeros((0, 3), int), Material("unused"))
    mesh = mesh_of(triangle(0), triangle(5, material="n"), empty, triangle(9), notes=("told",))
    assert mesh.positions[mesh.triangles][:, 0, 0].tolist() == [0, 5, 9]
    assert mesh.uvs[mesh.triangles].tolist() == [UVS.tolist()] * 3
    assert (mesh.material.tolist(), mesh.materials) == ([0, 1, 0], (Material("m"), Material("n")))
    assert (mesh.name, mesh.notes, mesh.normals_source) == ("a.glb", ("told",), "file")
    assert (mesh.shifted, mesh.charts) == (0, 0)


def test_what_some_parts_lack_none_has():
    mesh = mesh_of(triangle(0), triangle(5, uvs=None, normals=None), triangle(9, uvs=None), triangle(12, uvs=None))
    assert mesh.uvs is None and mesh.normals_source == "computed"
    assert mesh.notes == ("UVs not used: 3 of 4 parts have none", "normals computed: 1 of 4 parts have none")
    assert mesh.normals.tolist() == [[0, 0, 1]] * 12


def test_what_no_part_has_is_not_spoken_of():
    mesh = mesh_of(triangle(0, None, None), triangle(5, None, None))
    assert (mesh.uvs, mesh.normals_source, mesh.notes) == (None, "computed", ())


@pytest.mark.parametrize("wrong", [(0, 0, 0), (0, np.nan, 1), (np.inf, 0, 0)])
def test_one_normal_that_is_none_has_all_of_them_computed(wrong):
    normals = -UP
    normals[1] = wrong
    mesh = mesh_of(triangle(0), triangle(5, normals))
    assert mesh.notes == ("normals computed: 1 of the file's 6 are zero or not finite",)
    assert mesh.normals.tolist() == [[0, 0, 1]] * 6
    along_x = np.float32([(1, 0, 0)] * 3)
    assert mesh_of(triangle(0, along_x)).normals.tolist() == along_x.tolist()


def test_a_mesh_has_a_size():
    """Where one coordinate of one vertex is another it has one."""
    point = Part(CORNERS * 0 + 7, None, None, np.array([[0, 1, 2]]), Material("m"))
    with pytest.raises(
        MeshError, match=r"^a\.glb: expected a mesh of some size, got all vertices at one point; correct"
    ):
        mesh_of(point)
    for vertex in range(3):
        positions = point.positions.copy()
        positions[vertex, 2] = 8
        assert len(mesh_of(Part(positions, None, None, point.triangles, point.material)).positions) == 3


def test_each_vertex_of_a_part_has_a_uv():
    with pytest.raises(
        MeshError, match=r"^a\.glb: expected one UV per vertex, got another number; export the mesh again"
    ):
        mesh_of(triangle(0), triangle(5, uvs=UVS[:2]))


def test_nothing_but_parts_without_triangles():
    with pytest.raises(MeshError, match=r"^a\.glb: expected at least one triangle, got none; export the mesh as"):
        mesh_of(Part(CORNERS, None, None, np.zeros((0, 3), int), Material("m")))
