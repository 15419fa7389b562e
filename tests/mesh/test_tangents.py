"""Tangents under a normal map (rule R11): a naive loop, mirrored maps, triangles without area on the map."""

from pathlib import Path

import numpy as np
import pytest
from bodies import body
from scenes import sphere, written

from sss_ref.errors import MeshError
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.mesh.tangents import with_tangents


def loaded(folder, positions, triangles, uvs):
    return load_mesh(Path(written(folder / "a.obj", np.asarray(positions, float), np.array(triangles), uvs)))


def square(folder, u):
    """Two triangles in the plane z = 0 that faces +Z; u: of the four corners, counter-clockwise."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    return loaded(folder, corners, [(0, 1, 2), (0, 2, 3)], np.column_stack([u, [0, 0, 1, 1]]).astype(float))


def test_along_u(tmp_path):
    mesh = with_tangents(square(tmp_path, [0, 1, 1, 0]))
    assert mesh.tangents.dtype == np.float32 and mesh.notes == ()
    assert mesh.tangents.tolist() == [[1, 0, 0, 1]] * 4


def test_against_u_in_a_mirror(tmp_path):
    mesh = with_tangents(square(tmp_path, [1, 0, 0, 1]))
    assert mesh.tangents.tolist() == [[-1, 0, 0, -1]] * 4


def test_a_vertex_between_a_map_and_its_mirror_image_is_there_twice(tmp_path):
    """The second triangle folds back: on its edge with the first, (0, 0) to (1, 1), both have the same UVs."""
    before = square(tmp_path, [0, 1, 1, 1.5])
    mesh = with_tangents(before)
    assert np.array_equal(mesh.positions[mesh.triangles], before.positions[before.triangles])
    assert np.array_equal(mesh.uvs[mesh.triangles], before.uvs[before.triangles])
    assert np.array_equal(mesh.positions[:4], before.positions)
    assert len(mesh.positions) == 6 and mesh.triangles[0].tolist() == before.triangles[0].tolist()
    assert mesh.tangents[mesh.triangles][..., 3].tolist() == [[1, 1, 1], [-1, -1, -1]]
    assert with_tangents(mesh).tangents.tobytes() == mesh.tangents.tobytes()  # nothing is left to be parted


def test_without_area_on_the_map(tmp_path):
    mesh = with_tangents(square(tmp_path, [0, 0, 0, 0]))
    assert not mesh.tangents[:, :3].any() and (mesh.tangents[:, 3] == 1).all()
    assert mesh.notes == ("the normal map has no effect at 4 vertices, around which it has no area",)


def test_without_uvs(tmp_path):
    path = written(tmp_path / "a.obj", *sphere(4)[:2])
    with pytest.raises(MeshError, match="expected UVs for tangents, got none; set mesh"):
        with_tangents(load_mesh(Path(path)))


def test_vertices_of_uvs_that_differ_by_a_bit_have_tangents_of_their_own():
    """At one place two corners, of a map that goes along x and of one that goes along y."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0), (0, 1, 0), (-1, 0, 0)]
    uvs = [(0, 0), (1, 0), (0, 1), (1e-9, 0), (1, 0), (0, 1)]
    tangents = with_tangents(body(points, [(0, 1, 2), (3, 4, 5)], uvs=uvs)).tangents
    assert tangents[0].tolist() == [1, 0, 0, 1]
    assert tangents[3] == pytest.approx([0, 1, 0, 1], abs=1e-6)


def naive_tangents(mesh):
    """Rule R11 triangle by triangle with Python floats: of each corner (triangle, k) its tangent."""

    def key(vertex, mirrored):
        parts = (mesh.positions[vertex], mesh.normals[vertex], mesh.uvs[vertex])
        return (*(float(x) + 0.0 for part in parts for x in part), mirrored)

    def normalized(v):
        length = np.sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2])
        return [x / length for x in v] if length else [0.0, 0.0, 0.0]

    sums, corners = {}, []
    for triangle in mesh.triangles.tolist():
        a, b, c = ([float(x) for x in mesh.positions[i]] for i in triangle)
        (u0, v0), (u1, v1), (u2, v2) = ([float(x) for x in mesh.uvs[i]] for i in triangle)
        e, f = [y - x for x, y in zip(a, b, strict=True)], [y - x for x, y in zip(a, c, strict=True)]
        area = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]]
        doubled = np.sqrt((area[0] * area[0] + area[1] * area[1]) + area[2] * area[2])
        turn = float(np.sign((u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0)))
        along = normalized([turn * (p * (v2 - v0) - q * (v1 - v0)) for p, q in zip(e, f, strict=True)])
        for vertex in triangle:
            before = sums.get(key(vertex, turn < 0), [0.0, 0.0, 0.0])
            sums[key(vertex, turn < 0)] = [s + t * doubled for s, t in zip(before, along, strict=True)]
        corners.append([key(vertex, turn < 0) for vertex in triangle])
    return np.array([[[*normalized(sums[k]), -1.0 if k[-1] else 1.0] for k in three] for three in corners], np.float32)


@pytest.mark.parametrize("fold", [False, True])
def test_equals_the_naive_loop_in_every_bit(tmp_path, fold):
    positions, triangles, uvs = sphere(6)
    uvs[:, 0] = np.abs(2 * uvs[:, 0] - 1) if fold else uvs[:, 0]
    mesh = loaded(tmp_path, positions * [1, 2, 3], triangles, uvs)
    found = with_tangents(mesh)
    assert found.tangents[found.triangles].tobytes() == naive_tangents(mesh).tobytes()
    assert (len(found.positions) > len(mesh.positions)) == fold
