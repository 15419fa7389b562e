"""Screen-space subsurface scattering (paper 2.1 and 3.2): shadow map, camera, blur, composite."""

from sss_ref.language import Stage
from sss_ref.language.pipeline import MeshDraw, Method, Pass, ScreenDraw
from sss_ref.passes import blur, composite, phong, shadow_map, translucency
from sss_ref.passes.camera import surface
from sss_ref.passes.vertex import mesh_vertex
from sss_ref.scene.settings import SceneFile

SHADOW_LOOKUP = {"nearest": shadow_map.shadow_lookup_nearest, "bilinear": shadow_map.shadow_lookup_bilinear}
SHADOW_TEST = {"slope": shadow_map.directly_lit_slope, "literal": shadow_map.directly_lit_literal}
FALLOFF = {"none": phong.light_constant, "inverse_square": phong.light_inverse_square}
FORM = {
    "ratio": translucency.translucency_ratio,
    "exponent": translucency.translucency_exponent,
    "beer": translucency.translucency_beer,
}
COMBINE = {
    "multiply": translucency.lit_multiply,
    "add": translucency.lit_add,
    "transmit": translucency.lit_transmit,
}
BLUR = {"none": blur.scatter, "output": blur.scatter, "taps": blur.scatter_inside}

LIGHT_VIEW = MeshDraw(mesh_vertex.bound(clip_from_model="light_clip_from_model"), "light_triangle", "light_depth")
CAMERA_VIEW = MeshDraw(
    mesh_vertex.bound(clip_from_model="camera_clip_from_model"), "triangle", "depth", coverage="coverage"
)


def single_taps(settings: SceneFile) -> tuple[Stage, ...]:
    """The stage `single_tap` once for each row of the kernel, writing tap_00, tap_01 and so on."""
    names = [f"tap_{number:02}" for number in range(len(settings.blur.taps))]
    return tuple(blur.single_tap.bound(tap=name, offset=f"{name}_offset", weight=f"{name}_weight") for name in names)


def screen_space(settings: SceneFile) -> Method:
    """The four passes, each named alternative of the scene file put in as the stage it stands for."""
    masked = settings.blur.mask != "none"
    return Method(
        "screen_space",
        passes=(
            Pass("shadow_map", "shadow_map", LIGHT_VIEW, (shadow_map.distance_to_light,)),
            Pass(
                "camera",
                "camera",
                CAMERA_VIEW,
                (
                    surface,
                    SHADOW_LOOKUP[settings.shadow_map.filter],
                    shadow_map.back_point,
                    SHADOW_TEST[settings.shadow_map.test],
                    FALLOFF[settings.lights[0].falloff],
                    phong.phong_shading,
                    FORM[settings.translucency.form],
                    COMBINE[settings.translucency.combine],
                ),
            ),
            Pass("blur", "camera", ScreenDraw("coverage" if masked else ""), (BLUR[settings.blur.mask],)),
            Pass("taps", "camera", ScreenDraw("coverage" if masked else ""), single_taps(settings), on_demand=True),
            Pass("composite", "camera", ScreenDraw(), (composite.over_background if masked else composite.glow,)),
        ),
    )
