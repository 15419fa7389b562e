"""Texture-space subsurface scattering (paper 2.2 and 3.3): shadow map, irradiance map and its blur, camera."""

from sss_ref.language import Stage
from sss_ref.language.pipeline import MeshDraw, Method, Pass, ScreenDraw
from sss_ref.methods.per_light import Lights
from sss_ref.methods.shared import CAMERA_VIEW, behind_the_surface, light_at_the_surface, shadow_maps
from sss_ref.passes import blur, irradiance, shadow_map, texture_image
from sss_ref.passes.buffers import PARTIAL, TEXEL
from sss_ref.passes.camera import surface
from sss_ref.passes.vertex import layout_vertex
from sss_ref.scene_file.settings import SceneFile

MODE = {
    "paper": irradiance.irradiance_paper,
    "lambert": irradiance.irradiance_lambert,
    "distance": irradiance.irradiance_distance,
}
USED = {"sqrt": texture_image.irradiance_replaced, "product": texture_image.irradiance_added}
BLUR = {"none": blur.scatter, "output": blur.scatter, "taps": blur.scatter_inside}

LAYOUT = MeshDraw(layout_vertex, coverage="irradiance_mask", layout=True)


def texture_space(settings: SceneFile) -> Method:
    """The passes, each named alternative of the scene file put in as the stage it stands for."""
    lights = Lights(settings)
    used = (
        *lights.each(texture_image.irradiance_lookup),
        *lights.each(USED[settings.irradiance_map.image]),
        *lights.summed("irradiance_used"),
    )
    camera = (*behind_the_surface(settings, lights), *used, *image(settings, lights))
    return Method(
        "texture_space",
        passes=(
            *shadow_maps(lights, shadow_map.uv_at_light),
            Pass("irradiance_map", "irradiance_map", LAYOUT, irradiance_stages(settings, lights), registers=(TEXEL,)),
            *(each for suffix in lights.suffixes for each in scattered(settings, lights, suffix)),
            Pass("camera", "camera", CAMERA_VIEW, camera, registers=(PARTIAL, "gloss")),
        ),
    )


def irradiance_stages(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The irradiance of every light at a texel's point of the surface."""
    return in_texels(surface, *light_at_the_surface(settings, lights), *lights.each(MODE[settings.irradiance_map.mode]))


def in_texels(*stages: Stage) -> tuple[Stage, ...]:
    """Stages whose values on the way to the irradiance have names of their own, apart from those of the camera."""
    written = {name for stage in stages for name in stage.writes.values() if not name.startswith("irradiance")}
    return tuple(stage.renamed(lambda name: TEXEL + name if name in written else name) for stage in stages)


def scattered(settings: SceneFile, lights: Lights, suffix: str) -> tuple[Pass, Pass]:
    """Dilation and blur of one light's irradiance map."""
    rename = lights.numbered(suffix)
    keep_mask = irradiance.dilate.renamed(lambda name: name if name == "irradiance_mask" else rename(name))
    filled = Pass(
        f"irradiance_fill{suffix}",
        "irradiance_map",
        ScreenDraw(),
        (keep_mask,),
        rounds=settings.irradiance_map.dilate,
        feedback={
            rename("irradiance"): rename("irradiance_filled"),
            "irradiance_mask": rename("irradiance_filled_mask"),
        },
    )
    names = {"lit": rename("irradiance_filled"), "scattered": rename("scattered_irradiance")}
    if settings.blur.mask == "taps":
        names["coverage"] = rename("irradiance_filled_mask")
    stage = BLUR[settings.blur.mask].bound(**names)
    return filled, Pass(f"irradiance_blur{suffix}", "irradiance_map", ScreenDraw(), (stage,))


def image(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The picture from irradiance and Phong colour, or from irradiance, albedo and highlights."""
    if settings.irradiance_map.image == "sqrt":
        return (texture_image.image_sqrt,)
    gloss = (*lights.each(texture_image.gloss_where_lit), *lights.summed("gloss"))
    return (*gloss, texture_image.image_product)
