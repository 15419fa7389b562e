"""What pictures over the surface say of it beside its colour: finer normals, and where it shines."""

from typing import NamedTuple

from sss_ref.language import Texture, cross, dot, normalize, sample_bilinear_repeat, select, stage, vec2, vec3, vec4


class MappedNormal(NamedTuple):
    """The normal that light falls on."""

    normal_world: vec3  # unit


@stage(source="glTF 2.0, 3.9.3: tangent-space normals")
def normal_mapped(
    unmapped_normal_world: vec3, fragment_tangent: vec4, uv: vec2, normal_map: Texture[vec3], normal_scale: vec2
) -> MappedNormal:
    """The normal of the map, whose x runs along u, y along v and z along the surface's own normal N.

    T is the interpolated tangent made unit and perpendicular to N, B = cross(N, T), turned where the map is mirrored.
    Without tangent the normal stays N.
    """
    mapped = sample_bilinear_repeat(normal_map, uv) * 2.0 - 1.0
    tangent = fragment_tangent.xyz
    along = normalize(tangent - unmapped_normal_world * dot(unmapped_normal_world, tangent))
    across = cross(unmapped_normal_world, along) * select(fragment_tangent.w < 0.0, -1.0, 1.0)
    sideways = along * (mapped.x * normal_scale.x) + across * (mapped.y * normal_scale.y)
    bent = normalize(sideways + unmapped_normal_world * mapped.z)
    return MappedNormal(select(dot(along, along) > 0.0, bent, unmapped_normal_world))


class MappedSpecular(NamedTuple):
    """The weight of the highlight at a point of the surface."""

    mapped_specular: float


@stage(source="rule R9, with GL_REPEAT")
def specular_mapped(uv: vec2, specular_map: Texture[vec3], specular: float) -> MappedSpecular:
    """The weight of all highlights times that of the map, which is grey."""
    return MappedSpecular(specular * sample_bilinear_repeat(specular_map, uv).x)
