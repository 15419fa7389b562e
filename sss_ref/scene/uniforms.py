"""The uniforms of a scene: the name a stage reads it by -> its value, float32 or int, rounded once from the scene."""

from typing import Any

import numpy as np

from sss_ref.scene.load import Scene
from sss_ref.view.matrices import normal_matrix
from sss_ref.view.views import Light

NEUTRAL = {  # what leaves the colour as it is, by method and by how T joins the light
    "screen_space": {"multiply": 1.0, "add": 0.0, "transmit": 0.0},
    "texture_space": {"sqrt": 1.0, "product": 0.0, "sqrt_add": 0.0},
}


def uniforms(scene: Scene) -> dict[str, Any]:
    """Every uniform of every stage of a scene, by name.

    Matrices are M[row][column], vectors (N,); uniform arrays have one row an element.
    """
    settings = scene.settings
    joined = settings.translucency.combine if settings.method == "screen_space" else settings.irradiance_map.image
    taps = np.array(settings.blur.taps, np.float32)
    values = {
        "world_from_model": scene.world_from_model,
        "normal_from_model": normal_matrix(scene.world_from_model),
        "camera_clip_from_model": scene.camera.clip_from(scene.world_from_model),
        "camera_position": scene.camera.eye,
        "light_count": len(scene.lights),
        **light_uniforms(scene),
        "lookup_inset": settings.shadow_map.lookup_inset,
        "bias_abs": settings.shadow_map.bias_abs,
        "bias_slope": settings.shadow_map.bias_slope,
        "ambient": settings.phong.ambient,
        "diffuse": settings.phong.diffuse,
        "specular": settings.phong.specular,
        "shininess": settings.phong.shininess,
        "x": settings.translucency.x,
        "y": settings.translucency.y,
        "exponent": settings.translucency.exponent,
        "d_min": settings.translucency.d_min,
        "translucency_scale": settings.translucency.scale,
        "translucency_neutral": NEUTRAL[settings.method][joined],
        "pixel_scale": settings.blur.pixel_scale,
        "tap_offset": taps[:, :2],
        "tap_weight": taps[:, 2:],
        "background": settings.output.background,
        **{f"tap_{number:02}_offset": tap[:2] for number, tap in enumerate(taps)},
        **{f"tap_{number:02}_weight": tap[2:] for number, tap in enumerate(taps)},
    }
    rounded = {name: np.array(value, np.float32, order="C") for name, value in values.items()}
    scalars = {name: value if value.ndim else value[()] for name, value in rounded.items()}
    return {**scalars, **scene.albedo, "tap_count": len(taps), **scene.own_uniforms}


def light_uniforms(scene: Scene) -> dict[str, Any]:
    """The uniforms of all lights; where there are several, each name ends in the light's number: light_position_1."""
    if len(scene.lights) == 1:
        return uniforms_of_light(scene.lights[0], scene)
    numbered = [(number, uniforms_of_light(light, scene)) for number, light in enumerate(scene.lights, start=1)]
    return {f"{name}_{number}": value for number, values in numbered for name, value in values.items()}


def uniforms_of_light(light: Light, scene: Scene) -> dict[str, Any]:
    """The uniforms of one light and of its shadow map."""
    return {
        "light_clip_from_model": light.view.clip_from(scene.world_from_model),
        "light_clip_from_world": light.view.clip_from(np.eye(4)),
        "light_position": light.position,
        "light_color": light.color,
        "light_intensity": light.intensity,
        "light_texel_size": light.view.pixel_size,
        "light_clear_distance": 2 * light.view.far if scene.settings.shadow_map.encoding == "float32" else 0.0,
    }
