"""Cameras and lights as the passes use them: an eye, a direction and two matrices."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sss_ref.numerics.trigonometry import cosine, sine
from sss_ref.scene_file.settings import ShadowMap
from sss_ref.scene_file.viewpoints import (
    Camera,
    DirectionalLight,
    FreeCamera,
    OrbitCamera,
    OrthographicCamera,
    PointLight,
)
from sss_ref.view.lenses import Orthographic, Perspective, Projection
from sss_ref.view.matrices import Matrix, Vector, look_at, outward, product

UP = (0.0, 1.0, 0.0)


@dataclass(frozen=True, eq=False)
class View:
    """A view of the world: the camera's, or the one a light's shadow map has. See `viewpoints.Picture`."""

    name: str
    eye: Vector  # (3,) world
    target: Vector  # (3,) world
    up: Vector  # (3,) world
    lens: Projection
    near: float
    far: float
    width: int
    height: int

    @cached_property
    def view(self) -> Matrix:
        """view_from_world, 4 x 4: the eye at the origin looking along -Z."""
        return look_at(self.eye, self.target, self.up)

    @cached_property
    def projection(self) -> Matrix:
        """clip_from_view, 4 x 4, OpenGL's clip space."""
        return self.lens.projection(self.width / self.height, self.near, self.far)

    @cached_property
    def pixel_size(self) -> np.float32:
        """Height of a pixel where w is 1, scene units, rounded once to float32."""
        return np.float32(self.lens.height_at_1 / self.height)

    @cached_property
    def direction(self) -> Vector:
        """The way it looks, a unit vector (3,), world."""
        return -self.view[2, :3]

    def clip_from(self, world_from_model: Matrix) -> NDArray[np.float32]:
        """clip_from_model, 4 x 4: (projection * view) * model in float64, rounded once to float32."""
        return product(product(self.projection, self.view), world_from_model).astype(np.float32)


@dataclass(frozen=True, eq=False)
class Light:
    """A light and the view of its shadow map. See `viewpoints.LightTable`."""

    position: Vector  # (3,) world; of a directional light a point on the plane that distances count from
    color: Vector  # (3,) linear RGB
    intensity: float
    falloff: str
    view: View


def camera_view(camera: Camera) -> View:
    """The view of a [camera] table of any type."""
    eye, target, up = (np.array(point, np.float64) for point in _line_of_sight(camera))
    lens: Projection
    lens = Orthographic(camera.view_height) if isinstance(camera, OrthographicCamera) else Perspective(camera.fov_y)
    return View("camera", eye, target, up, lens, camera.near, camera.far, camera.width, camera.height)


def light_of(light: PointLight | DirectionalLight, shadow_map: ShadowMap) -> Light:
    """A fitted [[lights]] table as a light."""
    assert light.target and light.opening and light.near and light.far  # fitted: see light_fit.py
    position, target, up = (np.array(point, np.float64) for point in (light.position, light.target, light.up))
    lens = Orthographic(light.opening) if isinstance(light, DirectionalLight) else Perspective(light.opening)
    view = View("light", position, target, up, lens, light.near, light.far, shadow_map.width, shadow_map.height)
    return Light(position, np.array(light.color, np.float64), light.intensity, light.falloff, view)


def orbit_eye(camera: OrbitCamera) -> Vector:
    """The eye: target + distance * the outward direction."""
    return np.array(camera.target, np.float64) + camera.distance * outward(camera.azimuth, camera.elevation)


def free_target(camera: FreeCamera) -> Vector:
    """The point looked at: position + (-cos pitch * sin yaw, sin pitch, -cos pitch * cos yaw)."""
    level = cosine(camera.pitch)
    forward: Vector = np.array([-level * sine(camera.yaw), sine(camera.pitch), -level * cosine(camera.yaw)])
    return np.array(camera.position, np.float64) + forward


def _line_of_sight(camera: Camera) -> tuple[object, object, object]:
    """Eye, target and up of a [camera] table."""
    if isinstance(camera, OrbitCamera):
        return orbit_eye(camera), camera.target, UP
    if isinstance(camera, FreeCamera):
        return camera.position, free_target(camera), UP
    return camera.eye, camera.target, camera.up
