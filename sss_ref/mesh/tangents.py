"""Tangents for meshes under a normal map: the direction in which u grows along the surface (rule R11)."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.uv_facts import area_signs

FloatArray = NDArray[np.float64]


def with_tangents(mesh: Mesh) -> Mesh:
    """The mesh with a tangent at each vertex, float32 (V', 4); the notes say where there is none.

    xyz is of length 1, or 0 where no triangle around has an area on the map. w is -1 where the map is mirrored, else 1.
    A vertex between mirrored triangles and others is there twice, the second time at the end. Raises MeshError for a
    mesh without UVs.
    """
    if mesh.uvs is None:
        raise MeshError(f"{mesh.name}: expected UVs for tangents, got none; set mesh.unwrap = true")
    mirrored = area_signs(mesh.uvs[mesh.triangles]) < 0
    parted = _parted(mesh, mirrored)
    sides = np.zeros(len(parted.positions), np.bool_)
    sides[parted.triangles[mirrored]] = True
    directions = _summed(parted, sides)
    missing = int(np.count_nonzero(~directions.any(axis=1)))
    told = (f"the normal map has no effect at {missing} vertices, around which it has no area",) if missing else ()
    tangents = np.column_stack([directions, np.where(sides, -1.0, 1.0)]).astype(np.float32)
    return replace(parted, tangents=tangents, notes=(*mesh.notes, *told))


def _parted(mesh: Mesh, mirrored: NDArray[np.bool_]) -> Mesh:
    """The mesh with those vertices twice that mirrored triangles, bool (T,), share with others."""
    assert mesh.uvs is not None
    count = len(mesh.positions)
    shared = np.intersect1d(mesh.triangles[mirrored], mesh.triangles[~mirrored])
    again = np.arange(count, dtype=np.int32)
    again[shared] = np.arange(count, count + len(shared))
    vertices = np.concatenate([np.arange(count), shared])
    return replace(
        mesh,
        positions=mesh.positions[vertices],
        normals=mesh.normals[vertices],
        uvs=mesh.uvs[vertices],
        triangles=np.where(mirrored[:, np.newaxis], again[mesh.triangles], mesh.triangles),
    )


def _summed(mesh: Mesh, sides: NDArray[np.bool_]) -> FloatArray:
    """The directions (V, 3) of all vertices, alike where position, normal, UV and side, bool (V,), are equal."""
    assert mesh.uvs is not None
    alike = np.column_stack([mesh.positions, mesh.normals, mesh.uvs, sides]) + np.float32(0)
    _, number = np.unique(alike, axis=0, return_inverse=True)
    number = number.reshape(-1)
    sums = np.zeros((len(mesh.positions), 3))
    np.add.at(sums, number[mesh.triangles].reshape(-1), np.repeat(_weighted_directions(mesh), 3, axis=0))
    return _normalized(sums)[number]


def _weighted_directions(mesh: Mesh) -> FloatArray:
    """Along u on each triangle (T, 3), twice its area long; 0 where it has no area on the map.

    With the edges e1, e2 of the triangle and (u1, v1), (u2, v2) of its map: the sign of u1*v2 - u2*v1 times
    e1*v2 - e2*v1, made unit.
    """
    assert mesh.uvs is not None
    a, b, c = np.moveaxis(mesh.positions[mesh.triangles].astype(np.float64), 1, 0)
    p, q, r = np.moveaxis(mesh.uvs[mesh.triangles].astype(np.float64), 1, 0)
    first, second, v1, v2 = b - a, c - a, (q - p)[:, 1:], (r - p)[:, 1:]
    turn = area_signs(mesh.uvs[mesh.triangles])[:, np.newaxis]
    (x1, y1, z1), (x2, y2, z2) = first.T, second.T
    area = np.stack([y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2], axis=1)
    return _normalized(turn * (first * v2 - second * v1)) * _lengths(area)[:, np.newaxis]


def _normalized(vectors: FloatArray) -> FloatArray:
    lengths = _lengths(vectors)
    return vectors / np.where(lengths == 0, 1.0, lengths)[:, np.newaxis]


def _lengths(vectors: FloatArray) -> FloatArray:
    x, y, z = vectors.T
    lengths: FloatArray = np.sqrt((x * x + y * y) + z * z)
    return lengths
