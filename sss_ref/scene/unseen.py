"""Whether a view sees the mesh at all, and if not, the number to set."""

import math

import numpy as np

from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene_file.viewpoints import Camera, FreeCamera
from sss_ref.view.light_fit import MARGIN, AnyLight, Bounds
from sss_ref.view.matrices import Vector, length, transformed
from sss_ref.view.views import View

FEWEST_PIXELS = 4  # across the mesh; fewer show nothing of it, if the picture has far more
SMALLEST_SHARE = 0.1  # of the picture's width or height


def unseen(view: View, surface: PlacedMesh, key: str, table: Camera | AnyLight) -> str:
    """Why a view sees nothing of the mesh and what to set, or "" where it may see some of it.

    key: of the scene file, "camera" or "lights.0"; table: what stands there. Only what is certain for all vertices is
    told; triangles around the view's edges may still miss it.
    """
    x, y, ahead = transformed(view.view, surface.points).T * [[1], [1], [-1]]
    nearest, farthest = float(ahead.min()), float(ahead.max())
    if farthest <= 0:
        return f"the whole mesh is behind it; set {turned(view, surface.bounds, key, table)}"
    if nearest > view.far:
        beyond = f"the whole mesh lies beyond far = {view.far:g}, from {nearest:.3g} on"
        return f"{beyond}; set {key}.far = {1.1 * farthest:.3g}"
    if farthest < view.near:
        before = f"the whole mesh lies before near = {view.near:g}, up to {farthest:.3g}"
        return f"{before}; set {key}.near = {max(0.9 * nearest, farthest / 1000):.3g}"
    height = view.lens.half_height(ahead)  # half of what the view holds there
    width = height * (view.width / view.height)
    if any((side > limit).all() for side, limit in ((x, width), (-x, width), (y, height), (-y, height))):
        return f"the whole mesh is beside its picture; set {turned(view, surface.bounds, key, table)}"
    if nearest <= 0:
        return ""
    shares = np.array([np.ptp(x / width), np.ptp(y / height)]) / 2
    pixels = float((shares * (view.width, view.height)).max())
    if pixels < FEWEST_PIXELS and shares.max() < SMALLEST_SHARE:
        small = f"the mesh is {pixels:.2g} of its {view.width} x {view.height} pixels wide"
        return f"{small}; set {key}.{framing(view, surface.bounds)}"
    return ""


def framing(view: View, bounds: Bounds) -> str:
    """The key, with its value, that lets a view hold the mesh's bounding sphere from where it is."""
    radius, taller = MARGIN * bounds.radius, max(1.0, view.height / view.width)
    if view.lens.is_parallel:
        return f"{view.lens.key} = {2 * radius * taller:.3g}"
    half = math.asin(min(radius / length(bounds.centre - view.eye), 1.0))
    return f"{view.lens.key} = {math.degrees(2 * half) * taller:.3g}"


def turned(view: View, bounds: Bounds, key: str, table: Camera | AnyLight) -> str:
    """The keys that turn a view towards the middle of the mesh, with their values."""
    if not isinstance(table, FreeCamera):
        return f"{key}.target = {written(bounds.centre)}"
    right, up, backward = view.eye - bounds.centre
    yaw, pitch = math.atan2(right, backward), math.atan2(-up, math.hypot(right, backward))
    return f"{key}.yaw = {math.degrees(yaw):.3g} and {key}.pitch = {math.degrees(pitch):.3g}"


def written(point: Vector) -> str:
    """A point as a scene file has it, with digits enough to aim by."""
    return f"[{', '.join(f'{coordinate:.7g}' for coordinate in point)}]"
