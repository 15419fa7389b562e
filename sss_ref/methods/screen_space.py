"""Screen-space subsurface scattering (paper 2.1 and 3.2): shadow map, camera, blur, composite."""

from sss_ref.language import Stage
from sss_ref.language.names import tap_name
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.per_light import Lights
from sss_ref.methods.shared import NEUTRAL, behind_the_surface, by_channel, camera_view, shadow_maps
from sss_ref.passes import blur, blur_on_surface, composite, lengths, translucency
from sss_ref.scene_file.settings import SceneFile

COMBINE = {  # how T joins the light, and the T that changes nothing
    "multiply": (translucency.lit_multiply, 1.0),
    "add": (translucency.lit_add, 0.0),
    "transmit": (translucency.lit_transmit, 0.0),
}
BLUR = {"none": blur.scatter, "output": blur.scatter, "taps": blur.scatter_inside}
BLUR_ON_SURFACE = BLUR | {"output": blur_on_surface.scatter_on_surface, "taps": blur_on_surface.scatter_inside_surface}

UNIT = {  # of the kernel's offsets: the stages that say what one is at a fragment, and what says it
    "pixel": ((), "pixel_scale"),
    "mm": ((lengths.pixel_length, lengths.offset_length), "pixels_per_offset"),
}


def screen_space(settings: SceneFile) -> Method:
    """The passes, each named alternative of the scene file put in as the stage it stands for."""
    lights = Lights(settings)
    masked = settings.blur.mask != "none"
    stencil = ScreenDraw("coverage" if masked else "")
    combine, neutral = COMBINE[settings.translucency.combine]
    lit = (*lights.each(by_channel(settings, combine)), *lights.summed("lit"))
    lengths_there, scale = UNIT[settings.blur.unit]
    camera = (*behind_the_surface(settings, lights), *lengths_there, *lit)
    blurred = (BLUR_ON_SURFACE if settings.blur.follow_surface else BLUR)[settings.blur.mask]
    return Method(
        "screen_space",
        passes=(
            *shadow_maps(lights),
            Pass("camera", "camera", camera_view(settings), camera),
            Pass("blur", "camera", stencil, (blurred.bound(pixel_scale=scale),)),
            Pass("taps", "camera", stencil, single_taps(settings, scale), on_demand=True),
            Pass("composite", "camera", ScreenDraw(), (composite.over_background if masked else composite.glow,)),
        ),
        constants={NEUTRAL: neutral},
    )


def single_taps(settings: SceneFile, scale: str = "pixel_scale") -> tuple[Stage, ...]:
    """The stage `single_tap` once for each row of the kernel, writing tap_00, tap_01 and so on.

    scale: the uniform or buffer that says how many pixels an offset is.
    """
    names = [tap_name(number) for number in range(len(settings.blur.taps))]
    single = blur.single_tap.bound(pixel_scale=scale)
    return tuple(single.bound(tap=name, offset=f"{name}_offset", weight=f"{name}_weight") for name in names)
