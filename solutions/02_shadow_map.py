"""Solutions of lesson 2."""

from sss_ref.language import length, vec3
from sss_ref.passes.shadow_map import DirectlyLit


def cover_once(edges, left_or_bottom):
    """A sample on an edge belongs to the triangle whose left or bottom edge it is."""
    return all(e > 0 or (e == 0 and owned) for e, owned in zip(edges, left_or_bottom, strict=True))


def lit_within_a_bias(
    position_world: vec3, light_position: vec3, stored_distance: float, bias_abs: float
) -> DirectlyLit:
    """Behind the stored surface by no more than the bias."""
    distance = length(position_world - light_position)
    return DirectlyLit(distance - stored_distance <= bias_abs)


map_coordinates_in_glsl = """
vec2 map_coordinates(vec4 clip) {
    return clip.xy / clip.w * 0.5 + 0.5;
}
"""
