"""Stages where rays are parallel, as the rules state them, for one fragment; imports nothing of the package.

As in naive_stages; each is named after the stage that it is a form of, and after the rays that are parallel.
"""

import numpy as np
from naive_language import F, added, dot, maximum, minimum, minus, negative, normalize, power, reflect, scaled, times
from naive_language import transform as transformed


def distance_to_light_directional(fragment_position, light_position, light_direction):
    return (dot(minus(fragment_position, light_position), light_direction),)


def directly_lit_literal_directional(position_world, light_position, light_direction, stored_distance, bias_abs):
    return (dot(minus(position_world, light_position), light_direction) - stored_distance <= bias_abs,)


def directly_lit_slope_directional(
    position_world,
    normal_world,
    light_position,
    light_direction,
    light_clip_from_world,
    light_texel_size,
    stored_distance,
    bias_abs,
    bias_slope,
):
    facing = dot(normal_world, negative(light_direction))
    c = minimum(maximum(abs(facing), F(0.05)), F(1))
    w = transformed(light_clip_from_world, [*position_world, F(1)])[3]
    texel = (w if F(0) < w else F(0)) * light_texel_size
    bias = bias_abs + bias_slope * (texel * (F(1) + np.sqrt(F(1) - c * c) / c))
    behind = dot(minus(position_world, light_position), light_direction) - stored_distance
    return (facing > 0 and behind <= bias,)


def _phong(normal, albedo, to_light, to_eye, e, ambient, diffuse, specular, shininess, light_count):
    facing = dot(normal, to_light)
    mirrored = dot(to_eye, reflect(negative(to_light), normal))
    s = F(0) if facing <= 0 or mirrored <= 0 else power(mirrored, shininess)
    lambert = scaled(e, diffuse * maximum(facing, F(0)))
    return (times(added([ambient / light_count + v for v in lambert], scaled(e, specular * s)), albedo),)


def phong_shading_directional(
    position_world, normal_world, albedo, light_direction, camera_position, incident_light, *rest, **more
):
    to_eye = normalize(minus(camera_position, position_world))
    return _phong(normal_world, albedo, negative(light_direction), to_eye, incident_light, *rest, **more)


def phong_shading_orthographic(
    position_world, normal_world, albedo, light_position, camera_direction, incident_light, *rest, **more
):
    to_light = normalize(minus(light_position, position_world))
    return _phong(normal_world, albedo, to_light, negative(camera_direction), incident_light, *rest, **more)


def phong_shading_directional_orthographic(
    position_world, normal_world, albedo, light_direction, camera_direction, incident_light, *rest, **more
):
    both = negative(light_direction), negative(camera_direction)
    return _phong(normal_world, albedo, *both, incident_light, *rest, **more)


def lit_transmit_directional(
    phong,
    albedo,
    directly_lit,
    translucency,
    incident_light,
    position_world,
    normal_world,
    light_direction,
    translucency_scale,
    ambient,
    light_count,
):
    facing = dot(normal_world, negative(light_direction))
    reflected = phong if directly_lit else scaled(albedo, ambient / light_count)
    factor = (translucency * translucency_scale) * maximum(-facing, F(0))
    return (added(reflected, scaled(times(albedo, incident_light), factor)),)


def irradiance_paper_directional(position_world, normal_world, light_position, light_direction, incident_light):
    distance = dot(minus(position_world, light_position), light_direction)
    facing = dot(normal_world, negative(light_direction))
    return (scaled(incident_light, distance * maximum(facing, F(0))),)
