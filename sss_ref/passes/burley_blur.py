"""Normalized diffusion, sampled on the picture: Burley's profile around each pixel, by the distance in the body.

R(r) = (e^(-r/d) + e^(-r/(3*d))) / (8*pi*d*r), whose integral over the plane is 1: all light that enters leaves. The
samples lie where the widest channel's light does, so each counts by R at its distance over how densely they lie.
"""

from sss_ref.language import (
    Array,
    Texture,
    dot,
    exp,
    function,
    ivec2,
    select,
    sqrt,
    stage,
    texel,
    texel_clamped,
    vec2,
    vec3,
    vec4,
    whole_part,
)
from sss_ref.passes.blur import EMPTY_SUM, Scattered, covered
from sss_ref.passes.blur_on_surface import lit_with_share


@function
def normalized_diffusion(distance: float, scatter_distance: float) -> float:
    """R at a distance above 0, both in mm, times 8*pi, which every sample has: e^(-r/d) is the cube of e^(-r/(3*d))."""
    third = exp(-distance / (3.0 * scatter_distance))
    return (third * third * third + third) / (scatter_distance * distance)


@function
def lit_near(lit: Texture[vec3], coverage: Texture[bool], pixel: ivec2, offset: vec2) -> vec4:
    """The lit model at the texel nearest to an offset in pixels, and 1 for it; 0 beside the model."""
    at = pixel + whole_part(offset + 0.5)
    return lit_with_share(lit, at, covered(coverage, at))


@function
def depth_near(position_world: Texture[vec3], pixel: ivec2, offset: vec2, here: vec3, ahead: vec3) -> float:
    """How far before or behind a point that texel lies, as a share of the kernel's reach."""
    at = pixel + whole_part(offset + 0.5)
    return dot(texel_clamped(position_world, at) - here, ahead)


@stage(source="Christensen and Burley 2015, sampled on the picture; Golubev 2018")
def scatter_burley(
    lit: Texture[vec3],
    coverage: Texture[bool],
    position_world: Texture[vec3],
    pixel: ivec2,
    sample_place: Array[vec2],
    sample_radius: Array[float],
    sample_area: Array[float],
    sample_count: int,
    scatter_distance: vec3,
    reach_mm: float,
    pixels_per_offset: float,
    ahead: vec3,
) -> Scattered:
    """The mean of the samples on the model, weighed by R at sqrt(r^2 + z^2) times the area that each stands for.

    r is the sample's radius in mm, z how far its texel, the nearest one, lies before or behind the pixel.
    """
    here = texel(position_world, pixel)
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    whole = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for k in range(0, sample_count):
        offset = sample_place[k] * pixels_per_offset
        depth = depth_near(position_world, pixel, offset, here, ahead) * reach_mm
        distance = sqrt(sample_radius[k] * sample_radius[k] + depth * depth)
        seen = lit_near(lit, coverage, pixel, offset)
        area = sample_area[k] * seen.w
        weight = vec3(
            normalized_diffusion(distance, scatter_distance.x) * area,
            normalized_diffusion(distance, scatter_distance.y) * area,
            normalized_diffusion(distance, scatter_distance.z) * area,
        )
        total = total + seen.xyz * weight
        whole = whole + weight
    own = texel(lit, pixel)
    return Scattered(
        vec3(
            select(whole.x == 0.0, own.x, total.x / whole.x),
            select(whole.y == 0.0, own.y, total.y / whole.y),
            select(whole.z == 0.0, own.z, total.z / whole.z),
        )
    )
