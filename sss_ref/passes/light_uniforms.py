"""What a stage may read of a light: the uniforms that each light has for itself."""

from typing import NamedTuple

from sss_ref.language import mat4, vec3


class LightUniforms(NamedTuple):
    """One light and the view of its shadow map. With several lights each name ends in the light's number."""

    light_clip_from_model: mat4
    light_clip_from_world: mat4
    light_position: vec3  # scene units, world space; of a directional light on the plane that distances count from
    light_direction: vec3  # unit vector, world space: the way that its view looks, and parallel rays go
    light_color: vec3  # linear RGB
    light_intensity: float
    light_texel_size: float  # width of a texel of the shadow map where the clip depth w is 1, scene units
    light_clear_distance: float  # what stands in the shadow map where nothing is drawn, scene units
