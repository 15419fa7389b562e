"""What both methods share: the light's views, the camera's view, and the stages up to Phong and translucency."""

from dataclasses import replace
from typing import NamedTuple

from sss_ref.language import Stage, vec3
from sss_ref.language.names import Name
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.methods.per_light import Lights, of_light
from sss_ref.passes import phong, shadow_map, soft_shadow, translucency, transmittance
from sss_ref.passes.camera import albedo_by_material, albedo_constant, albedo_textured, surface
from sss_ref.passes.surface_detail import normal_mapped, specular_mapped
from sss_ref.passes.vertex import mesh_vertex, tangent_vertex
from sss_ref.scene_file.settings import SceneFile

ALBEDO = {"constant": albedo_constant, "texture": albedo_textured, "material": albedo_by_material}
SHADOW_LOOKUP = {"nearest": shadow_map.shadow_lookup_nearest, "bilinear": shadow_map.shadow_lookup_bilinear}
SHADOW_TEST = {
    "slope": (shadow_map.directly_lit_slope,),
    "literal": (shadow_map.directly_lit_literal,),
    "kernel": (shadow_map.directly_lit_slope, soft_shadow.light_visible_kernel),
}
BACK_POINT = {"point": shadow_map.back_point, "directional": shadow_map.back_point_parallel}
FALLOFF = {"none": phong.light_constant, "inverse_square": phong.light_inverse_square}
FORM = {
    "ratio": translucency.translucency_ratio,
    "exponent": translucency.translucency_exponent,
    "beer": translucency.translucency_beer,
    "gaussians": translucency.translucency_gaussians,
}
BY_CHANNEL = ("x", "y", "exponent", "d_min", "translucency", "translucency_scale")  # one number, or one a channel
FORM_THROUGHOUT = {  # whether lit or not
    "ratio": transmittance.translucency_ratio_throughout,
    "exponent": transmittance.translucency_exponent_throughout,
    "beer": transmittance.translucency_beer_throughout,
    "gaussians": transmittance.translucency_gaussians_throughout,
}
INSIDE = {  # what is looked up for the point below the surface
    name: f"inside_{name}" for name in ("shadow_uv", "shadow_valid", "stored_distance")
}

NEUTRAL = "translucency_neutral"  # the uniform with the T that leaves the colour as it is

