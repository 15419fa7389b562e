"""Screen-space subsurface scattering (paper 2.1 and 3.2): shadow map, camera, blur, composite.

A body inside the mesh has a shadow map and a camera pass of its own, before the mesh through which it is seen.
"""

from sss_ref.language import Stage
from sss_ref.language.names import tap_name
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.inner_body import inner, of_inner
from sss_ref.methods.per_light import Lights
from sss_ref.methods.shared import NEUTRAL, Shading, behind_the_surface, by_channel, camera_view, is_soft, shadow_maps
from sss_ref.passes import (
    blur,
    blur_on_surface,
    composite,
    lengths,
    seen_through,
    soft_shadow,
    translucency,
    transmittance,
)
from sss_ref.scene_file.settings import SceneFile

COMBINE = {  # how T joins the light, and the T that changes nothing
    "multiply": (translucency.lit_multiply, 1.0),
    "add": (translucency.lit_add, 0.0),
    "transmit": (translucency.lit_transmit, 0.0),
    "transmit_wrapped": (transmittance.lit_transmit_wrapped, 0.0),
}
COMBINE_SOFT = {  # the same with a soft shadow; `add` asks only T whether a point is lit
    "multiply": soft_shadow.lit_multiply_soft,
    "add": translucency.lit_add,
    "transmit": soft_shadow.lit_transmit_soft,
    "transmit_wrapped": soft_shadow.lit_transmit_wrapped_soft,
}
BLUR = {"none": blur.scatter, "output": blur.scatter, "taps": blur.scatter_inside}
BLUR_ON_SURFACE = BLUR | {"output": blur_on_surface.scatter_on_surface, "taps": blur_on_surface.scatter_inside_surface}

UNIT = {  # of the kernel's offsets: the stages that say what one is at a fragment, and what says it
    "pixel": ((), "pixel_scale"),
    "mm": ((lengths.pixel_length, lengths.offset_length), "pixels_per_offset"),
}


def screen_space(settings: SceneFile) -> Method:
    """The passes, each named alternative of the scene file put in as the stage it stands for."""
    masked = settings.blur.mask != "none"
    stencil = ScreenDraw("coverage" if masked else "")
    lengths_there, scale = UNIT[settings.blur.unit]
    before, picture = up_to_the_camera(settings, lengths_there)
    blurred = (BLUR_ON_SURFACE if settings.blur.follow_surface else BLUR)[settings.blur.mask]
    return Method(
        "screen_space",
        passes=(
            *before,
            Pass("blur", "camera", stencil, (blurred.bound(pixel_scale=scale, lit=picture),)),
            Pass("taps", "camera", stencil, single_taps(settings, scale, picture), on_demand=True),
            Pass("composite", "camera", ScreenDraw(), (composite.over_background if masked else composite.glow,)),
        ),
        constants=neutral(settings),
    )


def up_to_the_camera(
    settings: SceneFile, lengths_there: tuple[Stage, ...], shading: Shading | None = None
) -> tuple[tuple[Pass, ...], str]:
    """The passes before any light scatters sideways, and the buffer that has the picture then.

    lengths_there: the stages that say what an offset of the kernel is at a fragment. shading: as in
    `behind_the_surface`.
    """
    lights = Lights(settings)
    inside, through, picture = inner_passes(settings, lights)
    camera = (*behind_the_surface(settings, lights, shading), *lengths_there, *lit(settings, lights), *through)
    passes = (*shadow_maps(lights), *inside, Pass("camera", "camera", camera_view(settings), camera))
    return passes, picture


def lit(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """The stages that join reflected light and light from behind."""
    way = settings.translucency.combine
    combine = COMBINE_SOFT[way] if is_soft(settings) else COMBINE[way][0]
    return (*lights.each(by_channel(settings, combine)), *lights.summed("lit"))


def neutral(settings: SceneFile) -> dict[str, float]:
    """The T of each body that changes nothing, by the name of its uniform."""
    own = {NEUTRAL: COMBINE[settings.translucency.combine][1]}
    return own | ({inner(NEUTRAL): neutral(settings.inner)[NEUTRAL]} if settings.inner else {})


def inner_passes(settings: SceneFile, lights: Lights) -> tuple[tuple[Pass, ...], tuple[Stage, ...], str]:
    """The passes of the body inside the mesh, the stage that looks through, and the buffer that has the picture then.

    Without such a body there is none of it, and the picture is `lit`.
    """
    if not settings.inner:
        return (), (), "lit"
    stages = (*behind_the_surface(settings.inner, lights), *lit(settings.inner, lights))
    passes = (*shadow_maps(lights), Pass("camera", "camera", camera_view(settings.inner), stages))
    return tuple(map(of_inner, passes)), (seen_through.seen_through,), "seen"


def single_taps(settings: SceneFile, scale: str = "pixel_scale", picture: str = "lit") -> tuple[Stage, ...]:
    """The stage `single_tap` once for each row of the kernel, writing tap_00, tap_01 and so on.

    scale: the uniform or buffer that says how many pixels an offset is. picture: what is blurred.
    """
    names = [tap_name(number) for number in range(len(settings.blur.taps))]
    single = blur.single_tap.bound(pixel_scale=scale, lit=picture)
    return tuple(single.bound(tap=name, offset=f"{name}_offset", weight=f"{name}_weight") for name in names)
