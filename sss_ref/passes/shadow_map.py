"""The shadow map: the light's distance to the first surface, and what a fragment learns from it (paper 2.1, 3.2)."""

from typing import NamedTuple

from sss_ref.language import (
    Texture,
    constant,
    dot,
    fractional_part,
    function,
    ivec2,
    length,
    mat4,
    max,
    min,
    nearest_texel,
    normalize,
    sample_bilinear,
    select,
    size,
    sqrt,
    stage,
    texel,
    texel_clamped,
    texel_position,
    vec2,
    vec3,
    vec4,
    whole_part,
)

MIN_COSINE = constant(0.05)  # keeps the bias of grazing light finite: about 20 texels


class LightDistance(NamedTuple):
    """What the shadow map stores."""

    light_distance: float  # scene units, from the light's position, not a depth


@stage(source="paper 3.2, Figure 1")
def distance_to_light(fragment_position: vec3, light_position: vec3) -> LightDistance:
    """How far the surface lies from the light, D = |P - L|; the draw keeps the nearest."""
    return LightDistance(length(fragment_position - light_position))


class LightUv(NamedTuple):
    """Which point of the surface the shadow map saw."""

    light_uv: vec2


@stage(source="paper 2.2: it stores the fragment's UV coordinates in addition to the light distance")
def uv_at_light(fragment_uv: vec2) -> LightUv:
    """The UV of the surface point nearest to the light."""
    return LightUv(fragment_uv)


class ShadowLookup(NamedTuple):
    """Where a fragment falls on the shadow map, and what it finds there."""

    shadow_uv: vec2  # (-1, -1) behind the light or outside its map
    shadow_valid: bool  # inside the map, on a texel that holds a surface
    stored_distance: float  # scene units; the fragment's own distance where not valid


@function
def map_coordinates(clip: vec4, lookup_inset: float) -> vec2:
    """Texture coordinates of a clip-space position: ((xy/w) * inset + 1) / 2, or (-1, -1) outside the map."""
    uv = (vec2(clip.x / clip.w, clip.y / clip.w) * lookup_inset + 1.0) * 0.5
    inside = (clip.w > 0.0) & (uv.x >= 0.0) & (uv.x <= 1.0) & (uv.y >= 0.0) & (uv.y <= 1.0)
    return select(inside, uv, vec2(-1.0, -1.0))


@function
def holds_surface(light_triangle: Texture[int], uv: vec2) -> bool:
    """Whether uv lies on the map (not the -1 of map_coordinates), on a texel that is not background."""
    return (uv.x >= 0.0) & (texel(light_triangle, nearest_texel(size(light_triangle), uv)) >= 0)


@stage(source="paper 3.2")
def shadow_lookup_nearest(
    position_world: vec3,
    light_position: vec3,
    light_clip_from_world: mat4,
    lookup_inset: float,
    light_distance: Texture[float],
    light_triangle: Texture[int],
) -> ShadowLookup:
    """Unproject the fragment into the light's view and read the nearest texel."""
    uv = map_coordinates(light_clip_from_world * vec4(position_world, 1.0), lookup_inset)
    valid = holds_surface(light_triangle, uv)
    stored = texel(light_distance, nearest_texel(size(light_distance), uv))
    return ShadowLookup(uv, valid, select(valid, stored, length(position_world - light_position)))


@function
def all_surface(light_triangle: Texture[int], corner: ivec2) -> bool:
    """Whether none of the four texels of a bilinear sample is background."""
    lower = min(texel_clamped(light_triangle, corner), texel_clamped(light_triangle, corner + ivec2(1, 0)))
    upper = min(
        texel_clamped(light_triangle, corner + ivec2(0, 1)), texel_clamped(light_triangle, corner + ivec2(1, 1))
    )
    return min(lower, upper) >= 0


