"""A scene as its paths meet it: triangles in the world, lights, the camera, and the material per scene unit."""

import hashlib
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.scene import Scene
from sss_ref.truth.box_tree import box_tree_of
from sss_ref.truth.eye_rays import Eye
from sss_ref.truth.media import Volumes
from sss_ref.truth.path import Illumination, Scenery
from sss_ref.truth.photon import Volume
from sss_ref.view.views import Light, View

Border = Literal["matched", "diffuse", "entered"]
BORDERS = ("matched", "diffuse", "entered")


@dataclass(frozen=True, eq=False)
class Tracing:
    """What is traced: all that decides a radiance besides the number of samples.

    border: "matched", light does not notice the surface, whatever the material's index of refraction; "diffuse", it
    enters and leaves as by a white diffuser under Fresnel's border of that index; or "entered", the same of the light
    that has entered, as the shares of walks are: what the border reflects outside is not taken off.
    across_pixel: whether samples go evenly over a pixel; else through its centre, as the stages see it.
    Raises SceneError for a mesh without an inside, a body inside it, and an unknown border.
    """

    scene: Scene
    volumes: Volumes  # per mm
    border: Border = "matched"
    across_pixel: bool = False
    seed: int = 0

    def __post_init__(self) -> None:
        if self.border not in BORDERS:
            raise SceneError(told("border", " or ".join(BORDERS), repr(self.border), "choose one of these"))
        if self.scene.inner_mesh is not None:
            raise SceneError(
                told("layers", "one body", "another inside it", "remove the layer: only the outer is walked")
            )
        if not PlacedMesh(self.scene.mesh, self.scene.world_from_model).is_watertight:
            came = "one with holes"
            raise SceneError(told("mesh", "a closed surface, so that there is an inside", came, "close it"))

    @cached_property
    def scenery(self) -> Scenery:
        """The triangles, outwards, and the lights."""
        tree, lights = box_tree_of(self._corners), _illumination(self.scene.lights)
        return Scenery(tree, lights, self.border == "matched", self.border == "diffuse")

    @cached_property
    def _corners(self) -> NDArray[np.float64]:
        """The triangles in the world that have an area (T, 3, 3), turned over if they enclose less than 0."""
        placed = PlacedMesh(self.scene.mesh, self.scene.world_from_model)
        corners = placed.points[self.scene.mesh.triangles]
        a, b, c = np.moveaxis(corners, 1, 0)
        turn = np.cross(b - a, c - a)
        corners = corners[(turn != 0).any(axis=1)]
        outwards = float((turn * a).sum()) > 0
        return np.ascontiguousarray(corners if outwards else corners[:, ::-1])

    @cached_property
    def volumes_per_unit(self) -> Volumes:
        """The material per scene unit; its border is the one that is asked for."""
        unit = self.scene.settings.mm_per_unit or 1.0
        red, green, blue = (Volume(v.scattering * unit, v.absorption * unit, v.anisotropy, v.ior) for v in self.volumes)
        return red, green, blue

    @cached_property
    def eye(self) -> Eye:
        """The camera."""
        return _eye(self.scene.camera, float(self.across_pixel))

    @cached_property
    def identity(self) -> str:
        """A hash of all of this."""
        inputs = sorted(self.scene.input_hashes().items())
        own = (self.scene.settings.model_dump_json(), inputs, self.volumes, self.border, self.across_pixel, self.seed)
        return hashlib.sha256(repr(own).encode()).hexdigest()


def _illumination(lights: tuple[Light, ...]) -> Illumination:
    parallel = np.array([light.view.lens.is_parallel for light in lights])
    places = [-light.view.direction if light.view.lens.is_parallel else light.position for light in lights]
    fades = np.array([light.falloff == "inverse_square" for light in lights])
    return Illumination(
        np.array(places), parallel, fades, np.array([light.color * light.intensity for light in lights])
    )


def _eye(view: View, spread: float) -> Eye:
    """The camera of a view: at distance 1, half of what it shows."""
    right, up, back = view.view[:3, :3]
    half = view.lens.height_at_1 / 2
    across = right * (half * view.width / view.height)
    return Eye(view.eye, -back, across, up * half, view.lens.is_parallel, view.width, view.height, spread)
