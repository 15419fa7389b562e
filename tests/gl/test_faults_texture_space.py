"""Faults that only the texture-space method can have, each found at its stage."""

from dataclasses import replace

import pytest
from edited import BORDERED, CLAMPED, KEPT, Fault, blamed, judged, rendered
from opengl import needs_mesa

from sss_ref.gl import draw
from sss_ref.passes.texture_image import gloss_where_lit
from sss_ref.validation.cause.mutants import mutants
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

T, PUBLISHED = "texture space", "texture space as published"
V_FLIPPED = {
    "fragment_uv = vertex.fragment_uv;": "fragment_uv = vec2(vertex.fragment_uv.x, 1.0 - vertex.fragment_uv.y);"
}

FAULTS = {
    "layout upside down": Fault(
        T, "irradiance_map/rasterizer", {"uv * 2.0 - 1.0": "vec2(uv.x, 1.0 - uv.y) * 2.0 - 1.0"}
    ),
    "layout in half of the map": Fault(T, "irradiance_map/rasterizer", {"uv * 2.0 - 1.0": "uv"}),
    "v flipped for the light": Fault(T, "shadow_map/uv_at_light", V_FLIPPED, "shadow_map."),
    "v flipped for the camera": Fault(T, "camera/surface", V_FLIPPED, "camera."),
    "exponent 0.751": Fault(
        T, "camera/translucency_ratio_throughout", {"d_min), exponent)": "d_min), exponent + 0.001)"}
    ),
    "normal as it is": Fault(
        T, "irradiance_map/surface", {"normalize_(fragment_normal)": "fragment_normal * 0.5"}, "irradiance_map"
    ),
    "not divided by w": Fault(
        T,
        "irradiance_map/shadow_lookup_nearest",
        {"vec2(clip.x / clip.w, clip.y / clip.w)": "clip.xy"},
        "irradiance_map",
    ),
    "no normalize": Fault(
        T,
        "irradiance_map/back_point",
        {"normalize_(position_world - light_position)": "(position_world - light_position)"},
        "irradiance_map",
    ),
    "facing away": Fault(T, "irradiance_map/directly_lit_slope", {"facing > 0.0": "facing < 0.0"}, "irradiance_map"),
    "half the light": Fault(
        T, "irradiance_map/light_constant", {"light_color * light_intensity": "light_color * 0.5"}, "irradiance_map"
    ),
    "cosine squared": Fault(
        T, "irradiance_map/irradiance_lambert", {"(directly_lit ? facing": "(directly_lit ? facing * facing"}
    ),
    "shadow ignored": Fault(
        T, "irradiance_map/irradiance_lambert", {"directly_lit ? facing : shadow_valid ? 0.0 : facing": "facing"}
    ),
    "bytes between two passes": Fault(
        T,
        "irradiance_map/irradiance_lambert",
        {"out_irradiance = irradiance;": "out_irradiance = floor(irradiance * 255.0 + 0.5) / 255.0;"},
    ),
    "root of a negative number": Fault(
        T, "irradiance_map/irradiance_lambert", {"out_irradiance = irradiance;": "out_irradiance = sqrt(-irradiance);"}
    ),
    "gutter without the left neighbour": Fault(
        T, "irradiance_fill/dilate", {"from_left = inside(mask, left) ? left : from_right": "from_left = from_right"}
    ),
    "gutter of the lengths": Fault(
        "texture space in mm",
        "offset_fill/dilate",
        {"from_left = inside(mask, left) ? left : from_right": "from_left = from_right"},
        "offset_fill",
    ),
    "stretch forgotten": Fault(
        "texture space in mm", "irradiance_map/texel_length", {"ivec2(triangle % 4096": "ivec2(0 * triangle"}
    ),
    "taps swapped": Fault(
        T, "irradiance_blur/scatter_inside", {"tap_offset[tap] * pixel_scale": "tap_offset[tap].yx * pixel_scale"}
    ),
    "mask ignored": Fault(T, "irradiance_blur/scatter_inside", {"texel_clamped_bool(coverage, at) ? 1.0 : 0.0": "1.0"}),
    "border for clamp": Fault(T, "irradiance_blur/scatter_inside", {CLAMPED: BORDERED}, "irradiance_blur"),
    "light_uv ignored": Fault(T, "camera/irradiance_lookup_throughout", {"shadow_valid ? entered : uv": "uv"}),
    "no half texel": Fault(T, "camera/irradiance_added_wrapped", {"map_size.x) - 0.5": "map_size.x)"}),
    "nearest for linear": Fault(T, "camera/irradiance_added_wrapped", {"fractional_part(at)": "vec2(0.0, 0.0)"}),
    "own irradiance for the entered": Fault(
        T, "camera/irradiance_added_wrapped", {"scattered_irradiance, irradiance_uv)": "scattered_irradiance, uv)"}
    ),
    "multiply for add": Fault(
        T, "camera/irradiance_added_wrapped", {"irradiance_used = own + ": "irradiance_used = own * "}
    ),
    "no ambient light": Fault(T, "camera/image_product", {"(ambient + irradiance_used": "(irradiance_used"}),
    "sRGB write": Fault(T, "camera/image_product", {"out_image = image;": "out_image = pow(image, vec3(0.4545));"}),
    "no root": Fault(
        PUBLISHED, "camera/image_sqrt_add", {"sqrt(max_(phong * irradiance_used,": "(max_(phong * irradiance_used,"}
    ),
    "root of the sum": Fault(
        PUBLISHED, "camera/image_sqrt_add", {"phong * irradiance_used,": "phong + irradiance_used,"}
    ),
    "twice the distance": Fault(
        PUBLISHED,
        "irradiance_map/irradiance_distance",
        {"incident_light * length_(": "incident_light * 2.0 * length_("},
        "irradiance_map",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_with_the_fault_is_named(fault, tmp_path):
    found = judged(FAULTS[fault], tmp_path)
    assert not found.passed and blamed(found.culprit) == [FAULTS[fault].at]


def test_a_mistake_in_a_function_that_two_stages_call_stays_in_one():
    """`highlight` is wrong in gloss_where_lit alone: its shader has both, the other under a number."""
    oracle = rendered(T)
    wrong = next(mutant for mutant in mutants(gloss_where_lit) if mutant.wrong == "mirrored = dot(to_eye, normal)")
    own = {"gloss_where_lit": gloss_where_lit.with_body(wrong.body)}
    found = validate(oracle, draw(replace(oracle.scene, own_stages=own), keep=KEPT), explain=False)
    assert blamed(found.culprit) == ["camera/gloss_where_lit"]
