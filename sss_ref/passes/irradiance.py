"""Irradiance in texture space: the light that arrives at the surface, laid out flat by UV (paper 2.2, 3.3)."""

from typing import NamedTuple

from sss_ref.language import Texture, dot, function, ivec2, length, max, normalize, select, size, stage, texel, vec3


class Irradiance(NamedTuple):
    """What the irradiance map stores."""

    irradiance: vec3  # linear RGB


@stage(source="paper 2.2: the distance to the light source times the dot product")
def irradiance_paper(
    position_world: vec3, normal_world: vec3, light_position: vec3, incident_light: vec3
) -> Irradiance:
    """e * (D * max(N.L, 0)), literally: it grows with the distance D to the light."""
    distance = length(position_world - light_position)
    to_light = normalize(light_position - position_world)
    return Irradiance(incident_light * (distance * max(dot(normal_world, to_light), 0.0)))


@stage(source="Lambert's cosine law, with the shadow map")
def irradiance_lambert(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    incident_light: vec3,
    directly_lit: bool,
    shadow_valid: bool,
) -> Irradiance:
    """e * max(N.L, 0) where the light reaches the surface or its map knows nothing of it, else 0."""
    to_light = normalize(light_position - position_world)
    facing = max(dot(normal_world, to_light), 0.0)
    return Irradiance(incident_light * select(directly_lit, facing, select(shadow_valid, 0.0, facing)))


@stage(source="what the printed figures show")
def irradiance_distance(position_world: vec3, light_position: vec3, incident_light: vec3) -> Irradiance:
    """e * D: the distance to the light alone."""
    return Irradiance(incident_light * length(position_world - light_position))


class Filled(NamedTuple):
    """The irradiance map with its charts widened into the gaps between them."""

    irradiance_filled: vec3  # linear RGB
    irradiance_filled_mask: bool


@function
def inside(mask: Texture[bool], at: ivec2) -> bool:
    """Whether a texel lies on the map and is covered."""
    extent = size(mask)
    on_map = (at.x >= 0) & (at.y >= 0) & (at.x < extent.x) & (at.y < extent.y)
    safe = select(on_map, at, ivec2(0, 0))
    return on_map & texel(mask, safe)


@function
def neighbour(mask: Texture[bool], pixel: ivec2) -> ivec2:
    """The texel to copy: itself if covered, else its first covered neighbour (rule R8), else itself."""
    left = pixel + ivec2(-1, 0)
    right = pixel + ivec2(1, 0)
    below = pixel + ivec2(0, -1)
    above = pixel + ivec2(0, 1)
    corner_1 = pixel + ivec2(-1, -1)
    corner_2 = pixel + ivec2(1, -1)
    corner_3 = pixel + ivec2(-1, 1)
    corner_4 = pixel + ivec2(1, 1)
    from_4 = select(inside(mask, corner_4), corner_4, pixel)
    from_3 = select(inside(mask, corner_3), corner_3, from_4)
    from_2 = select(inside(mask, corner_2), corner_2, from_3)
    from_1 = select(inside(mask, corner_1), corner_1, from_2)
    from_above = select(inside(mask, above), above, from_1)
    from_below = select(inside(mask, below), below, from_above)
    from_right = select(inside(mask, right), right, from_below)
    from_left = select(inside(mask, left), left, from_right)
    return select(texel(mask, pixel), pixel, from_left)


@stage(source="padding of a texture atlas, one texel")
def dilate(irradiance: Texture[vec3], irradiance_mask: Texture[bool], pixel: ivec2) -> Filled:
    """Widen every chart by one texel: an uncovered texel copies its first covered neighbour of the round before."""
    chosen = neighbour(irradiance_mask, pixel)
    return Filled(texel(irradiance, chosen), texel(irradiance_mask, chosen))
