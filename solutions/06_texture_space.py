"""Solutions of lesson 6."""

from sss_ref.language import max, sqrt, vec3
from sss_ref.passes.texture_image import Image


def texel_that_holds(u, width):
    """The texels to the left of u are whole ones; u = 1 is the right border of the last."""
    return min(int(u * width), width - 1)


def mixed_with_phong(irradiance_used: vec3, phong: vec3) -> Image:
    """The geometric mean."""
    return Image(sqrt(max(irradiance_used * phong, vec3(0.0, 0.0, 0.0))))


layout_in_glsl = """
vec4 layout_position(vec2 uv) {
    return vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
"""
