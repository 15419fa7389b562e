"""Parts joined to one mesh."""

from pathlib import Path

import numpy as np
import pytest

from sss_ref.errors import MeshError
from sss_ref.mesh.joining import joined_triangles
from sss_ref.mesh.materials import Material
from sss_ref.mesh.part import Part


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
