"""The separable blur: two sums of one axis each in the place of one over the plane (Jimenez et al. 2015).

A tap of the kernel is an offset along the axis, as a share of the kernel's reach, with one weight per colour channel.
The farther something lies before or behind the surface, the less it counts, and the more the pixel itself does.
"""

from sss_ref.language import (
    Array,
    Texture,
    bilinear_blend,
    dot,
    fractional_part,
    function,
    ivec2,
    max,
    select,
    stage,
    texel,
    texel_clamped,
    vec2,
    vec3,
    whole_part,
)
from sss_ref.passes.blur import EMPTY_SUM, Scattered
from sss_ref.passes.blur_on_surface import lit_with_share


@function
def nearness(position_world: Texture[vec3], coverage: Texture[bool], at: ivec2, here: vec3, ahead: vec3) -> float:
    """1 where a texel shows the model at a point's depth, less before or behind it, 0 from the kernel's reach on.

    ahead: the camera's direction divided by that reach.
    """
    reaches = dot(texel_clamped(position_world, at) - here, ahead)
    return select(texel_clamped(coverage, at), max(1.0 - max(reaches, -reaches), 0.0), 0.0)


@function
def tap_nearby(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    offset: vec2,
    ahead: vec3,
) -> vec3:
    """The lit model at an offset in pixels, bilinear; what is off the surface counts as the pixel."""
    corner = pixel + whole_part(offset)
    right = corner + ivec2(1, 0)
    above = corner + ivec2(0, 1)
    beyond = corner + ivec2(1, 1)
    here = texel(position_world, pixel)
    sample = bilinear_blend(
        lit_with_share(lit, corner, nearness(position_world, coverage, corner, here, ahead)),
        lit_with_share(lit, right, nearness(position_world, coverage, right, here, ahead)),
        lit_with_share(lit, above, nearness(position_world, coverage, above, here, ahead)),
        lit_with_share(lit, beyond, nearness(position_world, coverage, beyond, here, ahead)),
        fractional_part(offset),
    )
    return sample.xyz + texel(lit, pixel) * (1.0 - sample.w)


@stage(source="Jimenez et al. 2015: one of the two axes")
def scatter_along(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    kernel_offset: Array[vec2],
    kernel_weight: Array[vec3],
    kernel_count: int,
    pixels_per_offset: float,
    ahead: vec3,
) -> Scattered:
    """The weighted sum of all taps, from one end of the kernel to the other."""
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, kernel_count):
        offset = kernel_offset[tap] * pixels_per_offset
        total = total + tap_nearby(lit, coverage, position_world, pixel, offset, ahead) * kernel_weight[tap]
    return Scattered(total)
