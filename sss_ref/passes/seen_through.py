"""A body inside another one, such as dentine under enamel: how much light passes between the two surfaces (paper 1.2).

On its way it is weakened channel by channel, which is why a body farther inside looks darker and of another colour.
"""

from typing import NamedTuple

from sss_ref.language import Texture, exp, function, length, max, nearest_texel, select, size, stage, texel, vec2, vec3
from sss_ref.passes.shadow_map import holds_surface


@function
def passed(light: vec3, way: float, extinction_per_mm: vec3) -> vec3:
    """What is left of light after a way in mm."""
    return light * vec3(
        exp(-extinction_per_mm.x * way), exp(-extinction_per_mm.y * way), exp(-extinction_per_mm.z * way)
    )


class LightInside(NamedTuple):
    """The light that reaches the inner body."""

    incident_light: vec3  # linear RGB


@stage(source="Beer-Lambert law, along the light's ray")
def light_inside(
    light_around: vec3,
    shadow_uv: vec2,
    stored_distance: float,
    around_distance: Texture[float],
    around_triangle: Texture[int],
    extinction_per_mm: vec3,
    mm_per_unit: float,
) -> LightInside:
    """What is left of the light from the mesh around, where its ray enters that, to the inner body, where it meets it.

    around_distance, around_triangle: the shadow map of the mesh around; stored_distance comes from that of the body.
    """
    entered = texel(around_distance, nearest_texel(size(around_distance), shadow_uv))
    way = select(holds_surface(around_triangle, shadow_uv), max(stored_distance - entered, 0.0), 0.0)
    return LightInside(passed(light_around, way * mm_per_unit, extinction_per_mm))


class Seen(NamedTuple):
    """Both bodies as they are seen, before any of it scatters sideways."""

    way_to_inner: float  # mm from the surface to the inner body, along the line of sight
    seen: vec3  # linear RGB


@stage(source="Beer-Lambert law, along the line of sight")
def seen_through(
    lit: vec3,
    position_world: vec3,
    inner_lit: vec3,
    inner_position_world: vec3,
    inner_coverage: bool,
    camera_position: vec3,
    extinction_per_mm: vec3,
    mm_per_unit: float,
) -> Seen:
    """The outer body's light, and of the inner one's what is left after the way between the two surfaces.

    Where the inner body reaches out the way is 0.
    """
    behind = length(inner_position_world - camera_position) - length(position_world - camera_position)
    way = select(inner_coverage, max(behind, 0.0) * mm_per_unit, 0.0)
    return Seen(way, lit + passed(inner_lit, way, extinction_per_mm))
