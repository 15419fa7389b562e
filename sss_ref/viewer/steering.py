"""Where the camera goes when it is dragged or flown, and where a light goes that is dragged in the picture.

Ways in the picture count in its height, to the right and upwards; angles in degrees, lengths in scene units. What comes
out is what the scene file will say, to six digits.
"""

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.scene_file.viewpoints import Camera, FreeCamera, OrbitCamera, OrthographicCamera, Picture
from sss_ref.view.lenses import Perspective
from sss_ref.view.light_fit import Bounds
from sss_ref.view.matrices import Vector
from sss_ref.view.views import View, camera_view

HALF_TURN = 180.0  # degrees that a way of the picture's height turns the camera about its target
LOOK_AROUND = 90.0  # and where it flies
STEEPEST = 89.0  # degrees: straight above, nothing says what is upwards in the picture
FOV_Y = 30.0  # degrees: of a camera that had no perspective
CLOSEST = 0.01  # of the mesh's radius: the near plane of a camera inside its bounding sphere
ROOM = 1.2  # of the mesh's radius: where a light's handle is

Changes = dict[str, Any]
"""Key of [camera] -> its new value."""


def turned(camera: Camera, right: float, up: float) -> Changes:
    """The camera carried around what it looks at; one that flies looks elsewhere instead."""
    if isinstance(camera, FreeCamera):
        pitch = _between(camera.pitch + LOOK_AROUND * up, -STEEPEST, STEEPEST)
        return {"yaw": _short(_wrapped(camera.yaw - LOOK_AROUND * right)), "pitch": _short(pitch)}
    azimuth, elevation, distance = _about_target(camera_view(camera))
    azimuth = _wrapped(azimuth - HALF_TURN * right)
    elevation = _between(elevation - HALF_TURN * up, -STEEPEST, STEEPEST)
    if isinstance(camera, OrbitCamera):
        return {"azimuth": _short(azimuth), "elevation": _short(elevation)}
    return {"eye": _list(np.array(camera.target) + distance * _direction(azimuth, elevation))}


def slid(camera: Camera, bounds: Bounds, right: float, up: float) -> Changes:
    """The camera moved so that what is at the target's distance follows the pointer."""
    view = camera_view(camera)
    height = view.lens.height_at_1 * (1.0 if view.lens.is_parallel else _reach(camera, bounds))
    way = -height * (right * view.view[0, :3] + up * view.view[1, :3])
    return {key: _list(np.array(getattr(camera, key)) + way) for key in _points(camera)}


def zoomed(camera: Camera, bounds: Bounds, factor: float) -> Changes:
    """The camera at `factor` times its distance, or with as much of its height."""
    if isinstance(camera, OrthographicCamera):
        return {"view_height": _short(camera.view_height * factor)}
    if isinstance(camera, OrbitCamera):
        return {"distance": _short(camera.distance * factor)}
    view = camera_view(camera)
    if isinstance(camera, FreeCamera):
        step = max(_reach(camera, bounds), bounds.radius) * (1 - factor)
        return {"position": _list(view.eye + step * view.direction)}
    return {"eye": _list(view.target + factor * (view.eye - view.target))}


def flown(camera: Camera, bounds: Bounds, way: tuple[float, float, float]) -> Changes:
    """A camera that flies, moved to the right, upwards and ahead by so many radii of the mesh.

    One about a target begins to fly. Raises SceneError for one without perspective, where going ahead shows nothing.
    """
    if isinstance(camera, OrthographicCamera):
        remedy = "choose another camera.type"
        raise SceneError(told("fly", "a camera with a perspective", "an orthographic one", remedy))
    view = camera_view(camera)
    axes = (view.view[0, :3], view.view[1, :3], view.direction)
    moved = view.eye + bounds.radius * sum(step * axis for step, axis in zip(way, axes, strict=True))
    flying = {} if isinstance(camera, FreeCamera) else retyped(camera, "free", bounds)
    return {**flying, "position": _list(moved)}


def retyped(camera: Camera, kind: str, bounds: Bounds) -> Changes:
    """A camera of another type that shows what this one does, with every key that it needs."""
    view = camera_view(camera)
    reach = _reach(camera, bounds)
    shared: Changes = {key: getattr(camera, key) for key in Picture.model_fields} | {"type": kind}
    fov_y = view.lens.fov_y if isinstance(view.lens, Perspective) else FOV_Y
    height = view.lens.height_at_1 * (1.0 if view.lens.is_parallel else reach)
    if view.lens.is_parallel:
        reach = height / (2 * math.tan(math.radians(fov_y / 2)))
    target = view.target if not isinstance(camera, FreeCamera) else view.eye + reach * view.direction
    eye = target - reach * view.direction
    azimuth, elevation = _angles(-view.direction)
    own: dict[str, Changes] = {
        "orbit": {
            "target": _list(target),
            "azimuth": _short(azimuth),
            "elevation": _short(elevation),
            "distance": _short(reach),
        },
        "look_at": {"eye": _list(eye), "target": _list(target)},
        "free": {"position": _list(eye), "yaw": _short(azimuth), "pitch": _short(-elevation)},
        "orthographic": {"eye": _list(eye), "target": _list(target), "view_height": _short(height)},
    }
    lens = {} if kind == "orthographic" else {"fov_y": fov_y}
    return shared | lens | own[kind]


