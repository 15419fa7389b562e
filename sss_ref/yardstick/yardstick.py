"""What techniques are held against: the light of a scene that has entered its body, and leaves it again."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sss_ref.errors import SceneError
from sss_ref.errors.wording import told
from sss_ref.scene.load import load_scene
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.settings import SceneFile
from sss_ref.truth.media import NAMED, Volumes, volumes
from sss_ref.truth.tracing import Border, Tracing

SceneSource = str | Mapping[str, Any]  # a file, a shipped scene's name, or what such a file holds
BARE: Mapping[str, Any] = {  # without what the truth has not
    "phong.ambient": 0.0,
    "phong.specular": 0.0,
    "mesh.texture": None,
    "mesh.normal_map": None,
    "mesh.specular_map": None,
    "output.background": [0.0, 0.0, 0.0],
}
GEOMETRY: Mapping[str, Any] = {  # the one scene that is traced, whichever technique is measured
    "method": "screen_space",
    "preset": "robust",
    "material": None,
    "shadow_map.test": "slope",
}


@dataclass(frozen=True)
class Yardstick:
    """A scene and what its body is made of. Raises SceneError, as does what is asked of it, for what is missing.

    source: what `load_scene` takes; overrides: on top of it, by dotted key. medium: a name of
    `truth.media`. border: of the traced body, see `Tracing`.
    """

    source: SceneSource
    overrides: Mapping[str, Any]
    medium: str
    border: Border = "entered"

    @property
    def name(self) -> str:
        """What the scene is called."""
        return self.given.source

    @cached_property
    def given(self) -> Scene:
        """The scene as it is given."""
        return load_scene(self.source, **self.overrides)

    @cached_property
    def volumes(self) -> Volumes:
        """The medium, per mm."""
        return volumes(self.medium, where="--medium")

    @cached_property
    def tracing(self) -> Tracing:
        """What is traced: the scene's body, camera and lights, and nothing that only a technique reads."""
        given = self.given.settings
        if "mm_per_unit" not in given.model_fields_set:
            remedy = "set it in the scene file, or give --set mm_per_unit=150"
            raise SceneError(told("mm_per_unit", "how many mm a unit of the scene is", "nothing", remedy))
        if given.mesh.color == "material":
            remedy = "give one colour in mesh.color"
            raise SceneError(told("mesh.color", "one colour, as there is one medium", '"material"', remedy))
        same = {
            "mm_per_unit": given.mm_per_unit,
            "mesh": given.mesh.model_dump(),
            "camera": given.camera.model_dump(),
            "lights": [light.model_dump() for light in given.lights],
        }
        return Tracing(load_scene(self.source, **{**same, **BARE, **GEOMETRY}), self.volumes, self.border)

    def scene_of(self, method: str, keys: Mapping[str, Any]) -> Scene:
        """The scene by a technique, without what the truth has not. keys: tables that are put on top."""
        return load_scene(self.source, **{**self.overrides, **BARE, "method": method, **keys})

    @property
    def left_out(self) -> list[str]:
        """The keys of the scene that neither the techniques' pictures nor the truth have, with their values."""
        return list(_left_out(self.given.settings))


def medium_of(scene: Scene, given: str | None) -> str:
    """The name of what the body is made of: the one given, or the scene's material. Raises SceneError for none."""
    name = given or scene.settings.material
    if name is None or (given is None and name not in NAMED):
        came = "none and a scene without material" if name is None else f"none, and of {name} no coefficients are known"
        raise SceneError(told("--medium", "the name of a medium", came, f"try one of {', '.join(NAMED)}"))
    return name


def _left_out(settings: SceneFile) -> Iterator[str]:
    if settings.phong.ambient:
        yield f"phong.ambient = {settings.phong.ambient:g}"
    if settings.phong.specular:
        yield f"phong.specular = {settings.phong.specular:g}"
    yield from (f'mesh.{key} = "{path}"' for key, path in settings.mesh.pictures.items())
