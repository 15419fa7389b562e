"""What is worth knowing about a mesh's UVs before its surface is used as a map (rule R7). Every count is exact."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import MeshError
from sss_ref.mesh.topology import merged
from sss_ref.mesh.triangles import Mesh

# Six products, each exact in float64, and five sums: far above the rounding error of their total, 5 * 2^-53.
SIGN_BOUND = 2.0**-48


@dataclass(frozen=True)
class UvFacts:
    """Counts of a mesh's UVs as every pass uses them, that is after the move of `uv_tiles`."""

    shifted: int
    """Triangles that were moved from another tile into the unit square."""
    mirrored: int
    """Triangles that run clockwise in UV space: their signed area is < 0."""
    zero_area: int
    """Triangles without area in UV space: the layout gives them no texel."""
    out_of_range: int
    """Vertices outside [0, 1], of those that triangles use: the layout cuts off what is there."""
    seams: int
    """Edges, counted by position, on which triangles that meet there disagree about UV."""
    bounds: tuple[float, float, float, float]
    """Least u, least v, greatest u, greatest v of the vertices that triangles use."""


def uv_facts(mesh: Mesh) -> UvFacts:
    """The facts of a mesh that has UVs; raises MeshError for one that has none."""
    if mesh.uvs is None:
        raise MeshError(f"{mesh.name}: expected UVs, got none; set mesh.unwrap = true in the scene")
    used = mesh.uvs[np.unique(mesh.triangles)]
    signs = area_signs(mesh.uvs[mesh.triangles])
    return UvFacts(
        shifted=mesh.shifted,
        mirrored=int(np.count_nonzero(signs < 0)),
        zero_area=int(np.count_nonzero(signs == 0)),
        out_of_range=int(np.count_nonzero(((used < 0) | (used > 1)).any(axis=1))),
        seams=_seams(mesh.positions, mesh.uvs, mesh.triangles),
        bounds=tuple(np.concatenate([used.min(axis=0), used.max(axis=0)]).tolist()),
    )


def area_signs(corners: NDArray[np.float32]) -> NDArray[np.float64]:
    """The sign of each triangle's area, exactly: -1, 0 or 1 (T,); corners: (T, 3, 2), 1 is counter-clockwise.

    Twice the area is u0*v1 - u1*v0 + u1*v2 - u2*v1 + u2*v0 - u0*v2. Where float64 cannot tell its sign, the sum of
    the six is rounded only once.
    """
    (u, v), after = np.moveaxis(corners.astype(np.float64), 2, 0), [1, 2, 0]
    products = np.concatenate([u * v[:, after], -u[:, after] * v], axis=1)
    total = products.sum(axis=1)
    unsure = np.flatnonzero(np.abs(total) <= SIGN_BOUND * np.abs(products).sum(axis=1))
    total[unsure] = [math.fsum(row) for row in products[unsure]]
    return np.sign(total)


def _seams(positions: NDArray[np.float32], uvs: NDArray[np.float32], triangles: NDArray[np.int32]) -> int:
    """Edges between merged positions whose two ends do not have one pair of UVs in all triangles around."""
    place, mark = merged(positions), merged(uvs)
    start, end = triangles.reshape(-1), np.roll(triangles, -1, axis=1).reshape(-1)
    turned = place[start] > place[end]
    low, high = np.where(turned, end, start), np.where(turned, start, end)
    edge = place[low] * len(positions) + place[high]
    pair = mark[low] * len(positions) + mark[high]
    edge, pair = (column[place[low] != place[high]] for column in (edge, pair))
    order = np.lexsort([pair, edge])
    edge, pair = edge[order], pair[order]
    return len(np.unique(edge[1:][(edge[1:] == edge[:-1]) & (pair[1:] != pair[:-1])]))