@stage(source="paper 3.2, with GL_LINEAR")
def shadow_lookup_bilinear(
    position_world: vec3,
    light_position: vec3,
    light_clip_from_world: mat4,
    lookup_inset: float,
    light_distance: Texture[float],
    light_triangle: Texture[int],
) -> ShadowLookup:
    """As shadow_lookup_nearest, but blend four texels; at an outline, where one is background, read the nearest."""
    uv = map_coordinates(light_clip_from_world * vec4(position_world, 1.0), lookup_inset)
    valid = holds_surface(light_triangle, uv)
    nearest = texel(light_distance, nearest_texel(size(light_distance), uv))
    at = texel_position(size(light_distance), uv)
    corner = whole_part(at)
    blended = sample_bilinear(light_distance, corner, fractional_part(at))
    stored = select(all_surface(light_triangle, corner), blended, nearest)
    return ShadowLookup(uv, valid, select(valid, stored, length(position_world - light_position)))


class BackPoint(NamedTuple):
    """The two ends of the light's way through the body."""

    entry_point: vec3  # world space, scene units: where the light entered
    thickness: float  # scene units: its way inside, the body assumed convex (paper 2.1)


@stage(source="paper 3.2")
def back_point(position_world: vec3, light_position: vec3, stored_distance: float, shadow_valid: bool) -> BackPoint:
    """Go from the light towards the fragment by the stored distance; the rest of the way lies inside the body."""
    direction = normalize(position_world - light_position)
    entry_point = select(shadow_valid, light_position + direction * stored_distance, position_world)
    return BackPoint(entry_point, length(position_world - entry_point))


@stage(source="paper 3.2, for rays that are parallel")
def back_point_parallel(
    position_world: vec3, light_position: vec3, light_direction: vec3, stored_distance: float, shadow_valid: bool
) -> BackPoint:
    """Go back against the rays by what the fragment is farther away than the stored distance: the way in the body."""
    inside = dot(position_world - light_position, light_direction) - stored_distance
    entry_point = select(shadow_valid, position_world - light_direction * inside, position_world)
    return BackPoint(entry_point, length(position_world - entry_point))


class DirectlyLit(NamedTuple):
    """The paper's two cases: whether the point on the shadow map is this very fragment."""

    directly_lit: bool


@function
def footprint(facing: float) -> float:
    """How far a texel's footprint on a surface reaches, in texels: one along it, and what it falls away, 1 + tan(a).

    facing: N.L. With c the cosine of the angle a to the light, tan(a) = sqrt(1 - c*c)/c.
    """
    cosine = min(max(max(facing, -facing), MIN_COSINE), 1.0)
    return 1.0 + sqrt(1.0 - cosine * cosine) / cosine


@stage(source="paper 3.2, with a bias that follows the slope")
def directly_lit_slope(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    light_clip_from_world: mat4,
    light_texel_size: float,
    stored_distance: float,
    bias_abs: float,
    bias_slope: float,
) -> DirectlyLit:
    """Lit if it faces the light and lies no further behind the stored surface than one texel's footprint explains.

    A texel at clip depth w covers w * light_texel_size. Behind the light (w < 0), where its map knows nothing, the
    light still shines: no bias, and nothing stored to lie behind of.
    """
    to_light = normalize(light_position - position_world)
    facing = dot(normal_world, to_light)
    clip = light_clip_from_world * vec4(position_world, 1.0)
    texel_width = max(clip.w, 0.0) * light_texel_size
    bias = bias_abs + bias_slope * (texel_width * footprint(facing))
    behind = length(position_world - light_position) - stored_distance
    return DirectlyLit((facing > 0.0) & (behind <= bias))


@stage(source="paper 3.2, literally")
def directly_lit_literal(
    position_world: vec3, light_position: vec3, stored_distance: float, bias_abs: float
) -> DirectlyLit:
    """Lit if the stored point is the fragment; with bias_abs 0 rounding alone makes half the surface speckle."""
    return DirectlyLit(length(position_world - light_position) - stored_distance <= bias_abs)
