"""Solutions of lesson 3."""

from sss_ref.language import dot, max, normalize, reflect, vec3
from sss_ref.passes.phong import Phong


def mirrored(normal, to_light):
    """`reflect` wants the way of the light, which runs against the direction to it."""
    return reflect(-to_light, normal)


def matt_surface(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    incident_light: vec3,
    ambient: float,
    diffuse: float,
    light_count: float,
) -> Phong:
    """A surface that faces away gets no negative light."""
    to_light = normalize(light_position - position_world)
    lambert = diffuse * max(dot(normal_world, to_light), 0.0)
    return Phong((ambient / light_count + incident_light * lambert) * albedo)


highlight_in_glsl = """
float highlight(vec3 normal, vec3 to_light, vec3 to_eye, float shininess) {
    float mirrored = dot(to_eye, reflect(-to_light, normal));
    bool visible = dot(normal, to_light) > 0.0 && mirrored > 0.0;
    return visible ? pow(mirrored, shininess) : 0.0;
}
"""
