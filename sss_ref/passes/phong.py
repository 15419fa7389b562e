"""Simple Phong shading: the model as it would be without any subsurface scattering (paper 3.2)."""

from typing import NamedTuple

from sss_ref.language import constant, dot, function, length, max, normalize, pow, reflect, select, stage, vec3

MIN_SQUARED_DISTANCE = constant(1e-8)  # a light that touches the surface stays finite


class IncidentLight(NamedTuple):
    """The light that reaches a fragment, before any angle is considered."""

    incident_light: vec3  # linear RGB: light_color * (intensity * falloff)


@stage(source="paper 3.2: a light without falloff")
def light_constant(light_color: vec3, light_intensity: float) -> IncidentLight:
    """The same light at every distance."""
    return IncidentLight(light_color * light_intensity)


@stage(source="inverse square law")
def light_inverse_square(
    position_world: vec3, light_position: vec3, light_color: vec3, light_intensity: float
) -> IncidentLight:
    """Light that spreads over a sphere: falloff 1 / D^2."""
    distance = length(position_world - light_position)
    falloff = 1.0 / max(distance * distance, MIN_SQUARED_DISTANCE)
    return IncidentLight(light_color * (light_intensity * falloff))


class Phong(NamedTuple):
    """The lit colour, whether or not the light reaches the fragment."""

    phong: vec3  # linear RGB


@function
def highlight(normal: vec3, to_light: vec3, to_eye: vec3, shininess: float) -> float:
    """Phong's specular term (V.R)^shininess; 0 where the light or its mirror image is behind."""
    mirrored = dot(to_eye, reflect(-to_light, normal))
    visible = (dot(normal, to_light) > 0.0) & (mirrored > 0.0)
    return select(visible, pow(max(mirrored, 0.0), shininess), 0.0)


@stage(source="paper 3.2, after Phong 1975")
def phong_shading(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    ambient: float,
    diffuse: float,
    specular: float,
    shininess: float,
    light_count: float,
) -> Phong:
    """(ambient/n + e*diffuse*max(N.L, 0) + e*specular*(V.R)^shininess) * albedo, of one of n lights."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    lambert = diffuse * max(dot(normal_world, to_light), 0.0)
    mirror = specular * highlight(normal_world, to_light, to_eye, shininess)
    return Phong(((ambient / light_count + incident_light * lambert) + incident_light * mirror) * albedo)
