"""The surface that the camera sees: what every lighting stage starts from (paper 3.2)."""

from typing import NamedTuple

from sss_ref.language import Array, Texture, normalize, sample_bilinear_repeat, stage, vec2, vec3


class Surface(NamedTuple):
    """The point of the mesh that a pixel shows."""

    position_world: vec3  # scene units
    normal_world: vec3  # unit
    uv: vec2  # origin at the bottom left


@stage(source="paper 3.2")
def surface(fragment_position: vec3, fragment_normal: vec3, fragment_uv: vec2) -> Surface:
    """The interpolated point; its normal is made unit here, never before (rule R6)."""
    return Surface(fragment_position, normalize(fragment_normal), fragment_uv)


class Albedo(NamedTuple):
    """The share of light that the surface reflects."""

    albedo: vec3  # linear RGB


@stage(source="paper 3.2: the material of Phong's model")
def albedo_constant(mesh_color: vec3) -> Albedo:
    """A surface of one colour."""
    return Albedo(mesh_color)


@stage(source="rule R9, with GL_REPEAT")
def albedo_textured(uv: vec2, albedo_map: Texture[vec3]) -> Albedo:
    """A colour texture over the surface; beyond its edges it repeats."""
    return Albedo(sample_bilinear_repeat(albedo_map, uv))


@stage(source="the materials of the mesh file")
def albedo_by_material(triangle: int, triangle_material: Array[int], material_color: Array[vec3]) -> Albedo:
    """One colour per material; a triangle has one material, so nothing is interpolated."""
    return Albedo(material_color[triangle_material[triangle]])
