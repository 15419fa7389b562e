"""How a view brings what it sees onto its picture: rays that meet in the eye, or rays that are parallel."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from sss_ref.numerics.trigonometry import tangent
from sss_ref.view.matrices import Matrix, orthographic, perspective


@dataclass(frozen=True)
class Perspective:
    """Rays that meet in the eye. fov_y: vertical angle between the outermost, degrees."""

    fov_y: float
    is_parallel: ClassVar[bool] = False
    key: ClassVar[str] = "fov_y"  # of the scene file

    @property
    def height_at_1(self) -> float:
        """Height of what the picture shows at a clip depth w of 1, where w is the distance: 2 * tan(fov_y / 2)."""
        return 2 * tangent(self.fov_y / 2)

    def projection(self, aspect: float, near: float, far: float) -> Matrix:
        """clip_from_view, 4 x 4, OpenGL's clip space; aspect: width / height."""
        return perspective(self.fov_y, aspect, near, far)

    def half_height(self, ahead: NDArray[np.float64]) -> NDArray[np.float64]:
        """Half of the height that the picture shows at distances along the line of sight, scene units."""
        return tangent(self.fov_y / 2) * ahead


@dataclass(frozen=True)
class Orthographic:
    """Parallel rays. view_height: distance of the outermost, scene units."""

    view_height: float
    is_parallel: ClassVar[bool] = True
    key: ClassVar[str] = "view_height"

    @property
    def height_at_1(self) -> float:
        """Height of what the picture shows; w is 1 everywhere."""
        return self.view_height

    def projection(self, aspect: float, near: float, far: float) -> Matrix:
        """clip_from_view, 4 x 4, OpenGL's clip space; aspect: width / height."""
        return orthographic(self.view_height, aspect, near, far)

    def half_height(self, ahead: NDArray[np.float64]) -> NDArray[np.float64]:
        """Half of the height that the picture shows at distances along the line of sight, scene units."""
        return np.full_like(ahead, self.view_height / 2)


Projection = Perspective | Orthographic
