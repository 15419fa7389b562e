"""The blur: light that scatters below the surface leaves beside where it entered (paper 2.1, 3.2, Table 1).

A tap of the kernel is an offset in pixels with one weight per colour channel. Its offset is split once into whole
pixels and a fraction, so a picture moved by whole pixels blurs to the moved result, bit for bit.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    bilinear_blend,
    constant,
    fractional_part,
    function,
    ivec2,
    sample_bilinear,
    select,
    stage,
    texel,
    texel_clamped,
    vec2,
    vec3,
    whole_part,
)

EMPTY_SUM = constant(-0.0)  # -0 + x is x for every x, so a sum from here has the bits of one from its first term


class Scattered(NamedTuple):
    """The lit model after local scattering."""

    scattered: vec3  # linear RGB


@function
def tap_sample(picture: Texture[vec3], pixel: ivec2, offset: vec2) -> vec3:
    """The picture at a pixel moved by an offset in pixels, bilinear, clamped to the edge."""
    return sample_bilinear(picture, pixel + whole_part(offset), fractional_part(offset))


@stage(source="paper 3.2, Table 1")
def scatter(
    lit: Texture[vec3],
    pixel: ivec2,
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    pixel_scale: float,
) -> Scattered:
    """The weighted sum of all taps, in order."""
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        total = total + tap_sample(lit, pixel, tap_offset[tap] * pixel_scale) * tap_weight[tap]
    return Scattered(total)


class Tap(NamedTuple):
    """What one tap adds to the sum."""

    tap: vec3  # linear RGB


@stage(source="paper 3.2, Table 1, one row")
def single_tap(lit: Texture[vec3], pixel: ivec2, offset: vec2, weight: vec3, pixel_scale: float) -> Tap:
    """One summand of `scatter`: the sample at the tap's offset, times its weight."""
    return Tap(tap_sample(lit, pixel, offset * pixel_scale) * weight)


@function
def covered(coverage: Texture[bool], at: ivec2) -> float:
    """1 where the model covers a pixel, else 0; clamped to the edge."""
    return select(texel_clamped(coverage, at), 1.0, 0.0)


@function
def lit_inside(lit: Texture[vec3], coverage: Texture[bool], at: ivec2) -> vec3:
    """The lit model at a texel, black beside it; clamped to the edge."""
    return texel_clamped(lit, at) * covered(coverage, at)


@function
def tap_inside(lit: Texture[vec3], coverage: Texture[bool], pixel: ivec2, offset: vec2) -> vec3:
    """As tap_sample, of the lit model without whatever stands beside it."""
    corner = pixel + whole_part(offset)
    return bilinear_blend(
        lit_inside(lit, coverage, corner),
        lit_inside(lit, coverage, corner + ivec2(1, 0)),
        lit_inside(lit, coverage, corner + ivec2(0, 1)),
        lit_inside(lit, coverage, corner + ivec2(1, 1)),
        fractional_part(offset),
    )


@function
def tap_coverage(coverage: Texture[bool], pixel: ivec2, offset: vec2) -> float:
    """How much of a tap's bilinear sample lies on the model, 0 to 1."""
    corner = pixel + whole_part(offset)
    return bilinear_blend(
        covered(coverage, corner),
        covered(coverage, corner + ivec2(1, 0)),
        covered(coverage, corner + ivec2(0, 1)),
        covered(coverage, corner + ivec2(1, 1)),
        fractional_part(offset),
    )


@function
def renormalized(total: vec3, kept: vec3, all_weights: vec3, unblurred: vec3) -> vec3:
    """Give the weight of taps beside the model to those on it, channel by channel; no tap on it: no blur."""
    return vec3(
        select(kept.x == 0.0, unblurred.x, total.x * (all_weights.x / kept.x)),
        select(kept.y == 0.0, unblurred.y, total.y * (all_weights.y / kept.y)),
        select(kept.z == 0.0, unblurred.z, total.z * (all_weights.z / kept.z)),
    )


@stage(source="paper 3.2, Table 1, with the stencil applied to every tap")
def scatter_inside(
    lit: Texture[vec3],
    coverage: Texture[bool],
    pixel: ivec2,
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    pixel_scale: float,
) -> Scattered:
    """The blur that lets no background in: a tap counts by how much of it lies on the model."""
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    kept = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    all_weights = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        total = total + tap_inside(lit, coverage, pixel, tap_offset[tap] * pixel_scale) * tap_weight[tap]
        kept = kept + tap_weight[tap] * tap_coverage(coverage, pixel, tap_offset[tap] * pixel_scale)
        all_weights = all_weights + tap_weight[tap]
    return Scattered(renormalized(total, kept, all_weights, texel(lit, pixel)))
