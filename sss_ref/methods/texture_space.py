"""Texture-space subsurface scattering (paper 2.2 and 3.3): shadow map, irradiance map and its blur, camera."""

from sss_ref.language import Stage
from sss_ref.language.names import TEXEL, Name
from sss_ref.language.pipeline import MeshDraw, Method, Pass, ScreenDraw
from sss_ref.methods.per_light import Lights, of_light
from sss_ref.methods.shared import CAMERA_VIEW, NEUTRAL, behind_the_surface, light_at_the_surface, shadow_maps
from sss_ref.passes import blur, irradiance, shadow_map, texture_image
from sss_ref.passes.camera import surface
from sss_ref.passes.vertex import layout_vertex
from sss_ref.scene_file.settings import SceneFile

MODE = {
    "paper": irradiance.irradiance_paper,
    "lambert": irradiance.irradiance_lambert,
    "distance": irradiance.irradiance_distance,
}
USED = {  # how T joins the irradiance, and the T that changes nothing
    "sqrt": (texture_image.irradiance_replaced, 1.0),
    "product": (texture_image.irradiance_added, 0.0),
}
BLUR = {"none": blur.scatter, "output": blur.scatter, "taps": blur.scatter_inside}

LAYOUT = MeshDraw(layout_vertex, coverage="irradiance_mask", layout=True)


def texture_space(settings: SceneFile) -> Method:
    """The passes, each named alternative of the scene file put in as the stage it stands for."""
    lights = Lights(settings)
    join, neutral = USED[settings.irradiance_map.image]
    used = (
        *lights.each(texture_image.irradiance_lookup),
        *lights.each(join),
        *lights.summed("irradiance_used"),
    )
    camera = (*behind_the_surface(settings, lights), *used, *image(settings, lights))
    return Method(
        "texture_space",
        passes=(
            *shadow_maps(lights, shadow_map.uv_at_light),
            Pass("irradiance_map", "irradiance_map", LAYOUT, irradiance_stages(settings, lights)),
            *(each for light in lights.numbers for each in scattered(settings, light)),
            Pass("camera", "camera", CAMERA_VIEW, camera, registers=("gloss",)),
        ),
        constants={NEUTRAL: neutral},
    )


def irradiance_stages(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The irradiance of every light at a texel's point of the surface."""
    return in_texels(surface, *light_at_the_surface(settings, lights), *lights.each(MODE[settings.irradiance_map.mode]))


def in_texels(*stages: Stage) -> tuple[Stage, ...]:
    """Stages whose values on the way to the irradiance have names of their own, apart from those of the camera."""
    written = {name: Name.of(name) for stage in stages for name in stage.writes.values()}
    inside = {text: str(name.at(TEXEL)) for text, name in written.items() if name.base != "irradiance" or name.share}
    return tuple(stage.renamed(lambda text: inside.get(text, text)) for stage in stages)


def scattered(settings: SceneFile, light: int) -> tuple[Pass, Pass]:
    """Dilation and blur of one light's irradiance map."""
    filled = Pass(
        str(Name("irradiance_fill", light)),
        "irradiance_map",
        ScreenDraw(),
        (irradiance.dilate,),
        rounds=settings.irradiance_map.dilate,
        feedback={"irradiance": "irradiance_filled", "irradiance_mask": "irradiance_filled_mask"},
    )
    names = {"lit": "irradiance_filled", "scattered": "scattered_irradiance"}
    if settings.blur.mask == "taps":
        names["coverage"] = "irradiance_filled_mask"
    stage = BLUR[settings.blur.mask].bound(**names)
    blurred = Pass(str(Name("irradiance_blur", light)), "irradiance_map", ScreenDraw(), (stage,))
    return filled.renamed(of_light(light)), blurred.renamed(of_light(light))


def image(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The picture from irradiance and Phong colour, or from irradiance, albedo and highlights."""
    if settings.irradiance_map.image == "sqrt":
        return (texture_image.image_sqrt,)
    gloss = (*lights.each(texture_image.gloss_where_lit), *lights.summed("gloss"))
    return (*gloss, texture_image.image_product)
