"""Light from behind that reaches every fragment, lit or not, so that light and shade meet without a line between.

Under the skin light goes round the terminator: what enters on the lit side leaves on the dark one, and the shorter the
way is, the more of it. So the translucency is computed everywhere, for the way to a point below the surface: right at
the terminator the map's texels are too steep for the thickness of the surface itself.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    dot,
    exp,
    function,
    genType,
    mat4,
    max,
    min,
    nearest_texel,
    normalize,
    pow,
    sample_bilinear_clamped,
    select,
    size,
    stage,
    texel,
    vec2,
    vec3,
    vec4,
)
from sss_ref.passes.texture_image import IrradianceUsed, IrradianceUv
from sss_ref.passes.translucency import TRANSLUCENCY_MAX, ChannelTranslucency, Lit, Translucency


class InsidePoint(NamedTuple):
    """The point below the surface whose thickness counts."""

    inside_point: vec3  # scene units, world space


@stage(source="Jimenez et al. 2010: the surface is shrunk along its normals before the lookup")
def below_surface(
    position_world: vec3,
    normal_world: vec3,
    light_clip_from_world: mat4,
    light_texel_size: float,
    lookup_depth: float,
) -> InsidePoint:
    """Go inwards along the normal by lookup_depth widths of a texel of the light's map."""
    clip = light_clip_from_world * vec4(position_world, 1.0)
    depth = lookup_depth * (max(clip.w, 0.0) * light_texel_size)
    return InsidePoint(position_world - normal_world * depth)


@function
def inside_map(term: genType, shadow_uv: vec2, neutral: float) -> genType:
    """The term, bounded; `neutral` (1 to multiply, 0 to add) beside the light's map, which knows nothing there."""
    bounded = min(term, TRANSLUCENCY_MAX)  # type: ignore[type-var]  # a number stands for all channels of a vector
    return select(shadow_uv.x >= 0.0, bounded, neutral)  # type: ignore[return-value,type-var]


@stage(source="paper 3.2: x^y / d^0.6")
def translucency_ratio_throughout(
    thickness: float, shadow_uv: vec2, x: float, y: float, exponent: float, d_min: float, translucency_neutral: float
) -> Translucency:
    """T = x^y / max(d, d_min)^exponent, lit or not."""
    term = pow(x, y) / pow(max(thickness, d_min), exponent)
    return Translucency(inside_map(term, shadow_uv, translucency_neutral))


@stage(source="paper 3.2, read as x^(y / d^0.6)")
def translucency_exponent_throughout(
    thickness: float, shadow_uv: vec2, x: float, y: float, exponent: float, d_min: float, translucency_neutral: float
) -> Translucency:
    """T = x^(y / max(d, d_min)^exponent), lit or not."""
    term = pow(x, y / pow(max(thickness, d_min), exponent))
    return Translucency(inside_map(term, shadow_uv, translucency_neutral))


@stage(source="Beer-Lambert law")
def translucency_beer_throughout(
    thickness: float, shadow_uv: vec2, x: float, translucency_neutral: float
) -> Translucency:
    """T = e^(-x*d), lit or not."""
    return Translucency(inside_map(exp(-x * thickness), shadow_uv, translucency_neutral))


@stage(source="d'Eon, Luebke and Enderton 2007; Jimenez et al. 2010")
def translucency_gaussians_throughout(
    thickness: float,
    shadow_uv: vec2,
    gaussian_weight: Array[vec3],
    gaussian_variance: Array[float],
    gaussian_count: int,
    mm_per_unit: float,
    translucency_neutral: float,
) -> ChannelTranslucency:
    """T = the sum of w*e^(-d^2/v), d in mm, lit or not."""
    depth = thickness * mm_per_unit
    total = vec3(0.0, 0.0, 0.0)
    for term in range(0, gaussian_count):
        total = total + gaussian_weight[term] * exp(-(depth * depth) / gaussian_variance[term])
    return ChannelTranslucency(inside_map(total, shadow_uv, translucency_neutral))


@function
def wrapped(cosine: float, wrap: float) -> float:
    """How much of the light from behind leaves at this angle: max(wrap - N.L, 0)/(1 + wrap), all of it at N.L = -1."""
    return max(wrap - cosine, 0.0) / (1.0 + wrap)


@stage(source="Jimenez et al. 2010")
def lit_transmit_wrapped(
    phong: vec3,
    albedo: vec3,
    directly_lit: bool,
    translucency: float,
    incident_light: vec3,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    translucency_scale: float,
    wrap: float,
    ambient: float,
    light_count: float,
) -> Lit:
    """Phong where lit, else ambient alone; plus albedo*e*(T*scale)*max(wrap - N.L, 0)/(1 + wrap), lit or not."""
    to_light = normalize(light_position - position_world)
    from_behind = wrapped(dot(normal_world, to_light), wrap)
    reflected = select(directly_lit, phong, (ambient / light_count) * albedo)
    return Lit(reflected + (albedo * incident_light) * ((translucency * translucency_scale) * from_behind))


@stage(source="paper 2.2: using the previously stored UV coordinates")
def irradiance_lookup_throughout(
    uv: vec2, shadow_valid: bool, shadow_uv: vec2, light_uv: Texture[vec2]
) -> IrradianceUv:
    """The UV of the point where light from behind entered the body, lit or not; the own one where none is known."""
    entered = texel(light_uv, nearest_texel(size(light_uv), shadow_uv))
    return IrradianceUv(select(shadow_valid, entered, uv))


@stage(source="Jimenez et al. 2010, on the irradiance of paper 2.2")
def irradiance_added_wrapped(
    uv: vec2,
    irradiance_uv: vec2,
    translucency: float,
    translucency_scale: float,
    wrap: float,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    scattered_irradiance: Texture[vec3],
) -> IrradianceUsed:
    """The irradiance at the fragment, plus that of the entry point times (T*scale)*max(wrap - N.L, 0)/(1 + wrap)."""
    to_light = normalize(light_position - position_world)
    from_behind = (translucency * translucency_scale) * wrapped(dot(normal_world, to_light), wrap)
    own = sample_bilinear_clamped(scattered_irradiance, uv)
    return IrradianceUsed(own + sample_bilinear_clamped(scattered_irradiance, irradiance_uv) * from_behind)
