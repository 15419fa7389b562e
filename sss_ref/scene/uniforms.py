"""The uniforms of a scene: the name a stage reads it by -> its value, float32 or int, rounded once from the scene."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sss_ref.language.names import Name, tap_name
from sss_ref.mesh.stretch import stretch_of
from sss_ref.mesh.triangles import Mesh
from sss_ref.methods.inner_body import OWN, inner
from sss_ref.passes.light_uniforms import LightUniforms
from sss_ref.scene.spreading import spreading_of
from sss_ref.scene_file.scattering import TranslucencySettings
from sss_ref.scene_file.settings import MeshSettings, SceneFile
from sss_ref.view.matrices import Matrix, Vector, mirrors, normal_matrix
from sss_ref.view.views import Light, View

SHORTEST_REACH = 1e-30  # scene units


def uniforms_of(
    settings: SceneFile,
    world_from_model: Matrix,
    camera: View,
    lights: Sequence[Light],
    constants: Mapping[str, float],
) -> dict[str, Any]:
    """Every uniform of a scene by name, but those of the surface's colour.

    Matrices are M[row][column], vectors (N,); uniform arrays have one row an element. constants: those that the method
    decides.
    """
    taps, spreading = np.array(settings.blur.taps, np.float32), spreading_of(settings)
    values = {
        "world_from_model": world_from_model,
        "normal_from_model": normal_matrix(world_from_model),
        "handedness": -1.0 if mirrors(world_from_model) else 1.0,
        "normal_scale": _normal_scale(settings.mesh),
        "camera_clip_from_model": camera.clip_from(world_from_model),
        "camera_position": camera.eye,
        "camera_clip_from_world": camera.clip_from(np.eye(4)),
        "camera_pixel_size": camera.pixel_size,
        "ahead": _ahead(settings, camera, spreading.get("reach_mm")),
        "mm_per_unit": settings.mm_per_unit,
        "camera_direction": camera.direction,
        "light_count": len(lights),
        **_of_lights(settings, world_from_model, lights),
        "lookup_inset": settings.shadow_map.lookup_inset,
        "bias_abs": settings.shadow_map.bias_abs,
        "bias_slope": settings.shadow_map.bias_slope,
        "kernel_scale": settings.shadow_map.kernel_scale,
        "lookup_depth": settings.shadow_map.lookup_depth,
        "ambient": settings.phong.ambient,
        "diffuse": settings.phong.diffuse,
        "specular": settings.phong.specular,
        "shininess": settings.phong.shininess,
        **_of_translucency(settings.translucency),
        "wrap": settings.translucency.wrap,
        **constants,
        "pixel_scale": settings.blur.pixel_scale,
        "mm_per_offset": settings.blur.mm_per_offset,
        "tap_offset": taps[:, :2],
        "tap_weight": taps[:, 2:],
        **spreading,
        "background": settings.output.background,
        **{f"{tap_name(number)}_offset": tap[:2] for number, tap in enumerate(taps)},
        **{f"{tap_name(number)}_weight": tap[2:] for number, tap in enumerate(taps)},
    }
    if settings.layers:
        values["extinction_per_mm"] = settings.layers[0].extinction_per_mm
    rounded = {name: np.array(value, np.float32, order="C") for name, value in values.items()}
    scalars = {name: value if value.ndim else value[()] for name, value in rounded.items()}
    counts = {"tap_count": len(taps), "gaussian_count": len(settings.translucency.terms)}
    return {**scalars, **counts, "kernel_count": settings.diffusion.taps, "sample_count": settings.diffusion.samples}


def _of_translucency(translucency: TranslucencySettings) -> dict[str, Any]:
    """Its uniforms; where one has three channels, all that may have them do."""
    terms = np.array(translucency.terms)
    values = {
        "x": translucency.x,
        "y": translucency.y,
        "exponent": translucency.exponent,
        "d_min": translucency.d_min,
        "translucency_scale": translucency.scale,
    }
    channels = 3 if translucency.by_channel else ()
    spread = {name: np.broadcast_to(value, channels) for name, value in values.items()}
    return {**spread, "gaussian_variance": terms[:, 0], "gaussian_weight": terms[:, 1:]}


def of_inner_body(uniforms: Mapping[str, Any]) -> dict[str, Any]:
    """Those that the inner body has for itself, from the uniforms of a scene of that body alone."""
    return {inner(name): value for name, value in uniforms.items() if name in OWN}


def _ahead(settings: SceneFile, camera: View, reach_mm: float | None) -> Vector:
    """The camera's direction divided by the kernel's reach in scene units; 0 for a kernel that reaches nowhere.

    reach_mm: that of a technique; without, it is that of the blur's taps.
    """
    own = settings.blur.reach * settings.blur.mm_per_offset
    reach = (own if reach_mm is None else reach_mm) / settings.mm_per_unit
    return camera.direction / reach if reach > SHORTEST_REACH else np.zeros(3)


def stretch(settings: SceneFile, points: NDArray[np.float64], mesh: Mesh) -> dict[str, NDArray[np.float32]]:
    """`triangle_stretch`, which only a blur in mm of the layout reads: scene units per texel, float32 (T, 2).

    points: world positions of the vertices (V, 3).
    """
    in_pixels = settings.method == "texture_space" and settings.blur.unit == "pixel"
    if not settings.in_texture_space or in_pixels:
        return {}
    assert mesh.uvs is not None  # the loader has checked
    size = settings.irradiance_map.width, settings.irradiance_map.height
    return {"triangle_stretch": (stretch_of(points, mesh.uvs, mesh.triangles) / size).astype(np.float32)}


def _normal_scale(mesh: MeshSettings) -> tuple[float, float]:
    """The factors on x and y of a normal map."""
    up = 1.0 if mesh.normal_map_green == "up" else -1.0
    return mesh.normal_strength, up * mesh.normal_strength


def _of_lights(settings: SceneFile, world_from_model: Matrix, lights: Sequence[Light]) -> dict[str, Any]:
    """The uniforms of all lights; where there are several, each name ends in the light's number: light_position_1."""
    numbered = enumerate(lights, start=1) if len(lights) > 1 else [(0, lights[0])]
    return {
        str(Name(name, number)): value
        for number, light in numbered
        for name, value in _of_light(light, settings, world_from_model)._asdict().items()
    }


def _of_light(light: Light, settings: SceneFile, world_from_model: Matrix) -> LightUniforms:
    """The uniforms of one light and of its shadow map, not yet rounded."""
    values: dict[str, Any] = {
        "light_clip_from_model": light.view.clip_from(world_from_model),
        "light_clip_from_world": light.view.clip_from(np.eye(4)),
        "light_position": light.position,
        "light_direction": light.view.direction,
        "light_color": light.color,
        "light_intensity": light.intensity,
        "light_texel_size": light.view.pixel_size,
        "light_clear_distance": 2 * light.view.far if settings.shadow_map.encoding == "float32" else 0.0,
    }
    return LightUniforms(**values)
