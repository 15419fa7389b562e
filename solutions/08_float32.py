"""Solutions of lesson 8."""

import numpy as np

from sss_ref.language import sqrt, vec3
from sss_ref.passes.shadow_map import LightDistance


def ulps_between(a, b):
    """Of positive floats the bit patterns, taken for whole numbers, are in the same order without a gap."""
    return abs(int(a.view(np.int32)) - int(b.view(np.int32)))


def same_bits(fragment_position: vec3, light_position: vec3) -> LightDistance:
    """Rule A3: (x*x + y*y) + z*z."""
    way = fragment_position - light_position
    return LightDistance(sqrt((way.x * way.x + way.y * way.y) + way.z * way.z))


difference_of_squares_in_glsl = """
float difference_of_squares(float a, float b) {
    return (a - b) * (a + b);
}
"""
