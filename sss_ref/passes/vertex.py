"""The vertex shader of every draw of the mesh (paper 3.2)."""

from typing import NamedTuple

from sss_ref.language import mat3, mat4, stage, vec2, vec3, vec4


class MeshVertex(NamedTuple):
    """Where a vertex goes, and what is interpolated from it for each fragment."""

    clip_position: vec4  # OpenGL clip space, -w <= x, y, z <= w
    fragment_position: vec3  # world space, scene units
    fragment_normal: vec3  # world space (of `untransformed_vertex`: the mesh's own), not unit
    fragment_uv: vec2  # origin at the bottom left


@stage(source="paper 3.2: world coordinates pass from the vertex to the fragment shader")
def mesh_vertex(
    position: vec3, normal: vec3, uv: vec2, world_from_model: mat4, normal_from_model: mat3, clip_from_model: mat4
) -> MeshVertex:
    """One vertex of the mesh, seen from the light or from the camera."""
    model = vec4(position, 1.0)
    world = world_from_model * model
    return MeshVertex(clip_from_model * model, world.xyz, normal_from_model * normal, uv)


class TangentVertex(NamedTuple):
    """As MeshVertex, with the tangent of a surface under a normal map."""

    clip_position: vec4  # OpenGL clip space, -w <= x, y, z <= w
    fragment_position: vec3  # world space, scene units
    fragment_normal: vec3  # world space, not unit
    fragment_uv: vec2  # origin at the bottom left
    fragment_tangent: vec4  # xyz along u in world space, not unit; w below 0 where the map is seen in a mirror


@stage(source="paper 3.2, with the tangents of glTF 2.0, 3.7.2.1")
def tangent_vertex(
    position: vec3,
    normal: vec3,
    uv: vec2,
    tangent: vec4,
    world_from_model: mat4,
    normal_from_model: mat3,
    handedness: float,
    clip_from_model: mat4,
) -> TangentVertex:
    """One vertex of a mesh under a normal map, seen from the camera; a placement that mirrors turns the map over."""
    model = vec4(position, 1.0)
    world = world_from_model * model
    along = world_from_model * vec4(tangent.xyz, 0.0)
    turned = vec4(along.xyz, tangent.w * handedness)
    return TangentVertex(clip_from_model * model, world.xyz, normal_from_model * normal, uv, turned)


@stage(source="paper 3.3, Listing 1, with the tangents of glTF 2.0, 3.7.2.1")
def tangent_layout_vertex(
    position: vec3,
    normal: vec3,
    uv: vec2,
    tangent: vec4,
    world_from_model: mat4,
    normal_from_model: mat3,
    handedness: float,
) -> TangentVertex:
    """One vertex of a mesh under a normal map, laid out flat by its UV."""
    world = world_from_model * vec4(position, 1.0)
    flat = uv * 2.0 - 1.0
    along = world_from_model * vec4(tangent.xyz, 0.0)
    turned = vec4(along.xyz, tangent.w * handedness)
    return TangentVertex(vec4(flat, 0.0, 1.0), world.xyz, normal_from_model * normal, uv, turned)


@stage(source="paper 3.3, Listing 1")
def layout_vertex(
    position: vec3, normal: vec3, uv: vec2, world_from_model: mat4, normal_from_model: mat3
) -> MeshVertex:
    """One vertex of the mesh, laid out flat by its UV: 0 ... 1 becomes -1 ... 1 of the device coordinates."""
    world = world_from_model * vec4(position, 1.0)
    flat = uv * 2.0 - 1.0
    return MeshVertex(vec4(flat, 0.0, 1.0), world.xyz, normal_from_model * normal, uv)
