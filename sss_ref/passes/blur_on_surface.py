"""The blur that stays on the surface: what lies far before or behind a point on the picture gives it no light.

Two points that are farther apart along the line of sight than the kernel reaches exchange no light below the surface,
such as a chin and the throat behind it.
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
    vec4,
    whole_part,
)
from sss_ref.passes.blur import EMPTY_SUM, Scattered, renormalized


@function
def on_surface(position_world: Texture[vec3], coverage: Texture[bool], at: ivec2, here: vec3, ahead: vec3) -> float:
    """1 where a texel shows the model within the kernel's reach before or behind a point, else 0.

    ahead: the camera's direction divided by that reach.
    """
    reaches = dot(texel_clamped(position_world, at) - here, ahead)
    return select(texel_clamped(coverage, at) & (max(reaches, -reaches) <= 1.0), 1.0, 0.0)


@function
def lit_with_share(lit: Texture[vec3], at: ivec2, share: float) -> vec4:
    """The lit model at a texel times its share, and the share."""
    return vec4(texel_clamped(lit, at) * share, share)


@function
def tap_on_surface(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    offset: vec2,
    ahead: vec3,
) -> vec4:
    """A tap's bilinear sample without whatever does not lie on the surface of the pixel, and the share that does."""
    corner = pixel + whole_part(offset)
    right = corner + ivec2(1, 0)
    above = corner + ivec2(0, 1)
    beyond = corner + ivec2(1, 1)
    here = texel(position_world, pixel)
    return bilinear_blend(
        lit_with_share(lit, corner, on_surface(position_world, coverage, corner, here, ahead)),
        lit_with_share(lit, right, on_surface(position_world, coverage, right, here, ahead)),
        lit_with_share(lit, above, on_surface(position_world, coverage, above, here, ahead)),
        lit_with_share(lit, beyond, on_surface(position_world, coverage, beyond, here, ahead)),
        fractional_part(offset),
    )


@stage(source="paper 3.2, Table 1, with what lies off the surface taken as the centre")
def scatter_on_surface(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    pixel_scale: float,
    ahead: vec3,
) -> Scattered:
    """The weighted sum of all taps; as far as one lies off the surface it has the colour of the pixel itself."""
    centre = texel(lit, pixel)
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        sample = tap_on_surface(lit, coverage, position_world, pixel, tap_offset[tap] * pixel_scale, ahead)
        total = total + (sample.xyz + centre * (1.0 - sample.w)) * tap_weight[tap]
    return Scattered(total)


@stage(source="paper 3.2, Table 1, without what lies off the surface")
def scatter_inside_surface(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    pixel_scale: float,
    ahead: vec3,
) -> Scattered:
    """As scatter_inside, where a tap counts by how much of it lies on the surface of the pixel."""
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    kept = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    all_weights = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        sample = tap_on_surface(lit, coverage, position_world, pixel, tap_offset[tap] * pixel_scale, ahead)
        total = total + sample.xyz * tap_weight[tap]
        kept = kept + tap_weight[tap] * sample.w
        all_weights = all_weights + tap_weight[tap]
    return Scattered(renormalized(total, kept, all_weights, texel(lit, pixel)))
