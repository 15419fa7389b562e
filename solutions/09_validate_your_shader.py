"""Solutions of lesson 9."""

from sss_ref.language import dot, max, normalize, select, vec3
from sss_ref.passes.irradiance import Irradiance


def wrong_stages():
    """A looks its map up elsewhere, B rounds in another order, C spreads its taps further."""
    return {"A": "shadow_lookup_nearest", "B": None, "C": "scatter_inside"}


def mended_lambert(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    incident_light: vec3,
    directly_lit: bool,
    shadow_valid: bool,
) -> Irradiance:
    """To the light, not from it; and shadow is where the map knows a surface, not where it knows none."""
    to_light = normalize(light_position - position_world)
    facing = max(dot(normal_world, to_light), 0.0)
    return Irradiance(incident_light * select(directly_lit, facing, select(shadow_valid, 0.0, facing)))


mended_srgb_in_glsl = """
float encoded(float linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}
"""
