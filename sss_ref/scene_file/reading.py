"""From a scene file's text to its settings, or to one error that lists everything wrong with it."""

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sss_ref.errors import SceneError
from sss_ref.errors.text_file import toml_of
from sss_ref.errors.wording import KeyPath, described, told, written
from sss_ref.scene_file import diffusion, scattering, settings, viewpoints
from sss_ref.scene_file.bundled import bundled_settings, is_bundle
from sss_ref.scene_file.layers import filled, is_overridden, overridden, override_paths
from sss_ref.scene_file.presets import misfits
from sss_ref.scene_file.quantities import Table
from sss_ref.scene_file.shipped import scene_names, scene_path
from sss_ref.scene_file.substances import materials_in, without_unit

# Which model a table of the file has, by its keys: what is known there.
TABLES: dict[KeyPath, type[Table]] = {
    (): settings.SceneFile,
    ("mesh",): settings.MeshSettings,
    ("layers",): settings.LayerSettings,
    ("layers", "phong"): settings.PhongSettings,
    ("layers", "translucency"): scattering.TranslucencySettings,
    ("camera", "orbit"): viewpoints.OrbitCamera,
    ("camera", "look_at"): viewpoints.LookAtCamera,
    ("camera", "free"): viewpoints.FreeCamera,
    ("camera", "orthographic"): viewpoints.OrthographicCamera,
    ("lights", "point"): viewpoints.PointLight,
    ("lights", "directional"): viewpoints.DirectionalLight,
    ("shadow_map",): settings.ShadowMap,
    ("phong",): settings.PhongSettings,
    ("translucency",): scattering.TranslucencySettings,
    ("blur",): scattering.Blur,
    ("diffusion",): diffusion.Diffusion,
    ("irradiance_map",): settings.IrradianceMap,
    ("output",): settings.Output,
}


@dataclass(frozen=True)
class Document:
    """A scene file as parsed."""

    data: Mapping[str, Any]
    source: str  # what error messages call it
    folder: Path  # what its paths are relative to
    preset: str | None = None  # of a bundle: the one that has filled all of its keys


def opened(scene: str | os.PathLike[str] | Mapping[str, Any]) -> Document:
    """The document of a path, of a shipped scene's name, of a bundle, or of a dictionary that was parsed already."""
    if isinstance(scene, Mapping):
        return Document(scene, "scene", Path())
    name = os.fspath(scene)
    folder = folder_of(name)
    if is_bundle(name):
        data = bundled_settings(folder)
        return Document(data, name, folder, data.get("preset"))
    expected = f"a scene file, a bundle or a shipped scene ({', '.join(scene_names())})"
    path = scene_path(name) if name in scene_names() else Path(name)
    return Document(toml_of(path, expected, SceneError), name, folder)


def folder_of(source: str) -> Path:
    """What the paths in a scene are relative to. source: a file, a shipped scene's name, or a bundle's folder."""
    if is_bundle(source):
        return Path(source)
    return (scene_path(source) if source in scene_names() else Path(source)).parent


def validated(document: Document, overrides: Mapping[str, Any]) -> settings.SceneFile:
    """The settings with every key filled but those that are fitted to the mesh. Raises SceneError."""
    given, misplaced = overridden(document.data, overrides)
    data, paths = filled(given), override_paths(overrides)
    problems = [f"override: {problem}" for problem in (*misplaced, *_filled_before(document, given))]
    try:
        result = settings.SceneFile.model_validate(data, context={"folder": document.folder})
    except ValidationError as error:
        problems += _attributed(_problems_of(error), document.source, paths)
    problems += _attributed([*misfits(data), *without_unit(given)], document.source, paths)
    if problems:
        raise SceneError("\n".join(problems))
    return result


def _filled_before(document: Document, given: Mapping[str, Any]) -> list[str]:
    """What is wrong with another preset or material for a bundle: it would fill nothing."""
    if document.preset is None:
        return []
    before, now = ({("preset",): data.get("preset"), **materials_in(data)} for data in (document.data, given))
    return [
        told(
            written(path),
            f"{before[path]}, which filled this bundle",
            str(now[path]),
            f"bundle the scene with the other {path[-1]}",
        )
        for path in before
        if now.get(path, before[path]) != before[path]
    ]


def _problems_of(error: ValidationError) -> Iterator[tuple[KeyPath, str]]:
    """Key path and problem of every error that pydantic found."""
    for details in error.errors():
        table = tuple(part for part in details["loc"][:-1] if isinstance(part, str))
        yield described(details, TABLES.get(table, settings.SceneFile).model_fields)


def _attributed(problems: Iterable[tuple[KeyPath, str]], source: str, overrides: set[KeyPath]) -> list[str]:
    """One line per problem, with its source: the scene, or an override."""
    return [f"{'override' if is_overridden(path, overrides) else source}: {problem}" for path, problem in problems]
