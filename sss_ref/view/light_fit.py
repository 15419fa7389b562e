"""The view of a shadow map where the file leaves it open: the narrowest that holds the mesh's bounding sphere."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.numerics.trigonometry import fifty_digits
from sss_ref.scene_file.viewpoints import ORBIT, DirectionalLight, PointLight
from sss_ref.view.matrices import Vector, cross, dot, length, outward

MARGIN = 1.05  # factor on the bounding sphere's radius
AnyLight = PointLight | DirectionalLight


@dataclass(frozen=True, eq=False)
class Bounds:
    """The box around a mesh's vertices, and the sphere around the box's centre that holds them all."""

    low: Vector  # (3,) world
    high: Vector  # (3,) world
    centre: Vector  # (3,) world
    radius: float  # scene units

    @classmethod
    def around(cls, points: NDArray[np.float64]) -> "Bounds":
        """The bounds of points (N, 3): box, its middle c, and the largest distance from c."""
        low, high = points.min(axis=0), points.max(axis=0)
        centre = (low + high) * 0.5
        x, y, z = (points - centre).T
        return cls(low, high, centre, float(np.sqrt((x * x + y * y) + z * z).max()))

    def holds(self, point: Vector) -> bool:
        """Whether a point is in the box or on it."""
        return bool(((self.low <= point) & (point <= self.high)).all())


def fitted(light: AnyLight, bounds: Bounds, aspect: float) -> AnyLight:
    """`light` with position, target, near, far, and fov_y or view_height filled in; given ones stay.

    With the sphere's centre c and k = 1.05 * its radius: target = c. Of a point light q = |c - light|,
    near = max(q - k, q / 1000); of a directional one q is that distance along its rays, near = q - k; far = q + k, and
    the map just holds the sphere. Raises SceneError if the light is too close for that.
    """
    light = placed(light, bounds)
    if None not in (light.opening, light.near, light.far):
        return light
    to_centre, ahead = bounds.centre - np.array(light.position), np.array(light.target) - np.array(light.position)
    flat = isinstance(light, DirectionalLight)
    q, k = (dot(to_centre, ahead) / length(ahead) if flat else length(to_centre)), MARGIN * bounds.radius
    key = "view_height" if flat else "fov_y"
    if q <= k:
        raise SceneError(
            f"expected a light farther than {k:g} from the mesh's centre, got {q:g}; "
            f"move it or give {key}, near and far"
        )
    filled = {"near": q - k if flat else max(q - k, q / 1000), "far": q + k}
    if light.opening is None:
        filled[key] = (view_height if flat else field_of_view)(to_centre, ahead, k, aspect)
    remedy = "move it closer" if light.near is None and light.far is None else "give both or neither"
    return _checked(light.model_copy(update={**filled, **light.model_dump(exclude_none=True)}), remedy)


def placed(light: AnyLight, bounds: Bounds) -> AnyLight:
    """`light` with target and position filled in: target + distance * outward(azimuth, elevation).

    Where a directional light gives no distance, its plane lies 2 k before the mesh's centre (see `fitted`).
    """
    target = bounds.centre if light.target is None else np.array(light.target)
    update: dict[str, Any] = {"target": tuple(target.tolist())}
    if light.position is None:
        towards = outward(light.azimuth or 0.0, light.elevation or 0.0)
        distance = light.distance or 2 * MARGIN * bounds.radius + dot(bounds.centre - target, towards)
        update |= {"position": tuple((target + distance * towards).tolist()), **dict.fromkeys(ORBIT)}
    return light.model_copy(update=update)


def view_height(to_centre: Vector, ahead: Vector, radius: float, aspect: float) -> float:
    """The height of what an eye sees that looks along `ahead`, its rays parallel, and holds a sphere at `to_centre`.

    2 * (radius + how far the sphere's centre is beside the line of sight), divided by the aspect where it is < 1.
    """
    beside = length(cross(to_centre, ahead)) / length(ahead)
    return 2 * (radius + beside) / min(aspect, 1.0)


def field_of_view(to_centre: Vector, to_target: Vector, radius: float, aspect: float) -> float:
    """The vertical field of view in degrees of an eye that looks along `to_target` and holds a sphere at `to_centre`.

    fov_y / 2 = asin(radius / |to_centre|) + the angle between the two; on a map narrower than high
    (aspect = width / height < 1) its tangent is divided by the aspect. Raises SceneError from 180 degrees on.
    """
    mp = fifty_digits()
    half = mp.asin(mp.mpf(radius) / _norm(to_centre)) + _angle(to_centre, to_target)
    if half >= mp.pi / 2:
        raise SceneError(
            f"expected a target near the mesh, got one that needs a field of view of {float(mp.degrees(2 * half)):g} "
            "degrees; move the target or give fov_y, near and far"
        )
    if aspect < 1:
        half = mp.atan(mp.tan(half) / mp.mpf(aspect))
    return float(mp.degrees(2 * half))


def _angle(a: Vector, b: Vector) -> Any:
    """The angle between two vectors in radians, at 50 digits: atan2(|a x b|, a . b)."""
    mp = fifty_digits()
    (ax, ay, az), (bx, by, bz) = (map(mp.mpf, v.tolist()) for v in (a, b))
    crossed = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    return mp.atan2(mp.sqrt(sum(c * c for c in crossed)), ax * bx + ay * by + az * bz)


def _norm(v: Vector) -> Any:
    mp = fifty_digits()
    return mp.sqrt(sum(mp.mpf(x) ** 2 for x in v.tolist()))


def _checked(light: AnyLight, remedy: str) -> AnyLight:
    if light.near >= light.far:  # type: ignore[operator]
        raise SceneError(f"expected near < far, got near {light.near:g} and far {light.far:g} after fitting; {remedy}")
    return light