def widened(camera: Camera, bounds: Bounds) -> Changes:
    """Other near and far planes where these would cut the mesh; none where they do not."""
    view = camera_view(camera)
    ahead = float((bounds.centre - view.eye) @ view.direction)
    first, last = ahead - bounds.radius, ahead + bounds.radius
    changes: Changes = {}
    if first < camera.near:
        changes["near"] = _short(min(camera.near, max(0.9 * first, CLOSEST * bounds.radius)))
    if last > camera.far:
        changes["far"] = _short(1.1 * last)
    return {key: value for key, value in changes.items() if value != getattr(camera, key)}


def light_moved(
    place: tuple[Vector, Vector], view: View, bounds: Bounds, way: tuple[float, float], behind: bool
) -> list[float]:
    """The position of a light that is dragged around its target, at the same distance.

    place: its position and target. way: to the right and upwards. behind: whether its handle is behind the mesh.
    """
    position, target = place
    angle = _picture_height(view, bounds) / (ROOM * bounds.radius) * (-1 if behind else 1)
    offset = _rotated(position - target, view.view[1, :3], way[0] * angle)
    return _list(target + _rotated(offset, view.view[0, :3], -way[1] * angle))


def handle(position: Vector, view: View, bounds: Bounds) -> dict[str, Any] | None:
    """Where in the picture a light's handle is, on a sphere around the mesh; None where it is not in front of the eye.

    Shares of width and height, x from the left and y from the top, and whether it is on the far side.
    """
    towards = position - bounds.centre
    reach = math.sqrt(float(towards @ towards))
    if not reach:
        return None
    point = bounds.centre + ROOM * bounds.radius / reach * towards
    x, y, _, w = view.projection @ (view.view @ np.array([*point, 1.0]))
    if w <= 0:
        return None
    facing = -view.direction if view.lens.is_parallel else view.eye - point
    behind = bool(towards @ facing < 0)
    return {"x": round((x / w + 1) / 2, 5), "y": round((1 - y / w) / 2, 5), "behind": behind}


def _points(camera: Camera) -> tuple[str, ...]:
    """The keys of a camera's points."""
    return tuple(key for key in ("eye", "position", "target") if key in type(camera).model_fields)


def _reach(camera: Camera, bounds: Bounds) -> float:
    """How far ahead what is looked at is; where a camera flies, where its line of sight is nearest to the mesh."""
    view = camera_view(camera)
    if isinstance(camera, FreeCamera):
        return max(float((bounds.centre - view.eye) @ view.direction), 0.1 * bounds.radius)
    return math.dist(view.eye, view.target)


def _picture_height(view: View, bounds: Bounds) -> float:
    """The height of what the picture shows at the middle of the mesh."""
    ahead = max(float((bounds.centre - view.eye) @ view.direction), CLOSEST * bounds.radius)
    return view.lens.height_at_1 * (1.0 if view.lens.is_parallel else ahead)


def _about_target(view: View) -> tuple[float, float, float]:
    """Azimuth, elevation and distance of an eye about its target."""
    offset = view.eye - view.target
    return (*_angles(offset), math.sqrt(float(offset @ offset)))


def _angles(towards: Vector) -> tuple[float, float]:
    x, y, z = towards.tolist()
    return math.degrees(math.atan2(x, z)), math.degrees(math.atan2(y, math.hypot(x, z)))


def _direction(azimuth: float, elevation: float) -> Vector:
    a, e = math.radians(azimuth), math.radians(elevation)
    return np.array([math.cos(e) * math.sin(a), math.sin(e), math.cos(e) * math.cos(a)])


def _rotated(vector: Vector, axis: Vector, angle: float) -> Vector:
    """A vector turned about a unit axis by an angle in radians (Rodrigues)."""
    c, s = math.cos(angle), math.sin(angle)
    return vector * c + np.cross(axis, vector) * s + axis * (axis @ vector) * (1 - c)


def _wrapped(degrees: float) -> float:
    return (degrees + 180.0) % 360.0 - 180.0


def _between(value: float, least: float, largest: float) -> float:
    return min(max(value, least), largest)


def _short(value: float) -> float:
    return float(f"{value:.6g}")


def _list(point: Iterable[float]) -> list[float]:
    return [_short(value) for value in point]