LIGHT_VIEW = MeshDraw(mesh_vertex.bound(clip_from_model="light_clip_from_model"), "light_triangle", "light_depth")
CAMERA_VIEW = MeshDraw(mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth", "coverage")

UNMAPPED = "unmapped_normal_world"  # the surface's own normal, where a normal map bends the one that light falls on
SHINE = "mapped_specular"  # the weight of the highlight, where a map scales it


def shadow_maps(lights: Lights, *more: Stage) -> tuple[Pass, ...]:
    """The shadow map of every light; `more`: what it stores beside the distance."""
    stages = (shadow_map.distance_to_light, *more)
    named = [(light, str(Name("shadow_map", light))) for light in lights.numbers]
    return tuple(Pass(name, "shadow_map", LIGHT_VIEW, stages).renamed(of_light(light)) for light, name in named)


def camera_view(settings: SceneFile) -> MeshDraw:
    """What the camera sees, with tangents under a normal map."""
    with_tangents = tangent_vertex.bound(clip_from_model="camera_clip_from_model")
    return replace(CAMERA_VIEW, vertex=with_tangents) if settings.mesh.normal_map else CAMERA_VIEW


def surface_stages(settings: SceneFile) -> tuple[Stage, ...]:
    """The surface; under a normal map its own normal has another name."""
    return (surface.bound(normal_world=UNMAPPED), normal_mapped) if settings.mesh.normal_map else (surface,)


def by_channel(settings: SceneFile, stage: Stage) -> Stage:
    """A stage of the translucency as it is, or, where the scene has three numbers, with one for each channel."""
    if not settings.translucency.by_channel:
        return stage
    own = {*stage.parameters, *stage.outputs}
    return stage.retyped(**{name: vec3 for name in BY_CHANNEL if name in own})


def shining(settings: SceneFile, *stages: Stage) -> tuple[Stage, ...]:
    """Stages that take the weight of the highlight from the map, if there is one."""
    if not settings.mesh.specular_map:
        return stages
    return tuple(stage.bound(specular=SHINE) if "specular" in stage.reads else stage for stage in stages)


def of_geometry(settings: SceneFile, stage: Stage) -> Stage:
    """A stage that asks for the surface itself, not for the normal of its map."""
    mapped = settings.mesh.normal_map and "normal_world" in stage.reads
    return stage.bound(normal_world=UNMAPPED) if mapped else stage


def is_wrapped(settings: SceneFile) -> bool:
    """Whether light from behind reaches every fragment: in the image `sqrt` of texture space it never does."""
    in_image = not settings.in_texture_space or settings.irradiance_map.image == "product"
    return settings.translucency.combine == "transmit_wrapped" and in_image


def is_soft(settings: SceneFile) -> bool:
    """Whether shadows have soft edges."""
    return settings.shadow_map.test == "kernel"


def is_blended(settings: SceneFile) -> bool:
    """Whether the paper's two cases are blended at a soft edge, so that T is asked for where a point is lit too."""
    return is_soft(settings) and not settings.in_texture_space and settings.translucency.combine != "add"


def thickness_below(settings: SceneFile, kind: str) -> tuple[Stage, ...]:
    """How far the light travels to what lies below a point; kind: the light's type."""
    lookup = SHADOW_LOOKUP[settings.shadow_map.filter].bound(position_world="inside_point", **INSIDE)
    at_entry = {name: own for name, own in INSIDE.items() if name != "shadow_uv"}
    entered = BACK_POINT[kind].bound(position_world="inside_point", **at_entry)
    return of_geometry(settings, transmittance.below_surface), lookup, entered


def translucency_form(settings: SceneFile) -> Stage:
    """The stage that computes T."""
    if is_wrapped(settings):
        return FORM_THROUGHOUT[settings.translucency.form].bound(shadow_uv=INSIDE["shadow_uv"])
    return (FORM_THROUGHOUT if is_blended(settings) else FORM)[settings.translucency.form]


def light_at_the_surface(
    settings: SceneFile, lights: Lights, shadow_test: tuple[Stage, ...], below: bool = False
) -> tuple[Stage, ...]:
    """For every light: what the shadow map knows of a point, whether the light reaches it, and how strong it is.

    below: whether the thickness is that of a point below it.
    """
    stages: list[Stage] = []
    for light, kind, falloff in zip(lights.numbers, lights.types, lights.falloffs, strict=True):
        own = (
            SHADOW_LOOKUP[settings.shadow_map.filter],
            *(thickness_below(settings, kind) if below else (BACK_POINT[kind],)),
            *(of_geometry(settings, stage) for stage in shadow_test),
            FALLOFF[falloff],
        )
        stages += [stage.renamed(of_light(light)) for stage in own]
    return tuple(stages)


class Shading(NamedTuple):
    """How a technique lights the surface."""

    phong: Stage
    shadow_test: tuple[Stage, ...]
    of_surface: tuple[Stage, ...] = ()  # what these ask of the surface beside its position and normal


def papers_shading(settings: SceneFile) -> Shading:
    """Phong's, and the shadow test that the scene asks for."""
    return Shading(phong.phong_shading, SHADOW_TEST[settings.shadow_map.test])


def behind_the_surface(settings: SceneFile, lights: Lights, shading: Shading | None = None) -> tuple[Stage, ...]:
    """The camera pass up to what all methods build on: surface, shadow, Phong, translucency.

    shading: of a technique that has its own; without, it is the paper's.
    """
    own = shading or papers_shading(settings)
    return (
        *surface_stages(settings),
        ALBEDO[settings.mesh.albedo],
        *((specular_mapped,) if settings.mesh.specular_map else ()),
        *own.of_surface,
        *light_at_the_surface(settings, lights, own.shadow_test, below=is_wrapped(settings)),
        *shining(settings, *lights.each(own.phong)),
        *lights.summed("phong"),
        *lights.each(by_channel(settings, translucency_form(settings))),
    )
