"""Six Gaussians in texture space (d'Eon and Luebke, GPU Gems 3, chapter 14): an irradiance map, blurred six times.

What each Gaussian spreads is kept, and the camera's pass adds them up with the profile's weights; of those where light
from behind entered as much as comes through the body.
"""

from collections.abc import Iterator

from sss_ref.language import Stage
from sss_ref.language.names import Name
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.per_light import Lights, of_light
from sss_ref.methods.shared import (
    ALBEDO,
    SHADOW_TEST,
    camera_view,
    light_at_the_surface,
    shadow_maps,
    surface_stages,
)
from sss_ref.methods.texture_space import filled, image_of_product, irradiance_stages, laid_out_in_mm
from sss_ref.passes import gaussian_blur, shadow_map, transmittance
from sss_ref.passes.surface_detail import specular_mapped
from sss_ref.scene_file.settings import SceneFile

GAUSSIANS = "abcdef"  # from the narrowest to the widest


def gaussian_texture(settings: SceneFile) -> Method:
    """Shadow map, irradiance map, its charts widened, six blurs of two axes, camera."""
    lights = Lights(settings)
    camera = (*surface(settings, lights), *used(lights), *image_of_product(settings, lights))
    return Method(
        "gaussian_texture",
        passes=(
            *shadow_maps(lights, shadow_map.uv_at_light, gaussian_blur.normal_at_light),
            *laid_out_in_mm(settings, irradiance_stages(settings, lights), "one_mm"),
            *(each for light in lights.numbers for each in spread(settings, light)),
            Pass("camera", "camera", camera_view(settings), camera, registers=("gloss",)),
        ),
        constants={"one_mm": 1.0},
    )


def surface(settings: SceneFile, lights: Lights) -> tuple[Stage, ...]:
    """What the camera sees, and what each light's shadow map knows of it."""
    highlight = (specular_mapped,) if settings.mesh.specular_map else ()
    return (
        *surface_stages(settings),
        ALBEDO[settings.mesh.albedo],
        *highlight,
        *light_at_the_surface(settings, lights, SHADOW_TEST[settings.shadow_map.test]),
    )


def spread(settings: SceneFile, light: int) -> Iterator[Pass]:
    """The passes on one light's irradiance map: dilation, and of each Gaussian the rows and the columns."""
    yield filled(settings, light)
    there, before = ScreenDraw("irradiance_filled_mask"), "irradiance_filled"
    shared = {"irradiance_mask": "irradiance_filled_mask", "texels_per_mm": "texels_per_offset_filled"}
    for letter in GAUSSIANS:
        name = f"spread_{letter}"
        along = gaussian_blur.gaussian_along.bound(spread_mm=f"{name}_mm", **shared)
        for axis, given, gives in (("rows", before, f"{name}_rows"), ("columns", f"{name}_rows", name)):
            stage = along.bound(irradiance=given, spread=gives, spread_offset=f"gaussian_{axis}")
            one = Pass(str(Name(f"blur_{letter}_{axis}", light)), "irradiance_map", there, (stage,))
            yield one.renamed(of_light(light))
        before = name


def used(lights: Lights) -> tuple[Stage, ...]:
    """The irradiance that a fragment takes from all six maps."""
    look_up = lights.each(transmittance.irradiance_lookup_throughout)
    return (*look_up, *lights.each(gaussian_blur.irradiance_of_gaussians), *lights.summed("irradiance_used"))
