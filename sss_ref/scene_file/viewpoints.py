"""The [camera] and [[lights]] tables: from where the scene is seen, and from where it is lit."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, ValidationInfo, field_validator

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


class Picture(Table):
    """What every type of [camera] has: width x height pixels, and how near and far it sees."""

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


class Lens(Picture):
    """What every [camera] with a perspective has."""

    fov_y: FieldOfView = 45.0
    """Vertical field of view, degrees."""


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


class OrthographicCamera(Picture):
    """A camera without perspective, as in a technical drawing: what is far looks as large as what is near."""

    type: Literal["orthographic"]
    eye: Vector
    """A point of the plane that near and far count from; the middle of the picture lies on the line to target."""
    target: Vector = (0.0, 0.0, 0.0)
    """The point looked at."""
    up: Direction = (0.0, 1.0, 0.0)
    """Upward in the image; +Z instead where it is nearly parallel to the line of sight."""
    view_height: Positive
    """Height of what the picture shows, scene units; the width follows from the pixels, which are square."""

    @field_validator("target")
    @classmethod
    def _elsewhere(cls, target: Any, info: ValidationInfo) -> Any:
        return _away_from(target, info.data.get("eye"))


Camera = Annotated[OrbitCamera | LookAtCamera | FreeCamera | OrthographicCamera, Field(discriminator="type")]


class LightTable(Table):
    """What every type of [[lights]] has. What is left out of its shadow map's view is fitted around the mesh.

    Its place is `position`, or else, as the camera's orbit, azimuth and elevation about `target` at a `distance`.
    """

    azimuth: Number | None = None
    """Instead of position: degrees about +Y; 0 shines from +Z, 90 from +X."""
    elevation: Number | None = None
    """Instead of position: degrees above the horizon."""
    distance: Positive | None = None
    """Instead of position: how far from target it is, scene units."""
    position: Vector | None = None
    """World position of the light."""
    target: Vector | None = None
    """The point its shadow map looks at; fitted: the middle of the mesh's bounding box."""
    up: Direction = (0.0, 1.0, 0.0)
    """Upward in the shadow map; +Z instead where it is nearly parallel to the line of sight."""
    color: Color = (1.0, 1.0, 1.0)
    """Linear RGB."""
    intensity: NonNegative = 1.0
    """Factor on the colour."""
    near: Positive | None = None
    """Near plane of the shadow map, scene units; fitted: in front of the bounding sphere."""
    far: Positive | None = None
    """Far plane of the shadow map, scene units; fitted: behind the bounding sphere."""

    @field_validator("position")
    @classmethod
    def _one_place(cls, position: Any, info: ValidationInfo) -> Any:
        given = [key for key in ORBIT if info.data.get(key) is not None]
        if position is not None and given:
            raise unmet(f"no position beside {given[0]}", "remove one of the two")
        wrong = any(key not in info.data for key in ORBIT)  # which is told of that key
        if position is None and not wrong and not ({"azimuth", "elevation"} & set(given)):
            raise unmet("a value", "add it, or azimuth, elevation and distance", "nothing")
        return position

    @field_validator("target")
    @classmethod
    def _elsewhere(cls, target: Any, info: ValidationInfo) -> Any:
        return _away_from(target, info.data.get("position"))

    @field_validator("far")
    @classmethod
    def _beyond_near(cls, far: float | None, info: ValidationInfo) -> float | None:
        return far if far is None else _beyond(far, info.data.get("near"))


ORBIT = ("azimuth", "elevation", "distance")


class PointLight(LightTable):
    """A light at a point, from which it shines in all directions; its shadow map is a perspective view."""

    type: Literal["point"] = "point"
    fov_y: FieldOfView | None = None
    """Vertical field of view of the shadow map, degrees; fitted: the bounding sphere just fits."""
    falloff: Literal["none", "inverse_square"] = "none"
    """Decrease with the distance D to the light: none, or 1 / D^2."""

    @field_validator("distance")
    @classmethod
    def _far_enough(cls, distance: float | None, info: ValidationInfo) -> float | None:
        if distance is None and any(info.data.get(key) is not None for key in ORBIT[:2]):
            raise unmet("a value", "add it: how far the light is from its target", "nothing")
        return distance

    @property
    def opening(self) -> float | None:
        """How much its shadow map sees: fov_y."""
        return self.fov_y


class DirectionalLight(LightTable):
    """A light that is infinitely far away: all its rays go the way from position to target.

    Its distances count from the plane through position at right angles to that. Its shadow map is an orthographic view.
    """

    type: Literal["directional"]
    view_height: Positive | None = None
    """Height of what the shadow map holds, scene units; fitted: the bounding sphere just fits."""
    falloff: Literal["none"] = "none"
    """Parallel light does not fade."""

    @property
    def opening(self) -> float | None:
        """How much its shadow map sees: view_height."""
        return self.view_height


LightSettings = Annotated[
    Annotated[PointLight, Tag("point")] | Annotated[DirectionalLight, Tag("directional")],
    Discriminator(lambda value: type_of(value)),
]


def type_of(light: Any) -> str:
    """The type that a [[lights]] table says it has; a point light where it says none."""
    return str(light.get("type", "point") if isinstance(light, Mapping) else getattr(light, "type", "point"))


def _beyond(far: float, near: float | None) -> float:
    if near is not None and far <= near:
        raise unmet(f"a distance beyond near = {near:g}", "make it larger or near smaller")
    return far


def _away_from(target: Any, eye: Any) -> Any:
    if eye is not None and target == eye:
        raise unmet("a point other than where it is looked from", "move one of the two")
    return target
