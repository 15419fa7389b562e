"""The picture in texture space: blurred irradiance, looked up by UV (paper 2.2, 3.3)."""

from typing import NamedTuple

from sss_ref.language import (
    Texture,
    dot,
    max,
    nearest_texel,
    normalize,
    sample_bilinear_clamped,
    select,
    size,
    sqrt,
    stage,
    texel,
    vec2,
    vec3,
)
from sss_ref.passes.composite import Image
from sss_ref.passes.phong import highlight


class IrradianceUv(NamedTuple):
    """Where on the irradiance map a fragment takes its light from."""

    irradiance_uv: vec2


@stage(source="paper 2.2: using the previously stored UV coordinates")
def irradiance_lookup(
    uv: vec2, directly_lit: bool, shadow_valid: bool, shadow_uv: vec2, light_uv: Texture[vec2]
) -> IrradianceUv:
    """The fragment's own UV where it is lit, else that of the point where its light entered the body."""
    entered = texel(light_uv, nearest_texel(size(light_uv), shadow_uv))
    return IrradianceUv(select(directly_lit, uv, select(shadow_valid, entered, uv)))


class IrradianceUsed(NamedTuple):
    """The light that a fragment gets from the irradiance map."""

    irradiance_used: vec3  # linear RGB


@stage(source="paper 2.2, 3.3")
def irradiance_replaced(
    uv: vec2, irradiance_uv: vec2, directly_lit: bool, translucency: float, scattered_irradiance: Texture[vec3]
) -> IrradianceUsed:
    """The irradiance at the fragment where it is lit, else that of the entry point times T."""
    own = sample_bilinear_clamped(scattered_irradiance, uv)
    through = sample_bilinear_clamped(scattered_irradiance, irradiance_uv) * translucency
    return IrradianceUsed(select(directly_lit, own, through))


@stage(source="paper 2.2, as transmitted irradiance")
def irradiance_added(
    uv: vec2,
    irradiance_uv: vec2,
    translucency: float,
    translucency_scale: float,
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    scattered_irradiance: Texture[vec3],
) -> IrradianceUsed:
    """The irradiance at the fragment, plus that of the entry point times (T*scale)*max(-N.L, 0)."""
    to_light = normalize(light_position - position_world)
    from_behind = (translucency * translucency_scale) * max(-dot(normal_world, to_light), 0.0)
    own = sample_bilinear_clamped(scattered_irradiance, uv)
    return IrradianceUsed(own + sample_bilinear_clamped(scattered_irradiance, irradiance_uv) * from_behind)


@stage(source="paper 2.2: sqrt(i * c)")
def image_sqrt(irradiance_used: vec3, phong: vec3) -> Image:
    """The geometric mean of irradiance and Phong colour."""
    return Image(sqrt(max(irradiance_used * phong, vec3(0.0, 0.0, 0.0))))


class Gloss(NamedTuple):
    """The highlight of one light, before the albedo."""

    gloss: vec3  # linear RGB


@stage(source="paper 3.2, Phong's specular term alone")
def gloss_where_lit(
    position_world: vec3,
    normal_world: vec3,
    light_position: vec3,
    camera_position: vec3,
    incident_light: vec3,
    directly_lit: bool,
    specular: float,
    shininess: float,
) -> Gloss:
    """e * (specular*s) where the light reaches the fragment, else 0."""
    to_light = normalize(light_position - position_world)
    to_eye = normalize(camera_position - position_world)
    shine = incident_light * (specular * highlight(normal_world, to_light, to_eye, shininess))
    return Gloss(select(directly_lit, shine, vec3(0.0, 0.0, 0.0)))


@stage(source="irradiance times albedo")
def image_product(irradiance_used: vec3, gloss: vec3, ambient: float, albedo: vec3) -> Image:
    """((ambient + i) + highlights) * albedo."""
    return Image(((ambient + irradiance_used) + gloss) * albedo)
