"""Solutions of lesson 1."""

import math

from sss_ref.language import length, vec3
from sss_ref.passes.phong import IncidentLight


def distance_of_a_wall(depth, angle):
    """The depth is the leg beside the angle, the distance the hypotenuse."""
    return depth / math.cos(angle)


def light_that_spreads(
    position_world: vec3, light_position: vec3, light_color: vec3, light_intensity: float
) -> IncidentLight:
    """The area of a sphere grows with the square of its radius."""
    distance = length(position_world - light_position)
    return IncidentLight(light_color * (light_intensity / (distance * distance)))


lambert_in_glsl = """
float lambert(vec3 normal, vec3 to_light) {
    return max(dot(normal, to_light), 0.0);
}
"""
