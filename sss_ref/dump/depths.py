"""Depths as other renderers store them, brought to window depth: 0 at the near plane, 1 at the far one.

window: as it is. view: the distance along the view axis. ray: from the eye along the pixel's ray. ray_from_near: along
the ray from where it meets the near plane, near / cos from the eye; cos is that of the angle between ray and view axis.
With far plane f and near plane n, view depth z has the window depth f / (f - n) * (1 - n / z): OpenGL's perspective
division, then from -1..1 to 0..1. Where rays are parallel, cos is 1 and the window depth (z - n) / (f - n).
"""

from typing import Literal, get_args

import numpy as np

from sss_ref.dump.loss import ROUNDING, Loss
from sss_ref.view.views import View

DepthKind = Literal["window", "view", "ray", "ray_from_near"]
KINDS: tuple[str, ...] = get_args(DepthKind)
FAR = np.float32(1)


def window_depth(distance: np.ndarray, kind: str, view: View) -> np.ndarray:
    """Window depth, float32 (H, W, 1), of distances (H, W, 1), row 0 at the bottom; 1 for all beyond the far plane."""
    along = distance.astype(np.float64)
    if kind != "view":
        cosine = ray_cosines(view)[..., np.newaxis]
        along = along * cosine + (view.near if kind == "ray_from_near" else 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (along - view.near) / view.far if view.lens.is_parallel else 1 - view.near / along
        depth = view.far / (view.far - view.near) * share
    return np.minimum(depth, FAR).astype(np.float32)


def ray_cosines(view: View) -> np.ndarray:
    """The cosine between the view axis and the ray through each pixel's centre, float64 (H, W)."""
    if view.lens.is_parallel:
        return np.ones((view.height, view.width))
    slopes = 1 / view.projection[0, 0], 1 / view.projection[1, 1]
    across, up = (
        ((np.arange(count) + 0.5) * 2 / count - 1) * slope
        for count, slope in zip((view.width, view.height), slopes, strict=True)
    )
    return 1 / np.sqrt(1 + across[np.newaxis, :] ** 2 + up[:, np.newaxis] ** 2)


def window_loss(loss: Loss, depth: np.ndarray, view: View) -> Loss:
    """How far window depths may be off that come from distances with a loss.

    A change dz of z changes the depth by f n / (f - n) * dz / z^2, so most where z is least: nowhere more than the
    relative change of z. Where rays are parallel it is dz / (f - n), and dz is largest where z is.
    """
    drawn = depth[(depth > 0) & (depth < 1)].astype(np.float64)
    span = view.far - view.near
    if view.lens.is_parallel:
        farthest = view.near + drawn.max(initial=0.0) * span
        return Loss(least=max((loss.relative + ROUNDING) * farthest, loss.least) / span + ROUNDING)
    nearest = view.far * view.near / (view.far - drawn.min(initial=1.0) * span)
    step = max(loss.relative + ROUNDING, loss.least / nearest)
    return Loss(least=view.far * view.near / span / nearest * step + ROUNDING)
