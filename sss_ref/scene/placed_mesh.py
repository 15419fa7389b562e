"""A mesh at its place in the world, and what the loader asks about it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.mesh.topology import is_inside, is_watertight
from sss_ref.mesh.triangles import Mesh
from sss_ref.view.light_fit import Bounds
from sss_ref.view.matrices import Matrix, Vector, transformed

FLOAT32_STEP = 2.0**-23  # the spacing of float32 numbers from 1 to 2


@dataclass(frozen=True, eq=False)
class PlacedMesh:
    """A mesh at its place in the world."""

    mesh: Mesh
    world_from_model: Matrix

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """World positions of the vertices (V, 3)."""
        return transformed(self.world_from_model, self.mesh.positions)

    @cached_property
    def bounds(self) -> Bounds:
        """The box and the sphere around them."""
        return Bounds.around(self.points)

    @cached_property
    def is_watertight(self) -> bool:
        """Whether it has an inside."""
        return is_watertight(self.mesh.positions, self.mesh.triangles)

    def encloses(self, point: Vector) -> bool:
        """Whether a point is inside; False where the surface has holes and the question no answer."""
        return self.bounds.holds(point) and self.is_watertight and is_inside(point, self.points[self.mesh.triangles])

    @cached_property
    def has_area(self) -> bool:
        """Whether some triangle is wider than float32 can tell at its length."""
        return any(self._wide(first).any() for first in range(0, len(self.mesh.triangles), 4096))

    def _wide(self, first: int) -> NDArray[np.bool_]:
        """Of 4096 triangles, which are; twice the area is length times width."""
        a, b, c = np.moveaxis(self.points[self.mesh.triangles[first : first + 4096]], 1, 0)
        longest = np.stack([((end - start) ** 2).sum(axis=1) for start, end in ((a, b), (b, c), (c, a))]).max(axis=0)
        doubled = np.sqrt((np.cross(b - a, c - a) ** 2).sum(axis=1))
        wide: NDArray[np.bool_] = doubled > FLOAT32_STEP * longest
        return wide
