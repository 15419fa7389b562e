"""The stages of the printed figures, one fragment or vertex at a time; as in naive_stages."""

import numpy as np
from naive_language import (
    F,
    added,
    between_centres,
    bilinear,
    dot,
    length,
    maximum,
    minimum,
    minus,
    negative,
    normalize,
    power,
    reflect,
    scaled,
    times,
    transform,
)


def _byte(value):
    return np.floor(minimum(maximum(value, F(0)), F(1)) * F(255) + F(0.5)) / F(255)


def stored_rgb8(color):
    return ([_byte(v) for v in color],)


def stored_r8(value):
    return (_byte(value),)


def _on_map(picture, uv):
    """The picture at uv, which is moved to its edge if it lies beyond; bilinear."""
    return bilinear(picture, *between_centres(picture, [minimum(maximum(v, F(0)), F(1)) for v in uv]))


def _towards(position, light_position, distance):
    return added(light_position, scaled(normalize(minus(position, light_position)), distance))


def untransformed_vertex(position, normal, uv, world_from_model, clip_from_model):
    model = [*position, F(1)]
    return transform(clip_from_model, model), transform(world_from_model, model)[:3], normal, uv


def lookup_vertex(
    position,
    normal,
    uv,
    world_from_model,
    clip_from_model,
    light_clip_from_world,
    light_position,
    lookup_inset,
    light_distance,
):
    clip, world, normal, uv = untransformed_vertex(position, normal, uv, world_from_model, clip_from_model)
    x, y, _, w = transform(light_clip_from_world, [*world, F(1)])
    at = [F(0), F(0)] if w == 0 else [((v / w) * lookup_inset + F(1)) * F(0.5) for v in (x, y)]
    return clip, world, normal, uv, _towards(world, light_position, _on_map(light_distance, at)[0])


def entry_interpolated(position_world, fragment_entry_point):
    return fragment_entry_point, length(minus(position_world, fragment_entry_point))


def entry_from_irradiance(position_world, uv, light_position, irradiance):
    entry_point = _towards(position_world, light_position, _on_map(irradiance, uv)[0])
    return entry_point, length(minus(position_world, entry_point))


def directly_lit_exact(thickness):
    return (thickness == 0,)


def phong_ungated(
    position_world,
    normal_world,
    albedo,
    light_position,
    camera_position,
    incident_light,
    ambient,
    diffuse,
    specular,
    shininess,
):
    to_light = normalize(minus(light_position, position_world))
    to_eye = normalize(minus(camera_position, position_world))
    s = power(maximum(dot(to_eye, reflect(negative(to_light), normal_world)), F(0)), shininess)
    lambert = scaled(incident_light, diffuse * maximum(dot(normal_world, to_light), F(0)))
    reflected = added([ambient + v for v in lambert], scaled(incident_light, specular * s))
    return (times(reflected, albedo),)


def translucency_unclamped(thickness, directly_lit, x, y, exponent):
    return (F(0) if directly_lit else minimum(power(x, y / power(thickness, exponent)), F(65504)),)


def irradiance_gathered(uv, irradiance, tap_offset, tap_weight, tap_count, pixel_scale):
    height, width = irradiance.shape[:2]
    total = None
    for k in range(tap_count):
        x, y = tap_offset[k]
        at = [uv[0] + (x * pixel_scale) * (F(1) / F(width)), uv[1] + (y * pixel_scale) * (F(1) / F(height))]
        share = times(_on_map(irradiance, at), list(tap_weight[k]))
        total = share if total is None else added(total, share)
    return (total,)


def image_sqrt_add(
    irradiance_used, phong, albedo, translucency, position_world, normal_world, light_position, translucency_scale
):
    facing = dot(normal_world, normalize(minus(light_position, position_world)))
    factor = (translucency * translucency_scale) * (F(1) - maximum(facing, F(0)))
    mean = [np.sqrt(maximum(v, F(0))) for v in times(phong, irradiance_used)]
    return (added(mean, scaled(albedo, factor)),)
