"""What the paper's printed figures compute where it is not what the text says.

They come from the paper's application: it leaves normals as the mesh file has them, looks the shadow map up once per
vertex, takes a fragment for lit only where its way through the body is exactly 0, and lets the highlight shine through.
In texture space it takes the stored distance from the irradiance map, which holds the same distance.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    dot,
    float32,
    function,
    length,
    mat4,
    max,
    min,
    normalize,
    pow,
    reflect,
    sample_bilinear_clamped,
    select,
    size,
    sqrt,
    stage,
    vec2,
    vec3,
    vec4,
)
from sss_ref.passes.blur import EMPTY_SUM
from sss_ref.passes.composite import Image
from sss_ref.passes.phong import Phong
from sss_ref.passes.shadow_map import BackPoint, DirectlyLit
from sss_ref.passes.texture_image import IrradianceUsed
from sss_ref.passes.translucency import TRANSLUCENCY_MAX, Translucency
from sss_ref.passes.vertex import MeshVertex


@stage(source="paper 3.3, Listing 1: Normal = normal")
def untransformed_vertex(
    position: vec3, normal: vec3, uv: vec2, world_from_model: mat4, clip_from_model: mat4
) -> MeshVertex:
    """One vertex of the mesh; its normal stays in the mesh's own space and is used as if it were in world space."""
    model = vec4(position, 1.0)
    world = world_from_model * model
    return MeshVertex(clip_from_model * model, world.xyz, normal, uv)


class LookupVertex(NamedTuple):
    """A vertex that already knows where the light which reaches it entered the body."""

    clip_position: vec4  # OpenGL clip space, -w <= x, y, z <= w
    fragment_position: vec3  # world space, scene units
    fragment_normal: vec3  # the mesh's own space, not unit
    fragment_uv: vec2  # origin at the bottom left
    fragment_entry_point: vec3  # world space, scene units


@function
def lookup_coordinates(clip: vec4, lookup_inset: float) -> vec2:
    """Texture coordinates of a clip-space position, ((xy/w) * inset + 1) / 2, wherever that is; 0 where w is 0."""
    uv = (vec2(clip.x / clip.w, clip.y / clip.w) * lookup_inset + 1.0) * 0.5
    return select(clip.w == 0.0, vec2(0.0, 0.0), uv)


@function
def point_at_distance(position_world: vec3, light_position: vec3, stored_distance: float) -> vec3:
    """The point that far from the light on the ray towards a position."""
    return light_position + normalize(position_world - light_position) * stored_distance


@stage(source="the printed figures; paper 3.2, in the vertex shader")
def lookup_vertex(
    position: vec3,
    normal: vec3,
    uv: vec2,
    world_from_model: mat4,
    clip_from_model: mat4,
    light_clip_from_world: mat4,
    light_position: vec3,
    lookup_inset: float,
    light_distance: Texture[float],
) -> LookupVertex:
    """As untransformed_vertex, with the shadow map read at the vertex; the entry point is interpolated from there."""
    model = vec4(position, 1.0)
    world = (world_from_model * model).xyz
    at = lookup_coordinates(light_clip_from_world * vec4(world, 1.0), lookup_inset)
    entry_point = point_at_distance(world, light_position, sample_bilinear_clamped(light_distance, at))
    return LookupVertex(clip_from_model * model, world, normal, uv, entry_point)


@stage(source="the printed figures")
def entry_interpolated(position_world: vec3, fragment_entry_point: vec3) -> BackPoint:
    """The entry point as it comes from the vertices, and the way from there."""
    return BackPoint(fragment_entry_point, length(position_world - fragment_entry_point))


@stage(source="the printed figures; the irradiance map holds D")
def entry_from_irradiance(position_world: vec3, uv: vec2, light_position: vec3, irradiance: Texture[vec3]) -> BackPoint:
    """The entry point from the distance that the irradiance map has at the fragment's own UV."""
    entry_point = point_at_distance(position_world, light_position, sample_bilinear_clamped(irradiance, uv).x)
    return BackPoint(entry_point, length(position_world - entry_point))


@stage(source="paper 3.2: identical to the fragment")
def directly_lit_exact(thickness: float) -> DirectlyLit:
    """Lit only where the thickness is exactly 0."""
    return DirectlyLit(thickness == 0.0)


@stage(source="the printed figures, after Phong 1975")
def phong_ungated(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    ambient: float,
    diffuse: float,
    specular: float,
    shininess: float,
) -> Phong:
    """(ambient + e*diffuse*max(N.L, 0) + e*specular*max(V.R, 0)^shininess) * albedo, whichever way N faces."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    lambert = diffuse * max(dot(normal_world, to_light), 0.0)
    mirrored = max(dot(to_eye, reflect(-to_light, normal_world)), 0.0)
    mirror = specular * pow(mirrored, shininess)
    return Phong(((ambient + incident_light * lambert) + incident_light * mirror) * albedo)


@stage(source="paper 3.2, read as x^(y / d^0.6)")
def translucency_unclamped(thickness: float, directly_lit: bool, x: float, y: float, exponent: float) -> Translucency:
    """T = x^(y / d^exponent) at any thickness, 0 where lit."""
    term = pow(x, y / pow(thickness, exponent))
    return Translucency(select(directly_lit, 0.0, min(term, TRANSLUCENCY_MAX)))


@stage(source="the printed figures; paper 3.3, Table 1")
def irradiance_gathered(
    uv: vec2,
    irradiance: Texture[vec3],
    tap_offset: Array[vec2],
    tap_weight: Array[vec3],
    tap_count: int,
    pixel_scale: float,
) -> IrradianceUsed:
    """The blur of the irradiance map at the fragment's own UV, each tap a bilinear sample of its own."""
    map_size = size(irradiance)
    texel_size = vec2(1.0 / float32(map_size.x), 1.0 / float32(map_size.y))
    total = vec3(EMPTY_SUM, EMPTY_SUM, EMPTY_SUM)
    for tap in range(0, tap_count):
        at = uv + (tap_offset[tap] * pixel_scale) * texel_size
        total = total + sample_bilinear_clamped(irradiance, at) * tap_weight[tap]
    return IrradianceUsed(total)


@stage(source="the printed figures; paper 2.2: sqrt(i * c)")
def image_sqrt_add(
    irradiance_used: vec3,
    phong: vec3,
    albedo: vec3,
    translucency: float,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    translucency_scale: float,
) -> Image:
    """sqrt(phong * i) + albedo*(T*scale)*(1 - max(N.L, 0)): T joins as in lit_add, after the root."""
    to_light = normalize(light_position - position_world)
    turned_away = 1.0 - max(dot(normal_world, to_light), 0.0)
    mean = sqrt(max(phong * irradiance_used, vec3(0.0, 0.0, 0.0)))
    return Image(mean + albedo * ((translucency * translucency_scale) * turned_away))
