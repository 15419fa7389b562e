"""Texture-space subsurface scattering (paper 2.2 and 3.3): shadow map, irradiance map and its blur, camera."""

from dataclasses import replace

from sss_ref.language import Stage, Texture, vec2
from sss_ref.language.names import TEXEL, Name
from sss_ref.language.pipeline import MeshDraw, Method, Pass, ScreenDraw
from sss_ref.methods.per_light import Lights, of_light
from sss_ref.methods.shared import (
    INSIDE,
    NEUTRAL,
    SHADOW_TEST,
    behind_the_surface,
    by_channel,
    camera_view,
    is_soft,
    is_wrapped,
    light_at_the_surface,
    shadow_maps,
    shining,
    surface_stages,
)
from sss_ref.passes import blur, irradiance, lengths, shadow_map, soft_shadow, texture_image, transmittance
from sss_ref.passes.vertex import layout_vertex, tangent_layout_vertex
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
TANGENT_LAYOUT = replace(LAYOUT, vertex=tangent_layout_vertex)

LENGTHS_THERE = (  # of a texel and of an offset, along both axes of the layout
    lengths.texel_length.bound(triangle="irradiance_triangle"),
    lengths.offset_length.retyped(mm_per_pixel=vec2, pixels_per_offset=vec2).bound(
        mm_per_pixel="mm_per_texel", pixels_per_offset="texels_per_offset"
    ),
)
LENGTHS_FILLED = irradiance.dilate.retyped(irradiance=Texture[vec2], irradiance_filled=vec2).bound(
    irradiance="texels_per_offset",
    irradiance_filled="texels_per_offset_filled",
    irradiance_filled_mask="texels_per_offset_mask",
)


def texture_space(settings: SceneFile) -> Method:
    """The passes, each named alternative of the scene file put in as the stage it stands for."""
    lights = Lights(settings)
    camera = (*behind_the_surface(settings, lights), *used(settings, lights), *image(settings, lights))
    return Method(
        "texture_space",
        passes=(
            *shadow_maps(lights, shadow_map.uv_at_light),
            *laid_out(settings, irradiance_stages(settings, lights)),
            *(each for light in lights.numbers for each in scattered(settings, light)),
            Pass("camera", "camera", camera_view(settings), camera, registers=("gloss",)),
        ),
        constants={NEUTRAL: USED[settings.irradiance_map.image][1]},
    )


def layout(settings: SceneFile) -> MeshDraw:
    """The mesh laid out flat, with tangents under a normal map."""
    return TANGENT_LAYOUT if settings.mesh.normal_map else LAYOUT


def laid_out(settings: SceneFile, stages: tuple[Stage, ...]) -> tuple[Pass, ...]:
    """The irradiance map; where the kernel is in mm also what an offset is at each texel, beside the charts too."""
    if settings.blur.unit == "pixel":
        return (Pass("irradiance_map", "irradiance_map", layout(settings), stages),)
    return laid_out_in_mm(settings, stages, "mm_per_offset")


def laid_out_in_mm(settings: SceneFile, stages: tuple[Stage, ...], offset: str) -> tuple[Pass, Pass]:
    """The irradiance map, and how many texels an offset is; offset: the uniform that has its length in mm."""
    texel, texels_per_offset = LENGTHS_THERE
    lengths_there = texel, texels_per_offset.bound(mm_per_offset=offset)
    feedback = {"texels_per_offset": "texels_per_offset_filled", "irradiance_mask": "texels_per_offset_mask"}
    in_mm = replace(layout(settings), triangle="irradiance_triangle")
    return (
        Pass("irradiance_map", "irradiance_map", in_mm, (*lengths_there, *stages)),
        Pass(
            "offset_fill",
            "irradiance_map",
            ScreenDraw(),
            (LENGTHS_FILLED,),
            rounds=settings.irradiance_map.dilate,
            feedback=feedback,
        ),
    )


def irradiance_stages(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The irradiance of every light at a texel's point of the surface."""
    return in_texels(
        *surface_stages(settings),
        *light_at_the_surface(settings, lights, SHADOW_TEST[settings.shadow_map.test]),
        *lights.each(mode(settings)),
    )


def mode(settings: SceneFile) -> Stage:
    """The stage of the irradiance; of all modes only `lambert` asks the shadow map."""
    if is_soft(settings) and settings.irradiance_map.mode == "lambert":
        return soft_shadow.irradiance_lambert_soft
    return MODE[settings.irradiance_map.mode]


def in_texels(*stages: Stage) -> tuple[Stage, ...]:
    """Stages whose values on the way to the irradiance have names of their own, apart from those of the camera."""
    written = {name: Name.of(name) for stage in stages for name in stage.writes.values()}
    inside = {text: str(name.at(TEXEL)) for text, name in written.items() if name.base != "irradiance" or name.share}
    return tuple(stage.renamed(lambda text: inside.get(text, text)) for stage in stages)


def filled(settings: SceneFile, light: int) -> Pass:
    """The dilation of one light's irradiance map."""
    dilated = Pass(
        str(Name("irradiance_fill", light)),
        "irradiance_map",
        ScreenDraw(),
        (irradiance.dilate,),
        rounds=settings.irradiance_map.dilate,
        feedback={"irradiance": "irradiance_filled", "irradiance_mask": "irradiance_filled_mask"},
    )
    return dilated.renamed(of_light(light))


def scattered(settings: SceneFile, light: int) -> tuple[Pass, Pass]:
    """Dilation and blur of one light's irradiance map."""
    names = {"lit": "irradiance_filled", "scattered": "scattered_irradiance"}
    if settings.blur.mask == "taps":
        names["coverage"] = "irradiance_filled_mask"
    stage, draw = BLUR[settings.blur.mask].bound(**names), ScreenDraw()
    if settings.blur.unit == "mm":  # beside the widened charts no length is known
        stage = stage.retyped(pixel_scale=vec2).bound(pixel_scale="texels_per_offset_filled")
        draw = ScreenDraw("irradiance_filled_mask")
    blurred = Pass(str(Name("irradiance_blur", light)), "irradiance_map", draw, (stage,))
    return filled(settings, light), blurred.renamed(of_light(light))


def used(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The irradiance that a fragment takes from the map: where it looks it up for light from behind, and the sum."""
    look_up, join = texture_image.irradiance_lookup, USED[settings.irradiance_map.image][0]
    if is_wrapped(settings):
        there = {name: INSIDE[name] for name in ("shadow_uv", "shadow_valid")}
        look_up = transmittance.irradiance_lookup_throughout.bound(**there)
        join = transmittance.irradiance_added_wrapped
    return (*lights.each(look_up), *lights.each(by_channel(settings, join)), *lights.summed("irradiance_used"))


def image(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The picture from irradiance and Phong colour, or from irradiance, albedo and highlights."""
    if settings.irradiance_map.image == "sqrt":
        return (texture_image.image_sqrt,)
    return image_of_product(settings, lights)


def image_of_product(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The picture from irradiance, albedo and highlights."""
    of_one = soft_shadow.gloss_soft if is_soft(settings) else texture_image.gloss_where_lit
    gloss = (*shining(settings, *lights.each(of_one)), *lights.summed("gloss"))
    return (*gloss, texture_image.image_product)
