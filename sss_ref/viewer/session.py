"""What one page has in hand: the scene as it is being changed, and which buffer it looks at. Nothing is drawn here."""

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import TypeAdapter, ValidationError

from sss_ref.errors import SceneError, SssRefError
from sss_ref.errors.wording import told
from sss_ref.mesh.mesh_file import load_mesh
from sss_ref.scene.first_scene import first_scene
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.layers import filled, overridden
from sss_ref.scene_file.viewpoints import Camera, LightSettings
from sss_ref.view.light_fit import AnyLight, Bounds, placed
from sss_ref.viewer import messages, steering

CAMERA: TypeAdapter[Camera] = TypeAdapter(Camera)
LIGHT: TypeAdapter[AnyLight] = TypeAdapter(LightSettings)


class Session:
    """The state of one page. Every change raises `version`; what is drawn of an older one is out of date."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.data: dict[str, Any] = plain(data)
        self.buffer = "image"
        self.version = 0
        self._good = self.data
        self._scene: Scene | None = None

    def accept(self, data: Mapping[str, Any], scene: Scene) -> None:
        """Take note that `data` has no mistakes, and of the scene that it is."""
        self._good, self._scene = dict(data), scene

    def take(self, message: Any) -> None:
        """Do what a message asks that changes the scene. Raises SceneError, and then nothing has changed."""
        match message:
            case messages.SetKey(key=key, value=value):
                self._set(key, value)
            case messages.Show(buffer=buffer):
                self.buffer = buffer
            case messages.GoBack():
                self.data = self._good
            case messages.Restore(data=data):
                self.data = plain(data)
            case messages.MoveLight():
                self._move_light(message)
            case messages.FrameMesh():
                self._steer(framed(self.scene))
            case _:
                self._steer(self._steered(message))
        self.version += 1

    def begin(self, data: Mapping[str, Any]) -> None:
        """Begin anew with another scene."""
        self.data = plain(data)
        self.version += 1

    @property
    def scene(self) -> Scene:
        """The last scene without mistakes. Raises SceneError before there is one."""
        if self._scene is None:
            raise SceneError(told("scene", "one that can be drawn", "none yet", "correct it first"))
        return self._scene

    @property
    def bounds(self) -> Bounds:
        """Of the mesh, in the world."""
        return PlacedMesh(self.scene.mesh, self.scene.world_from_model).bounds

    def camera(self) -> Camera:
        """The camera as the changes so far have it. Raises SceneError for one with mistakes."""
        try:
            return CAMERA.validate_python(filled(self.data)["camera"])
        except (ValidationError, KeyError):
            remedy = "correct it in the menu"
            raise SceneError(told("camera", "one that can be moved", "one with mistakes", remedy)) from None

    def _light(self, number: int) -> AnyLight:
        """A light as the changes so far have it. Raises SceneError for one with mistakes, and where there is none."""
        try:
            light: AnyLight = LIGHT.validate_python(filled(self.data)["lights"][number])
            return light
        except (ValidationError, LookupError, TypeError):
            key, remedy = f"lights.{number}", "correct it in the menu"
            raise SceneError(told(key, "a light that can be moved", "none, or one with mistakes", remedy)) from None

    def _steered(self, message: Any) -> steering.Changes:
        """The camera's keys after it was moved as a message says."""
        camera, bounds = self.camera(), self.bounds
        match message:
            case messages.Turn(right=right, up=up):
                return steering.turned(camera, right, up)
            case messages.Slide(right=right, up=up):
                return steering.slid(camera, bounds, right, up)
            case messages.Zoom(factor=factor):
                return steering.zoomed(camera, bounds, factor)
            case messages.Fly(right=right, up=up, ahead=ahead):
                return steering.flown(camera, bounds, (right, up, ahead))
            case messages.ChooseCamera(type=kind):
                return steering.retyped(camera, kind, bounds)
        raise AssertionError(message)

    def _steer(self, changes: steering.Changes) -> None:
        """Change keys of the camera, and its planes where they would cut the mesh."""
        table = changes if "type" in changes else {**self.data["camera"], **changes}
        before, self.data = self.data, {**self.data, "camera": table}
        try:
            planes = steering.widened(self.camera(), self.bounds)
        except SceneError:
            self.data = before
            raise
        self.data = {**self.data, "camera": {**table, **planes}}

    def _move_light(self, message: messages.MoveLight) -> None:
        scene, bounds = self.scene, self.bounds
        light = placed(self._light(message.light), bounds)
        target = np.array(light.target, np.float64)
        position = target + message.factor * (np.array(light.position, np.float64) - target)
        way = message.right, message.up
        moved = steering.light_moved((position, target), scene.camera, bounds, way, message.behind)
        self._set(f"lights.{message.light}.position", moved)

    def _set(self, key: str, value: Any) -> None:
        if value is None:
            self.data = without(self.data, key.split("."))
            return
        data, problems = overridden(self.data, {key: value})
        if problems:
            raise SceneError("\n".join(problems))
        self.data = data


def started(mesh: Path) -> dict[str, Any]:
    """The first scene for a mesh file, which it calls by its name. Raises MeshError for one that cannot be drawn."""
    try:
        return tomllib.loads(first_scene(load_mesh(mesh), mesh.name))
    except SssRefError as error:
        raise type(error)(str(error).replace(str(mesh), mesh.name)) from None


def framed(scene: Scene) -> steering.Changes:
    """The camera of a first scene for a scene's mesh, its picture as large as now."""
    table: steering.Changes = tomllib.loads(first_scene(scene.mesh, scene.settings.mesh.path))["camera"]
    return table | {side: getattr(scene.settings.camera, side) for side in ("width", "height")}


def plain(data: Mapping[str, Any]) -> dict[str, Any]:
    """A scene's tables as JSON has them, a copy."""
    copied: dict[str, Any] = json.loads(json.dumps(data, default=str))
    return copied


def without(base: Any, path: list[str]) -> Any:
    """A copy of tables without the key at `path`; as it was where there is none."""
    head, *rest = path
    if isinstance(base, list) and head.isdecimal() and int(head) < len(base) and rest:
        number = int(head)
        return [*base[:number], without(base[number], rest), *base[number + 1 :]]
    if not isinstance(base, Mapping) or head not in base:
        return base
    if not rest:
        return {key: value for key, value in base.items() if key != head}
    return {**base, head: without(base[head], rest)}
