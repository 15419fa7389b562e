"""Soft shadows: light that enters beside a point leaves at it too, and red light from farther than blue.

Instead of once, the shadow map is asked at every tap of the blur's kernel, laid on the surface. Each colour channel has
the weighted share of the taps that see the light, so the edge of a shadow is soft, and red.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    constant,
    cross,
    dot,
    function,
    length,
    mat4,
    max,
    min,
    nearest_texel,
    normalize,
    select,
    size,
    sqrt,
    stage,
    texel,
    vec2,
    vec3,
    vec4,
)
from sss_ref.passes.blur import EMPTY_SUM
from sss_ref.passes.irradiance import Irradiance
from sss_ref.passes.phong import highlight
from sss_ref.passes.shadow_map import footprint, holds_surface, map_coordinates
from sss_ref.passes.texture_image import Gloss
from sss_ref.passes.translucency import Lit
from sss_ref.passes.transmittance import wrapped

CURVED = constant(0.125)  # how much the bias grows along an offset: what a body falls away from its tangent plane


class LightVisible(NamedTuple):
    """How much of the light's surroundings on the surface sees the light."""

    light_visible: vec3  # 0 to 1, for red, green and blue


@function
def map_direction(clip_from_world: mat4) -> vec3:
    """The way along a row of the light's map, world space; not of unit length."""
    x = clip_from_world * vec4(1.0, 0.0, 0.0, 0.0)
    y = clip_from_world * vec4(0.0, 1.0, 0.0, 0.0)
    z = clip_from_world * vec4(0.0, 0.0, 1.0, 0.0)
    return vec3(x.x, y.x, z.x)


@function
def sees_light(uv: vec2, light_distance: Texture[float], light_triangle: Texture[int], distance: float) -> float:
    """1 where nothing stands before a distance from the light, or nothing is known, else 0."""
    stored = texel(light_distance, nearest_texel(size(light_distance), uv))
    return select(holds_surface(light_triangle, uv), select(stored >= distance, 1.0, 0.0), 1.0)


@function
def share(part: float, whole: float) -> float:
    """A part as a share of the whole, 0 to 1; of nothing it is all."""
    return select(whole == 0.0, 1.0, min(max(part / whole, 0.0), 1.0))


@stage(source="paper 2.1: sampling the shadow map with a Gaussian filter approximates the scattering")
def light_visible_kernel(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    light_clip_from_world: mat4,
    light_texel_size: float,
    lookup_inset: float,
    light_distance: Texture[float],
    light_triangle: Texture[int],
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    kernel_scale: float,
    bias_abs: float,
    bias_slope: float,
) -> LightVisible:
    """The weighted share of the taps around a point, on its tangent plane, that see the light; none on the far side.

    A tap's offset is in texels of the map times kernel_scale, X along the map's rows. Its bias is that of
    directly_lit_slope, for a width of a texel and an eighth of the offset.
    """
    facing = dot(normal_world, normalize(light_position - position_world))
    falls = footprint(facing)
    clip = light_clip_from_world * vec4(position_world, 1.0)
    texel_width = max(clip.w, 0.0) * light_texel_size
    row = map_direction(light_clip_from_world)
    across = normalize(row - normal_world * dot(normal_world, row))
    along = cross(normal_world, across)
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    whole = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        offset = tap_offset[tap] * kernel_scale
        beside = position_world + (across * offset.x + along * offset.y) * texel_width
        uv = map_coordinates(light_clip_from_world * vec4(beside, 1.0), lookup_inset)
        reach = sqrt(offset.x * offset.x + offset.y * offset.y)
        bias = bias_abs + bias_slope * (texel_width * ((1.0 + CURVED * reach) * falls))
        sees = sees_light(uv, light_distance, light_triangle, length(beside - light_position) - bias)
        total = total + tap_weight[tap] * sees
        whole = whole + tap_weight[tap]
    shares = vec3(share(total.x, whole.x), share(total.y, whole.y), share(total.z, whole.z))
    return LightVisible(select(facing > 0.0, shares, vec3(0.0, 0.0, 0.0)))


@function
def blended(shaded: vec3, bright: vec3, visible: vec3) -> vec3:
    """What is shaded where no light is seen, what is bright where all of it is; channel by channel between."""
    return shaded * (vec3(1.0, 1.0, 1.0) - visible) + bright * visible


@stage(source="paper 3.2, with a soft shadow")
def lit_multiply_soft(phong: vec3, light_visible: vec3, translucency: float) -> Lit:
    """Between the paper's two cases: Phong, and Phong times T."""
    return Lit(blended(phong * translucency, phong, light_visible))


@stage(source="paper 2.1, as transmitted irradiance, with a soft shadow")
def lit_transmit_soft(
    phong: vec3,
    albedo: vec3,
    light_visible: vec3,
    translucency: float,
    incident_light: vec3,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    translucency_scale: float,
    ambient: float,
    light_count: float,
) -> Lit:
    """Between ambient and Phong; plus albedo*e*(T*scale)*max(-N.L, 0), the light that enters from behind."""
    from_behind = max(-dot(normal_world, normalize(light_position - position_world)), 0.0)
    reflected = blended((ambient / light_count) * albedo, phong, light_visible)
    return Lit(reflected + (albedo * incident_light) * ((translucency * translucency_scale) * from_behind))


@stage(source="Jimenez et al. 2010, with a soft shadow")
def lit_transmit_wrapped_soft(
    phong: vec3,
    albedo: vec3,
    light_visible: vec3,
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
    """Between ambient and Phong; plus albedo*e*(T*scale)*max(wrap - N.L, 0)/(1 + wrap), lit or not."""
    from_behind = wrapped(dot(normal_world, normalize(light_position - position_world)), wrap)
    reflected = blended((ambient / light_count) * albedo, phong, light_visible)
    return Lit(reflected + (albedo * incident_light) * ((translucency * translucency_scale) * from_behind))


@stage(source="Lambert's cosine law, with a soft shadow")
def irradiance_lambert_soft(
    position_world: vec3, normal_world: vec3, light_position: vec3, incident_light: vec3, light_visible: vec3
) -> Irradiance:
    """e * max(N.L, 0) times what is seen of the light."""
    facing = max(dot(normal_world, normalize(light_position - position_world)), 0.0)
    return Irradiance((incident_light * light_visible) * facing)


@stage(source="paper 3.2, Phong's specular term alone, with a soft shadow")
def gloss_soft(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    light_visible: vec3,
    specular: float,
    shininess: float,
) -> Gloss:
    """e * (specular*s) times what is seen of the light."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    shine = specular * highlight(normal_world, to_light, to_eye, shininess)
    return Gloss((incident_light * light_visible) * shine)
