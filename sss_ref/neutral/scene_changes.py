"""Scenes that are drawn alike: other lights, another order of vertices, a world twice as large, a larger picture."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sss_ref.mesh.triangles import Mesh
from sss_ref.scene.scene import Scene
from sss_ref.scene_file.settings import PhongSettings
from sss_ref.scene_file.viewpoints import LightTable
from sss_ref.view.lenses import Orthographic
from sss_ref.view.views import Light, View

SEED = 1


def with_lights(scene: Scene, tables: Sequence[Any], lights: Sequence[Light]) -> Scene:
    """The scene with other lights. tables: those of its settings."""
    settings = scene.settings.model_copy(update={"lights": tuple(tables)})
    return replace(scene, settings=settings, lights=tuple(lights))


def brighter_color(scene: Scene) -> Scene:
    """Each colour doubled and each intensity halved: a product of powers of two is exact."""
    lights = [replace(light, color=light.color * 2, intensity=light.intensity / 2) for light in scene.lights]
    return with_lights(scene, scene.settings.lights, lights)


def lights_swapped(scene: Scene) -> Scene:
    """The lights the other way round."""
    return with_lights(scene, scene.settings.lights[::-1], scene.lights[::-1])


def with_black_light(scene: Scene, before: bool) -> Scene:
    """A light more, at the place of the first, of no colour, before or after all others."""
    table, light = scene.settings.lights[0], replace(scene.lights[0], color=np.zeros(3))
    tables: list[LightTable] = [*scene.settings.lights]
    lights = [*scene.lights]
    at = 0 if before else len(lights)
    tables.insert(at, table)
    lights.insert(at, light)
    return with_lights(scene, tables, lights)


def without_ambient(scene: Scene) -> Scene:
    """No ambient light, each light's share of which depends on how many there are."""
    settings = scene.settings
    layers = tuple(each.model_copy(update={"phong": _dark(each.phong)}) for each in settings.layers)
    return replace(scene, settings=settings.model_copy(update={"phong": _dark(settings.phong), "layers": layers}))


def _dark(phong: PhongSettings) -> PhongSettings:
    return phong.model_copy(update={"ambient": 0.0})


def vertices_reordered(scene: Scene) -> Scene:
    """The vertices of each mesh in another order; its triangles, and their corners, in the same."""
    inner = _reordered(scene.inner_mesh) if scene.inner_mesh else None
    return replace(scene, mesh=_reordered(scene.mesh), inner_mesh=inner)


def _reordered(mesh: Mesh) -> Mesh:
    order = np.random.default_rng(SEED).permutation(len(mesh.positions))
    place = np.empty(len(order), np.int32)
    place[order] = np.arange(len(order), dtype=np.int32)
    arrays = {name: getattr(mesh, name) for name in ("positions", "normals", "uvs", "tangents")}
    moved = {name: array[order] for name, array in arrays.items() if array is not None}
    return replace(mesh, triangles=place[mesh.triangles], **moved)


def twice_as_large(scene: Scene) -> Scene:
    """Everything that is a length in scene units doubled: powers of two are exact."""
    settings = scene.settings
    shadow_map = settings.shadow_map.model_copy(update={"bias_abs": settings.shadow_map.bias_abs * 2})
    changed = settings.model_copy(update={"shadow_map": shadow_map, "mm_per_unit": settings.mm_per_unit / 2})
    twice = np.diag([2.0, 2.0, 2.0, 1.0])
    lights = tuple(map(_farther, scene.lights))
    world = twice @ scene.world_from_model
    return replace(scene, settings=changed, world_from_model=world, camera=_wider(scene.camera), lights=lights)


def _farther(light: Light) -> Light:
    """A light at twice the distance, as bright as before."""
    brighter = 4.0 if light.falloff == "inverse_square" else 1.0
    view = _wider(light.view)
    return replace(light, position=light.position * 2, intensity=light.intensity * brighter, view=view)


def _wider(view: View) -> View:
    lens = Orthographic(view.lens.view_height * 2) if isinstance(view.lens, Orthographic) else view.lens
    return replace(view, eye=view.eye * 2, target=view.target * 2, lens=lens, near=view.near * 2, far=view.far * 2)


def larger_picture(scene: Scene, right: int, above: int) -> Scene:
    """A picture with more columns and rows, all uniforms as they were: for passes that draw no mesh."""
    camera = scene.settings.camera
    size = {"width": camera.width + right, "height": camera.height + above}
    return replace(scene, settings=scene.settings.model_copy(update={"camera": camera.model_copy(update=size)}))
