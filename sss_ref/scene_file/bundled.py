"""scene.json of a bundle: the scene with every key filled, from which it is rendered again without its own files."""

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final, Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import text_of
from sss_ref.errors.wording import told
from sss_ref.rules import RULES_VERSION
from sss_ref.scene_file.settings import SceneFile
from sss_ref.scene_file.shipped import scene_names

FILE_NAME = "scene.json"
SCENE_FORMAT: Final = "sss_ref scene 1"
MESH, INNER_MESH, PICTURE = "mesh", "inner_mesh", "textures/albedo.png"  # where a bundle holds what its scene names
MAPS = ("normal_map", "specular_map")  # pictures that it holds as arrays, as their uniforms


class SceneOfBundle(BaseModel):
    """The whole file. source: what the scene was called. settings: its keys, as a scene file has them."""

    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)

    format: Literal["sss_ref scene 1"]
    rules_version: int
    source: str
    own_stages: tuple[str, ...]
    settings: dict[str, Any]


def bundle_record(settings: SceneFile, source: str, own_stages: Iterable[str]) -> SceneOfBundle:
    """What scene.json says of a scene; its mesh and its picture are those that lie in the bundle."""
    mesh = {"path": MESH, "unwrap": False}
    texture = {} if settings.mesh.texture is None else {"texture": PICTURE}
    maps = {key: f"textures/{key}.npy" for key in MAPS if key in settings.mesh.pictures}
    layers = tuple(layer.model_copy(update={"path": INNER_MESH}) for layer in settings.layers)
    surface = settings.mesh.model_copy(update=mesh | texture | maps)
    held = settings.model_copy(update={"mesh": surface, "layers": layers})
    return SceneOfBundle(
        format=SCENE_FORMAT,
        rules_version=RULES_VERSION,
        source=source,
        own_stages=tuple(sorted(own_stages)),
        settings=held.model_dump(mode="json"),
    )


def is_bundle(scene: str) -> bool:
    """Whether a scene's name is a folder; a shipped scene's name is none."""
    return scene not in scene_names() and os.path.isdir(scene)  # unlike Path.is_dir it takes any text


def bundled_settings(folder: Path) -> dict[str, Any]:
    """The keys of a bundle's scene, not yet checked.

    Raises SceneError for a folder that is no bundle, and for what cannot be rendered again: stages of the user's own,
    or other rules.
    """
    path = folder / FILE_NAME
    text = text_of(path, "the scene of a bundle", SceneError)
    try:
        record = SceneOfBundle.model_validate_json(text)
    except ValidationError as error:
        where = ".".join(map(str, error.errors()[0]["loc"])) or "file"
        came, remedy = "something else", "write the bundle again"
        raise SceneError(told(f"{path}: {where}", "what sss-ref bundle writes", came, remedy)) from None
    if record.own_stages:
        came, remedy = f"others for {', '.join(record.own_stages)}", "use sss_ref.validate with the scene itself"
        raise SceneError(told(str(path), "our stages", came, remedy))
    if record.rules_version != RULES_VERSION:
        came, remedy = str(record.rules_version), "write the bundle again"
        raise SceneError(told(str(path), f"rules version {RULES_VERSION}", came, remedy))
    return record.settings
