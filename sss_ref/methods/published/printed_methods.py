"""Both methods as the paper's printed figures have them: maps of eight bits, a vertex-stage lookup, T added."""

from dataclasses import replace

from sss_ref.language import Stage
from sss_ref.language.names import EXACT, Name
from sss_ref.language.pipeline import Method, Pass, ScreenDraw
from sss_ref.methods.published import byte_targets as encoding
from sss_ref.methods.published import printed_stages as published
from sss_ref.methods.screen_space import single_taps
from sss_ref.methods.shared import ALBEDO, CAMERA_VIEW, LIGHT_VIEW, NEUTRAL, by_channel
from sss_ref.methods.texture_space import LAYOUT, in_texels
from sss_ref.passes import blur, composite, irradiance, phong, shadow_map, translucency
from sss_ref.passes.camera import surface
from sss_ref.scene_file.settings import SceneFile

CLIP = {"clip_from_model": "camera_clip_from_model"}

LOOKUP_VIEW = replace(CAMERA_VIEW, vertex=published.lookup_vertex.bound(**CLIP))
UNTRANSFORMED_VIEW = replace(CAMERA_VIEW, vertex=published.untransformed_vertex.bound(**CLIP))


def screen_space(settings: SceneFile) -> Method:
    """Shadow map, camera, blur over the whole window, composite."""
    camera = (
        *surface_colors(settings),
        published.entry_interpolated,
        *phong_and_translucency(settings),
        *in_bytes(by_channel(settings, translucency.lit_add), "lit"),
    )
    window = ScreenDraw()
    return Method(
        "screen_space",
        passes=(
            shadow_map_of(shadow_map.distance_to_light),
            Pass("camera", "camera", LOOKUP_VIEW, camera),
            Pass("blur", "camera", window, (blur.scatter,)),
            Pass("taps", "camera", window, single_taps(settings), on_demand=True),
            Pass("composite", "camera", window, in_bytes(composite.glow, "image")),
        ),
        constants={NEUTRAL: 0.0},
    )


def texture_space(settings: SceneFile) -> Method:
    """Shadow map, irradiance map, and a camera pass that blurs the latter as it reads it."""
    stored = (surface, phong.light_constant, *in_bytes(irradiance.irradiance_distance, "irradiance"))
    camera = (
        *surface_colors(settings),
        published.entry_from_irradiance,
        *phong_and_translucency(settings),
        published.irradiance_gathered,
        *in_bytes(by_channel(settings, published.image_sqrt_add), "image"),
    )
    return Method(
        "texture_space",
        passes=(
            shadow_map_of(shadow_map.distance_to_light, shadow_map.uv_at_light),
            Pass("irradiance_map", "irradiance_map", LAYOUT, in_texels(*stored)),
            Pass("camera", "camera", UNTRANSFORMED_VIEW, camera),
        ),
        constants={NEUTRAL: 0.0},
    )


def shadow_map_of(*stages: Stage) -> Pass:
    """The shadow map, its distance kept in a byte."""
    distance, *more = stages
    kept = (*in_bytes(distance, "light_distance"), *more)
    return Pass("shadow_map", "shadow_map", LIGHT_VIEW, kept)


def in_bytes(stage: Stage, buffer: str) -> tuple[Stage, Stage]:
    """A stage, and the target of eight bits a channel that keeps the buffer it writes."""
    exact = str(Name.of(buffer).as_share(EXACT))
    if stage.outputs[buffer] is float:
        target = encoding.stored_r8.bound(value=exact, stored_value=buffer)
    else:
        target = encoding.stored_rgb8.bound(color=exact, stored_color=buffer)
    return stage.bound(**{buffer: exact}), target


def surface_colors(settings: SceneFile) -> tuple[Stage, ...]:
    """The surface, its albedo, and the light that falls on it."""
    return surface, ALBEDO[settings.mesh.albedo], phong.light_constant


def phong_and_translucency(settings: SceneFile) -> tuple[Stage, ...]:
    """From the thickness on: whether the fragment is lit, its Phong colour, and T."""
    return published.directly_lit_exact, published.phong_ungated, by_channel(settings, published.translucency_unclamped)
