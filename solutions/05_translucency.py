"""Solutions of lesson 5."""

from sss_ref.language import length, normalize, select, vec3
from sss_ref.passes.shadow_map import BackPoint


def way_inside(crossings):
    """Every stretch from a way in to the next way out."""
    return sum(out - into for into, out in zip(crossings[::2], crossings[1::2], strict=True))


def where_light_entered(
    position_world: vec3, light_position: vec3, stored_distance: float, shadow_valid: bool
) -> BackPoint:
    """A direction has length 1: the stored distance along it leads to the surface that the light sees."""
    direction = normalize(position_world - light_position)
    entry_point = select(shadow_valid, light_position + direction * stored_distance, position_world)
    return BackPoint(entry_point, length(position_world - entry_point))


ratio_in_glsl = """
float translucency(float thickness, float x, float y, float exponent, float d_min) {
    return pow(x, y) / pow(max(thickness, d_min), exponent);
}
"""
