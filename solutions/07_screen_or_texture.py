"""Solutions of lesson 7."""

import math

from sss_ref.language import vec3
from sss_ref.passes.composite import Image


def blur_on_the_body(pixels, distance, fov_y, height):
    """The whole picture is 2 * distance * tan(fov_y / 2) high out there."""
    return pixels * 2 * distance * math.tan(math.radians(fov_y) / 2) / height


def albedo_after_the_blur(irradiance_used: vec3, gloss: vec3, ambient: float, albedo: vec3) -> Image:
    """All that arrives, times the albedo."""
    return Image(((ambient + irradiance_used) + gloss) * albedo)


stranger_in_glsl = """
bool stranger(vec3 here, vec3 there, float allowed) {
    return length(there - here) > allowed;
}
"""
