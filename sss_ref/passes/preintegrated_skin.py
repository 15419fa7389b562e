"""Pre-integrated skin: light that goes round a bend, from a table over N.L and curvature (Penner and Borshukov 2011).

The sharper a surface is bent, the farther light goes round. A table has, for each curvature, what a ring of it gives
back at every angle to the light. No picture is blurred: a fragment knows all that counts.
"""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    dot,
    float32,
    fractional_part,
    function,
    length,
    mat4,
    max,
    min,
    normalize,
    sample_bilinear,
    size,
    stage,
    vec2,
    vec3,
    vec4,
    whole_part,
)
from sss_ref.passes.phong import Phong, highlight
from sss_ref.passes.shadow_map import DirectlyLit, footprint


class Curvature(NamedTuple):
    """How sharply the surface is bent."""

    curvature: float  # per mm: 1 over the radius of a ball that is bent as much


@stage(source="Penner and Borshukov 2011, of vertices in the place of a pixel's derivatives")
def surface_curvature(
    triangle: int,
    position_world: vec3,
    triangle_curvature: Array[vec4],
    sharpest_curvature: float,
    mm_per_unit: float,
) -> Curvature:
    """(g.P + c)/mm_per_unit, g and c being the triangle's, held between 0 and what the table ends at."""
    plane = triangle_curvature[triangle]
    bent = (dot(plane.xyz, position_world) + plane.w) / mm_per_unit
    return Curvature(min(max(bent, 0.0), sharpest_curvature))


@stage(source="paper 3.2, with a bias that follows the slope")
def directly_lit_round(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    light_clip_from_world: mat4,
    light_texel_size: float,
    stored_distance: float,
    bias_abs: float,
    bias_slope: float,
) -> DirectlyLit:
    """As directly_lit_slope for what faces the light; what faces away is in no shadow, which the table has already."""
    to_light = normalize(light_position - position_world)
    facing = dot(normal_world, to_light)
    clip = light_clip_from_world * vec4(position_world, 1.0)
    texel_width = max(clip.w, 0.0) * light_texel_size
    bias = bias_abs + bias_slope * (texel_width * footprint(facing))
    behind = length(position_world - light_position) - stored_distance
    return DirectlyLit((facing <= 0.0) | (behind <= bias))


@function
def diffused(diffusion_table: Texture[vec3], cosine: float, bent: float) -> vec3:
    """The table at N.L, -1 to 1, and at a curvature as a share of the sharpest, bilinear from texel to texel."""
    extent = size(diffusion_table)
    across = min(max(cosine * 0.5 + 0.5, 0.0), 1.0) * float32(extent.x - 1)
    at = vec2(across, bent * float32(extent.y - 1))
    return sample_bilinear(diffusion_table, whole_part(at), fractional_part(at))


@stage(source="Penner and Borshukov 2011, after Phong 1975")
def phong_preintegrated(
    position_world: vec3,
    normal_world: vec3,
    albedo: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    curvature: float,
    diffusion_table: Texture[vec3],
    sharpest_curvature: float,
    ambient: float,
    diffuse: float,
    specular: float,
    shininess: float,
    light_count: float,
) -> Phong:
    """phong_shading with what the table has at N.L in the place of max(N.L, 0)."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    around = diffused(diffusion_table, dot(normal_world, to_light), curvature / sharpest_curvature)
    mirror = specular * highlight(normal_world, to_light, to_eye, shininess)
    return Phong(((ambient / light_count + incident_light * (around * diffuse)) + incident_light * mirror) * albedo)
