"""Translucency: how much light comes through the body, and how it joins the lit colour (paper 2.1, 3.2)."""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    constant,
    dot,
    exp,
    function,
    genType,
    max,
    min,
    normalize,
    pow,
    select,
    stage,
    vec2,
    vec3,
)

TRANSLUCENCY_MAX = constant(65504.0)  # the largest half float, so that a dump in any format can hold it


class Translucency(NamedTuple):
    """The factor that the body's thickness leaves of the light."""

    translucency: float  # neutral where the fragment is directly lit, or lies beside the light's map


@function
def where_light_passes(term: genType, directly_lit: bool, shadow_uv: vec2, neutral: float) -> genType:
    """The term, bounded, where light may come through the body; `neutral` (1 to multiply, 0 to add) elsewhere.

    On the map's background nothing stands before the fragment: there the term is that of thickness 0.
    """
    bounded = min(term, TRANSLUCENCY_MAX)  # type: ignore[type-var]  # a number stands for all channels of a vector
    return select(directly_lit, neutral, select(shadow_uv.x >= 0.0, bounded, neutral))  # type: ignore[return-value,type-var]


@stage(source="paper 3.2: x^y / d^0.6")
def translucency_ratio(
    thickness: float,
    directly_lit: bool,
    shadow_uv: vec2,
    x: float,
    y: float,
    exponent: float,
    d_min: float,
    translucency_neutral: float,
) -> Translucency:
    """T = x^y / max(d, d_min)^exponent; x and y set the material, d_min keeps thin parts finite."""
    term = pow(x, y) / pow(max(thickness, d_min), exponent)
    return Translucency(where_light_passes(term, directly_lit, shadow_uv, translucency_neutral))


@stage(source="paper 3.2, read as x^(y / d^0.6)")
def translucency_exponent(
    thickness: float,
    directly_lit: bool,
    shadow_uv: vec2,
    x: float,
    y: float,
    exponent: float,
    d_min: float,
    translucency_neutral: float,
) -> Translucency:
    """T = x^(y / max(d, d_min)^exponent): the same formula with the fraction in the exponent."""
    term = pow(x, y / pow(max(thickness, d_min), exponent))
    return Translucency(where_light_passes(term, directly_lit, shadow_uv, translucency_neutral))


@stage(source="Beer-Lambert law")
def translucency_beer(
    thickness: float, directly_lit: bool, shadow_uv: vec2, x: float, translucency_neutral: float
) -> Translucency:
    """T = e^(-x*d): what an absorbing body of extinction x per scene unit leaves."""
    return Translucency(where_light_passes(exp(-x * thickness), directly_lit, shadow_uv, translucency_neutral))


class ChannelTranslucency(NamedTuple):
    """The factors that the body's thickness leaves of red, green and blue light."""

    translucency: vec3  # neutral as in Translucency


@stage(source="d'Eon, Luebke and Enderton 2007; Jimenez et al. 2010")
def translucency_gaussians(
    thickness: float,
    directly_lit: bool,
    shadow_uv: vec2,
    gaussian_weight: Array[vec3],
    gaussian_variance: Array[float],
    gaussian_count: int,
    mm_per_unit: float,
    translucency_neutral: float,
) -> ChannelTranslucency:
    """T = the sum of w*e^(-d^2/v), d in mm: what a material whose light spreads by these Gaussians lets through."""
    depth = thickness * mm_per_unit
    total = vec3(0.0, 0.0, 0.0)
    for term in range(0, gaussian_count):
        total = total + gaussian_weight[term] * exp(-(depth * depth) / gaussian_variance[term])
    return ChannelTranslucency(where_light_passes(total, directly_lit, shadow_uv, translucency_neutral))


class Lit(NamedTuple):
    """The model lit, with light from behind, before any of it scatters sideways."""

    lit: vec3  # linear RGB


@stage(source="paper 3.2")
def lit_multiply(phong: vec3, directly_lit: bool, translucency: float) -> Lit:
    """The paper's two cases: Phong where lit, Phong times T where the light comes through the body."""
    return Lit(select(directly_lit, phong, phong * translucency))


@stage(source="what the printed figures show")
def lit_add(
    phong: vec3,
    albedo: vec3,
    translucency: float,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    translucency_scale: float,
) -> Lit:
    """Phong plus albedo*(T*scale)*(1 - max(N.L, 0)): the more a point turns from the light, the more comes through."""
    to_light = normalize(light_position - position_world)
    turned_away = 1.0 - max(dot(normal_world, to_light), 0.0)
    return Lit(phong + albedo * ((translucency * translucency_scale) * turned_away))


@stage(source="paper 2.1, as transmitted irradiance")
def lit_transmit(
    phong: vec3,
    albedo: vec3,
    directly_lit: bool,
    translucency: float,
    incident_light: vec3,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    translucency_scale: float,
    ambient: float,
    light_count: float,
) -> Lit:
    """Phong where lit, else ambient alone; plus albedo*e*(T*scale)*max(-N.L, 0), the light that enters from behind."""
    to_light = normalize(light_position - position_world)
    from_behind = max(-dot(normal_world, to_light), 0.0)
    reflected = select(directly_lit, phong, (ambient / light_count) * albedo)
    return Lit(reflected + (albedo * incident_light) * ((translucency * translucency_scale) * from_behind))
