"""The [camera] and [[lights]] tables: from where the scene is seen, and from where it is lit."""

from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, field_validator

from sss_ref.errors.wording import unmet
from sss_ref.scene_file.quantities import (
    Color,
    Direction,
    FieldOfView,
    NonNegative,
    Number,
    Positive,
    Size,
    Table,
    Vector,
)


class Lens(Table):
    """What every type of [camera] has: a perspective projection onto width x height pixels."""

    fov_y: FieldOfView = 45.0
    """Vertical field of view, degrees."""
    near: Positive = 0.1
    """Distance of the near plane, scene units."""
    far: Positive = 100.0
    """Distance of the far plane, scene units."""
    width: Size = 1024
    """Pixels in a row."""
    height: Size = 1024
    """Rows."""

    @field_validator("far")
    @classmethod
    def _beyond_near(cls, far: float, info: ValidationInfo) -> float:
        return _beyond(far, info.data.get("near"))


class OrbitCamera(Lens):
    """A camera on a sphere: eye = target + distance * (cos el * sin az, sin el, cos el * cos az)."""

    type: Literal["orbit"]
    target: Vector = (0.0, 0.0, 0.0)
    """The point looked at, and the centre of the sphere."""
    azimuth: Number = 0.0
    """Degrees about +Y; 0 looks from +Z, 90 from +X."""
    elevation: Number = 0.0
    """Degrees above the horizon."""
    distance: Positive
    """Radius of the sphere, scene units."""


class LookAtCamera(Lens):
    """A camera given by where it is and where it looks."""

    type: Literal["look_at"]
    eye: Vector
    """World position of the camera."""
    target: Vector = (0.0, 0.0, 0.0)
    """The point looked at."""
    up: Direction = (0.0, 1.0, 0.0)
    """Upward in the image; +Z instead where it is nearly parallel to the line of sight."""

    @field_validator("target")
    @classmethod
    def _elsewhere(cls, target: Any, info: ValidationInfo) -> Any:
        return _away_from(target, info.data.get("eye"))


class FreeCamera(Lens):
    """A camera given by where it is and how far it is turned from looking along -Z."""

    type: Literal["free"]
    position: Vector
    """World position of the camera."""
    yaw: Number = 0.0
    """Degrees to the left, about +Y."""
    pitch: Number = 0.0
    """Degrees upward."""


Camera = Annotated[OrbitCamera | LookAtCamera | FreeCamera, Field(discriminator="type")]


class LightSettings(Table):
    """[[lights]]: a point light, seen as a camera by its shadow map. What is left out is fitted around the mesh."""

    position: Vector
    """World position of the light."""
    target: Vector | None = None
    """The point its shadow map looks at; fitted: the middle of the mesh's bounding box."""
    up: Direction = (0.0, 1.0, 0.0)
    """Upward in the shadow map; +Z instead where it is nearly parallel to the line of sight."""
    color: Color = (1.0, 1.0, 1.0)
    """Linear RGB."""
    intensity: NonNegative = 1.0
    """Factor on the colour."""
    fov_y: FieldOfView | None = None
    """Vertical field of view of the shadow map, degrees; fitted: the bounding sphere just fits."""
    near: Positive | None = None
    """Near plane of the shadow map, scene units; fitted: in front of the bounding sphere."""
    far: Positive | None = None
    """Far plane of the shadow map, scene units; fitted: behind the bounding sphere."""
    falloff: Literal["none", "inverse_square"] = "none"
    """Decrease with the distance D to the light: none, or 1 / D^2."""

    @field_validator("target")
    @classmethod
    def _elsewhere(cls, target: Any, info: ValidationInfo) -> Any:
        return _away_from(target, info.data.get("position"))

    @field_validator("far")
    @classmethod
    def _beyond_near(cls, far: float | None, info: ValidationInfo) -> float | None:
        return far if far is None else _beyond(far, info.data.get("near"))


def _beyond(far: float, near: float | None) -> float:
    if near is not None and far <= near:
        raise unmet(f"a distance beyond near = {near:g}", "make it larger or near smaller")
    return far


def _away_from(target: Any, eye: Any) -> Any:
    if eye is not None and target == eye:
        raise unmet("a point other than where it is looked from", "move one of the two")
    return target
