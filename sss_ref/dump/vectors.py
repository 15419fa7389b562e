"""Directions and points as renderers store them: encoded normals, and view space instead of world space."""

import numpy as np

from sss_ref.view.matrices import Matrix, transformed
from sss_ref.view.views import View

NUMBERS_OR_NOT = np.errstate(all="ignore")  # NaN and infinity of a shader come through; they are judged elsewhere


@NUMBERS_OR_NOT
def unit_range(stored: np.ndarray) -> np.ndarray:
    """n = 2 * stored - 1, the inverse of n * 0.5 + 0.5, rounded once to float32."""
    return (2 * stored.astype(np.float64) - 1).astype(np.float32)


@NUMBERS_OR_NOT
def octahedral(stored: np.ndarray) -> np.ndarray:
    """Unit vectors (H, W, 3) from their octahedral map (H, W, 2), each component from -1 to 1.

    z = 1 - |u| - |v|; where z >= 0, x = u and y = v, else x = (1 - |v|) * sign(u) and y = (1 - |u|) * sign(v); then
    normalised. In float64, rounded once to float32. Cigolle et al. 2014, "A Survey of Efficient Representations for
    Independent Unit Vectors".
    """
    u, v = np.moveaxis(stored.astype(np.float64), -1, 0)
    z = 1 - np.abs(u) - np.abs(v)
    x = np.where(z >= 0, u, np.copysign(1 - np.abs(v), u))
    y = np.where(z >= 0, v, np.copysign(1 - np.abs(u), v))
    return (np.dstack((x, y, z)) / np.sqrt(x * x + y * y + z * z)[..., np.newaxis]).astype(np.float32)


@NUMBERS_OR_NOT
def in_world(values: np.ndarray, camera: View, is_direction: bool) -> np.ndarray:
    """View-space values (H, W, 3) in world space: R^T v of directions, R^T v + eye of points; R turns world to view.

    In float64, rounded once to float32. The zero vector stays: it stands for "nothing drawn", and no surface is there,
    in the eye.
    """
    world_from_view: Matrix = np.eye(4)
    world_from_view[:3, :3] = camera.view[:3, :3].T
    if not is_direction:
        world_from_view[:3, 3] = camera.eye
    turned = transformed(world_from_view, values.reshape(-1, 3)).astype(np.float32).reshape(values.shape)
    return np.where(values.any(axis=-1, keepdims=True), turned, values)
