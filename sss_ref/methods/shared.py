"""What both methods share: the light's views, the camera's view, and the stages up to Phong and translucency."""

from sss_ref.language import Stage
from sss_ref.language.names import Name
from sss_ref.language.pipeline import MeshDraw, Pass
from sss_ref.methods.per_light import Lights, of_light
from sss_ref.passes import phong, shadow_map, translucency
from sss_ref.passes.camera import albedo_by_material, albedo_constant, albedo_textured, surface
from sss_ref.passes.vertex import mesh_vertex
from sss_ref.scene_file.settings import SceneFile

ALBEDO = {"constant": albedo_constant, "texture": albedo_textured, "material": albedo_by_material}
SHADOW_LOOKUP = {"nearest": shadow_map.shadow_lookup_nearest, "bilinear": shadow_map.shadow_lookup_bilinear}
SHADOW_TEST = {"slope": shadow_map.directly_lit_slope, "literal": shadow_map.directly_lit_literal}
FALLOFF = {"none": phong.light_constant, "inverse_square": phong.light_inverse_square}
FORM = {
    "ratio": translucency.translucency_ratio,
    "exponent": translucency.translucency_exponent,
    "beer": translucency.translucency_beer,
}

NEUTRAL = "translucency_neutral"  # the uniform with the T that leaves the colour as it is

LIGHT_VIEW = MeshDraw(mesh_vertex.bound(clip_from_model="light_clip_from_model"), "light_triangle", "light_depth")
CAMERA_VIEW = MeshDraw(mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth", "coverage")


def shadow_maps(lights: Lights, *more: Stage) -> tuple[Pass, ...]:
    """The shadow map of every light; `more`: what it stores beside the distance."""
    stages = (shadow_map.distance_to_light, *more)
    named = [(light, str(Name("shadow_map", light))) for light in lights.numbers]
    return tuple(Pass(name, "shadow_map", LIGHT_VIEW, stages).renamed(of_light(light)) for light, name in named)


def light_at_the_surface(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """For every light: what the shadow map knows of a point, whether the light reaches it, and how strong it is."""
    stages: list[Stage] = []
    for light, falloff in zip(lights.numbers, lights.falloffs, strict=True):
        own = (
            SHADOW_LOOKUP[settings.shadow_map.filter],
            shadow_map.back_point,
            SHADOW_TEST[settings.shadow_map.test],
            FALLOFF[falloff],
        )
        stages += [stage.renamed(of_light(light)) for stage in own]
    return tuple(stages)


def behind_the_surface(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The camera pass up to what both methods build on: surface, shadow, Phong, translucency."""
    return (
        surface,
        ALBEDO[settings.mesh.albedo],
        *light_at_the_surface(settings, lights),
        *lights.each(phong.phong_shading),
        *lights.summed("phong"),
        *lights.each(FORM[settings.translucency.form]),
    )
