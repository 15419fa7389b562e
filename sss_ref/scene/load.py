"""From a scene file to everything a renderer needs: settings checked, mesh read, lights fitted, camera placed."""

import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from sss_ref.errors import SceneError
from sss_ref.mesh.recent_meshes import recent_mesh
from sss_ref.mesh.tangents import with_tangents
from sss_ref.mesh.triangles import Mesh
from sss_ref.mesh.unwrap import unwrapped
from sss_ref.scene.albedo import albedo_of
from sss_ref.scene.placed_mesh import PlacedMesh
from sss_ref.scene.scene import Scene
from sss_ref.scene.surface_maps import normal_map_of, specular_map_of
from sss_ref.scene_file.method_limits import ON_SURFACE
from sss_ref.scene_file.quantities import FLOAT32_OVERFLOW
from sss_ref.scene_file.reading import Document, opened, validated
from sss_ref.scene_file.settings import MeshSettings, SceneFile, ShadowMap
from sss_ref.scene_file.shipped import find_mesh
from sss_ref.scene_file.viewpoints import Camera, PointLight
from sss_ref.view.light_fit import AnyLight, fitted, placed
from sss_ref.view.matrices import placement
from sss_ref.view.views import Light, View, camera_view, light_of

MAPS = {"normal_map": normal_map_of, "specular_map": specular_map_of}  # key of [mesh] -> what reads its picture


def load_scene(scene: str | os.PathLike[str] | Mapping[str, Any], /, **overrides: Any) -> Scene:
    """A scene, checked and with every key filled, its mesh loaded and its lights fitted.

    scene: a scene file, the name of a shipped scene, a bundle's folder, or a dictionary of the form that a file has.
    overrides: values that go on top of the file, by dotted key or as tables:
    load_scene("default", preset="robust", **{"camera.width": 256, "lights.0.intensity": 2.0}).
    Raises SceneError, which lists all that is wrong with the file and the overrides, and MeshError.
    """
    return scene_of(opened(scene), overrides)


def read_mesh(path: Path, unwrap: bool, tangents: bool) -> Mesh:
    """The mesh in a file, with UVs made for it and tangents where they are asked for. Raises MeshError."""
    mesh = unwrapped(recent_mesh(path)) if unwrap else recent_mesh(path)
    return with_tangents(mesh) if tangents and mesh.uvs is not None else mesh


def scene_of(
    document: Document, overrides: Mapping[str, Any], read: Callable[[Path, bool, bool], Mesh] = read_mesh
) -> Scene:
    """The scene of a document, with overrides on top; raises as `load_scene` does.

    read: what gives its meshes: `read_mesh`, or for many scenes one that remembers what it has given.
    """
    settings = validated(document, overrides)
    inner = _mesh_of(settings.inner.mesh, document.folder, read) if settings.inner else None
    return _assembled(settings, document, _mesh_of(settings.mesh, document.folder, read), inner)


def _mesh_of(settings: MeshSettings, folder: Path, read: Callable[[Path, bool, bool], Mesh]) -> Mesh:
    path = find_mesh(settings.path, folder)
    assert path is not None  # validation found it
    return read(path, settings.unwrap, settings.normal_map is not None)


def _assembled(settings: SceneFile, document: Document, mesh: Mesh, inner: Mesh | None) -> Scene:
    """The scene with its lights fitted to the mesh; raises one SceneError for all that does not fit together."""
    place = settings.mesh
    surface = PlacedMesh(mesh, placement(*map(np.array, (place.scale, place.rotate_degrees, place.translate))))
    inside = [PlacedMesh(inner, surface.world_from_model)] if inner else []
    color = f"mesh.{'color' if place.texture is None else 'texture'}"
    steps: dict[str, Callable[[], Any]] = {
        "mesh": partial(_check_extent, surface),
        "method": partial(_check_uvs, settings.method, mesh),
        color: partial(albedo_of, place, mesh, document.folder),
        "camera": partial(_placed_camera, settings.camera, surface),
    }
    for number, layer in enumerate(inside):
        steps[f"layers[{number}]"] = partial(_check_extent, layer)
    for key in sorted(set(MAPS) & set(place.pictures)):
        steps[f"mesh.{key}"] = partial(MAPS[key], mesh, document.folder / place.pictures[key])
    for number, light in enumerate(settings.lights):
        steps[f"lights[{number}]"] = partial(_placed_light, light, settings.shadow_map, surface)
    found = _gathered(document.source, steps)
    fits = [found[f"lights[{number}]"] for number in range(len(settings.lights))]
    resolved = settings.model_copy(update={"lights": tuple(light for light, _ in fits)})
    lights = tuple(light for _, light in fits)
    return Scene(
        resolved,
        document.source,
        mesh,
        surface.world_from_model,
        found["camera"],
        lights,
        found[color],
        {key: found[f"mesh.{key}"] for key in MAPS if f"mesh.{key}" in found},
        inner,
    )


def _gathered(source: str, steps: Mapping[str, Callable[[], Any]]) -> dict[str, Any]:
    """Key -> result of its step, or one SceneError with the problems of all that failed, each under its key."""
    results, problems = {}, []
    for key, step in steps.items():
        try:
            results[key] = step()
        except SceneError as error:
            problems.append(f"{source}: {key}: {error}")
    if problems:
        raise SceneError("\n".join(problems))
    return results


def _check_extent(surface: PlacedMesh) -> None:
    reach = float(np.abs(surface.points).max())
    if reach >= FLOAT32_OVERFLOW:
        raise SceneError(f"expected world positions that fit float32, got {reach:g}; choose a smaller scale")


def _check_uvs(method: str, mesh: Mesh) -> None:
    if method in ON_SURFACE and mesh.uvs is None:
        raise SceneError(f"expected a mesh with UVs, got {mesh.name} without; set mesh.unwrap = true")


def _placed_camera(camera: Camera, surface: PlacedMesh) -> View:
    return _finite(camera_view(camera), surface)


def _placed_light(light: AnyLight, shadow_map: ShadowMap, surface: PlacedMesh) -> tuple[AnyLight, Light]:
    """The light with nothing left open, and what the passes see of it."""
    light = placed(light, surface.bounds)
    assert light.position is not None  # placed: see light_fit.py
    if isinstance(light, PointLight) and surface.encloses(np.array(light.position)):
        raise SceneError(f"expected a light outside the mesh, got {list(light.position)} inside; move it out")
    light = fitted(light, surface.bounds, shadow_map.width / shadow_map.height)
    result = light_of(light, shadow_map)
    _finite(result.view, surface)
    return light, result


def _finite(view: View, surface: PlacedMesh) -> View:
    """`view`, if its matrices have numbers in them."""
    with np.errstate(all="ignore"):
        matrix = view.clip_from(surface.world_from_model)
    if not np.isfinite(matrix).all():
        raise SceneError("expected a projection that fits float32, got larger numbers; bring eye, near and far closer")
    return view
