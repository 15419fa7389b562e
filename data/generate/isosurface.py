"""The zero surface of a signed distance function as an even triangle mesh. For generation only."""

from collections.abc import Callable

import fast_simplification
import numpy as np
import trimesh
from sdf import Field, Points
from skimage.measure import marching_cubes

Distance = Callable[[Points], Field]
Mesh = tuple[np.ndarray, np.ndarray]  # vertices (n, 3), faces (m, 3)

GRID_OFFSET = 0.0137  # of a step: no sample lies on a plane of symmetry, where marching cubes makes slivers
BLOCK = 8  # samples along the edge of a block that is skipped when the surface is far


def zero_surface(distance: Distance, box: tuple[tuple, tuple], step: float) -> Mesh:
    """Run marching cubes over `box` (lowest and highest corner), counter-clockwise from outside, in its unit."""
    axes = [np.arange(low + GRID_OFFSET * step, high, step) for low, high in zip(*box, strict=True)]
    field = sampled(distance, axes, step)
    vertices, faces, _, _ = marching_cubes(field, 0, spacing=(step,) * 3, gradient_direction="descent")
    return vertices + [axis[0] for axis in axes], faces


def sampled(distance: Distance, axes: list[np.ndarray], step: float) -> Field:
    """Sample the grid of `axes` in float32: each sample near the surface, one per block elsewhere."""
    middles = [axis[0] + (np.arange(-(-len(axis) // BLOCK)) + 0.5) * BLOCK * step for axis in axes]
    coarse = distance(np.stack(np.meshgrid(*middles, indexing="ij")).astype(np.float32))
    field = np.kron(coarse, np.ones((BLOCK,) * 3, np.float32))[tuple(slice(len(axis)) for axis in axes)]
    near = np.abs(field) < 1.25 * BLOCK * step  # half the diagonal of a block is .87 of its edge; the rest is margin
    field[near] = distance(np.stack(np.meshgrid(*axes, indexing="ij"))[:, near].astype(np.float32))
    return field


def thinned(vertices: np.ndarray, faces: np.ndarray, triangles: int) -> Mesh:
    """Collapse edges by quadric error (Garland and Heckbert 1997) down to `triangles`."""
    small = fast_simplification.simplify(
        vertices.astype(np.float32), faces.astype(np.int32), target_count=triangles, agg=5
    )
    return small[0].astype(float), small[1]


def gradient(distance: Distance, vertices: np.ndarray, reach: float = 0.25) -> np.ndarray:
    """Return the gradient (n, 3) by central differences over `reach` to either side."""
    ahead, behind = (vertices.T[:, None] + sign * reach * np.eye(3)[..., None] for sign in (1, -1))
    return ((distance(ahead) - distance(behind)) / (2 * reach)).T


def relaxed(distance: Distance, vertices: np.ndarray, faces: np.ndarray, rounds: int = 5) -> np.ndarray:
    """Even out the triangles: slide each vertex half-way to its neighbours' mean, then drop it onto the surface."""
    mean = trimesh.smoothing.laplacian_calculation(trimesh.Trimesh(vertices, faces, process=False), equal_weight=True)
    for _ in range(rounds):
        normal = gradient(distance, vertices)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        slide = (mean @ vertices - vertices) / 2
        vertices = vertices + slide - normal * (slide * normal).sum(1, keepdims=True)
        vertices = vertices - normal * distance(vertices.T)[:, None]
    return vertices
