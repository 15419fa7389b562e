"""The surface that the camera sees: what every lighting stage starts from (paper 3.2)."""

from typing import NamedTuple

from sss_ref.language import normalize, stage, vec2, vec3


class Surface(NamedTuple):
    """The point of the mesh that a pixel shows."""

    position_world: vec3  # scene units
    normal_world: vec3  # unit
    uv: vec2  # origin at the bottom left
    albedo: vec3  # linear RGB


@stage(source="paper 3.2")
def surface(fragment_position: vec3, fragment_normal: vec3, fragment_uv: vec2, mesh_color: vec3) -> Surface:
    """A surface of one colour; the interpolated normal is made unit here, never before (rule R6)."""
    return Surface(fragment_position, normalize(fragment_normal), fragment_uv, mesh_color)
