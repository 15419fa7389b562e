"""Parts of a file."""

import numpy as np

from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import Part, without_unused


def part(triangles):
    numbers = np.arange(5, dtype=np.float32)
    vectors = np.stack([numbers, numbers + 10, numbers + 20], axis=1)
    return Part(vectors, vectors + 100, vectors[:, :2] + 200, np.array(triangles), Material("m"))


def test_vertices_that_no_triangle_uses_are_left_out():
    found = without_unused(part([[4, 1, 3], [3, 1, 4]]))
    assert found.positions[:, 0].tolist() == [1, 3, 4] and found.normals[:, 0].tolist() == [101, 103, 104]
    assert found.uvs[:, 0].tolist() == [201, 203, 204] and found.triangles.tolist() == [[2, 0, 1], [1, 0, 2]]
    assert found.material == Material("m")


def test_a_part_that_uses_all_stays_as_it_is():
    whole = part([[4, 1, 3], [2, 0, 4]])
    assert without_unused(whole) is whole
