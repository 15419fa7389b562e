"""Six Gaussians on the layout, one after the other: light that spreads by each (d'Eon and Luebke, GPU Gems 3, ch. 14).

Each blurs what the one before gave, by what it is wider, along the rows and then along the columns. How far apart its
taps are on the map says the stretch of the surface there.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    bilinear_blend,
    constant,
    dot,
    exp,
    fractional_part,
    function,
    ivec2,
    max,
    min,
    mix,
    nearest_texel,
    normalize,
    sample_bilinear_clamped,
    select,
    size,
    sqrt,
    stage,
    texel,
    vec2,
    vec3,
    vec4,
    whole_part,
)
from sss_ref.passes.blur import EMPTY_SUM, covered
from sss_ref.passes.blur_on_surface import lit_with_share
from sss_ref.passes.texture_image import IrradianceUsed

TAPS = 7  # one standard deviation apart
FAR_APART = constant(6.0)  # standard deviations: nearer than that the far side's light is partly the fragment's own


class Spread(NamedTuple):
    """Irradiance after one Gaussian along an axis of the layout."""

    spread: vec3  # linear RGB


@function
def tap_on_layout(irradiance: Texture[vec3], irradiance_mask: Texture[bool], pixel: ivec2, offset: vec2) -> vec4:
    """The map at an offset in texels, bilinear, without what lies beside the charts, and how much is on them."""
    corner = pixel + whole_part(offset)
    right = corner + ivec2(1, 0)
    above = corner + ivec2(0, 1)
    beyond = corner + ivec2(1, 1)
    return bilinear_blend(
        lit_with_share(irradiance, corner, covered(irradiance_mask, corner)),
        lit_with_share(irradiance, right, covered(irradiance_mask, right)),
        lit_with_share(irradiance, above, covered(irradiance_mask, above)),
        lit_with_share(irradiance, beyond, covered(irradiance_mask, beyond)),
        fractional_part(offset),
    )


@function
def of_whole(total: vec4, unblurred: vec3) -> vec3:
    """A sum over its weight; where nothing has weight, what is there."""
    return select(total.w == 0.0, unblurred, total.xyz / total.w)


@stage(source="d'Eon and Luebke 2007: one of the two axes")
def gaussian_along(
    irradiance: Texture[vec3],
    irradiance_mask: Texture[bool],
    pixel: ivec2,
    spread_mm: float,
    spread_offset: Array[vec2],
    spread_weight: Array[float],
    texels_per_mm: vec2,
) -> Spread:
    """The mean of seven taps on the charts, from 3 standard deviations before to 3 behind."""
    total = vec4(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, TAPS):
        offset = (spread_offset[tap] * spread_mm) * texels_per_mm
        total = total + tap_on_layout(irradiance, irradiance_mask, pixel, offset) * spread_weight[tap]
    return Spread(of_whole(total, texel(irradiance, pixel)))


class LightNormal(NamedTuple):
    """Which way the surface faces that the shadow map saw."""

    light_normal: vec3  # unit, world space


@stage(source="d'Eon and Luebke 2007: the normal where light entered")
def normal_at_light(fragment_normal: vec3) -> LightNormal:
    """The normal of the surface point nearest to the light."""
    return LightNormal(normalize(fragment_normal))


@function
def through(depth: float, apart: float, variance: float) -> float:
    """What of a Gaussian's light comes through a depth, e^(-z^2/(2*v)), less where both points lie near; all in mm."""
    return exp(-(depth * depth) / (2.0 * variance)) * min(apart / (FAR_APART * sqrt(variance)), 1.0)


@function
def of_both(spread: Texture[vec3], uv: vec2, entry_uv: vec2, comes: float) -> vec3:
    """The light of one Gaussian at the fragment, and what comes of it from where light from behind entered."""
    return sample_bilinear_clamped(spread, uv) + sample_bilinear_clamped(spread, entry_uv) * comes


@stage(source="d'Eon and Luebke 2007: modified translucent shadow maps")
def irradiance_of_gaussians(
    uv: vec2,
    irradiance_uv: vec2,
    shadow_uv: vec2,
    shadow_valid: bool,
    light_normal: Texture[vec3],
    thickness: float,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    mm_per_unit: float,
    profile_weight: Array[vec3],
    profile_variance: Array[float],
    spread_a: Texture[vec3],
    spread_b: Texture[vec3],
    spread_c: Texture[vec3],
    spread_d: Texture[vec3],
    spread_e: Texture[vec3],
    spread_f: Texture[vec3],
) -> IrradianceUsed:
    """The sum over the Gaussians of w*S(uv) and, facing away from the light, of w*S(entry)*e^(-z^2/(2*v)).

    As far as the surfaces at both ends face away from each other, z is how far they are apart, d*(-N.L), else the way d
    itself. Near the terminator both ends are one place, so the second counts by min(d/(6*sqrt(v)), 1).
    """
    facing_away = -dot(normal_world, normalize(light_position - position_world))
    comes = select(shadow_valid & (facing_away > 0.0), 1.0, 0.0)
    apart = thickness * mm_per_unit
    entered = texel(light_normal, nearest_texel(size(light_normal), shadow_uv))
    opposite = min(max(-dot(entered, normal_world), 0.0), 1.0)
    depth = mix(apart, apart * max(facing_away, 0.0), opposite)
    a = of_both(spread_a, uv, irradiance_uv, comes * through(depth, apart, profile_variance[0]))
    b = of_both(spread_b, uv, irradiance_uv, comes * through(depth, apart, profile_variance[1]))
    c = of_both(spread_c, uv, irradiance_uv, comes * through(depth, apart, profile_variance[2]))
    d = of_both(spread_d, uv, irradiance_uv, comes * through(depth, apart, profile_variance[3]))
    e = of_both(spread_e, uv, irradiance_uv, comes * through(depth, apart, profile_variance[4]))
    f = of_both(spread_f, uv, irradiance_uv, comes * through(depth, apart, profile_variance[5]))
    narrow = (a * profile_weight[0] + b * profile_weight[1]) + c * profile_weight[2]
    wide = (d * profile_weight[3] + e * profile_weight[4]) + f * profile_weight[5]
    return IrradianceUsed(narrow + wide)
