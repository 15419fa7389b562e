"""Shaders with one fault each, drawn on a software OpenGL: the stage with the fault is named, and right ones pass."""

from dataclasses import replace
from pathlib import Path
from runpy import run_path

import pytest
from edited import BORDERED, CLAMPED, SHIPPED, SIZE, Fault, blamed, drawn, judged, rendered
from opengl import needs_mesa

from sss_ref.cli import main
from sss_ref.gl import draw
from sss_ref.rendering.fold import render
from sss_ref.scene import scene_names
from sss_ref.scene.load import load_scene
from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

FETCHED = "float stored = texelFetch(light_distance, nearest_texel(textureSize(light_distance, 0), uv), 0).x;"
FILTERED = """vec2 at = uv * vec2(textureSize(light_distance, 0)) - 0.5;
    ivec2 corner = ivec2(floor(at));
    vec2 t = at - floor(at);
    float lower_left = texelFetch(light_distance, corner, 0).x;
    float lower_right = texelFetch(light_distance, corner + ivec2(1, 0), 0).x;
    float upper_left = texelFetch(light_distance, corner + ivec2(0, 1), 0).x;
    float upper_right = texelFetch(light_distance, corner + ivec2(1, 1), 0).x;
    float stored = mix(mix(lower_left, lower_right, t.x), mix(upper_left, upper_right, t.x), t.y);"""
PLACED = "gl_Position = vertex.clip_position;"
HALF = {"#version 400 core": "#version 420 core"}  # the first with packHalf2x16

DRAW = {  # what the rasterizer shows
    "matrix of the camera": Fault(
        "slabs", "shadow_map/rasterizer", {"light_clip_from_model": "camera_clip_from_model"}, "shadow_map."
    ),
    "matrix of the light": Fault(
        "slabs", "camera/rasterizer", {"camera_clip_from_model": "light_clip_from_model"}, "camera."
    ),
    "half a pixel to the side": Fault(
        "bust", "camera/rasterizer", {PLACED: f"{PLACED} gl_Position.xy += gl_Position.w / {SIZE}.0;"}, "camera."
    ),
    "half a texel to the side": Fault(
        "bust",
        "shadow_map/rasterizer",
        {PLACED: f"{PLACED} gl_Position.xy += gl_Position.w / {SIZE}.0;"},
        "shadow_map.",
    ),
    "rows from the top": Fault(
        "slabs", "camera/rasterizer", {PLACED: f"{PLACED} gl_Position.y = -gl_Position.y;"}, "camera."
    ),
    "front faces culled": Fault(
        "bust", "camera/rasterizer", {"int triangle =": "if (gl_FrontFacing) discard;\n    int triangle ="}
    ),
    "front faces culled for the light": Fault(
        "bust",
        "shadow_map/rasterizer",
        {"int light_triangle =": "if (gl_FrontFacing) discard;\n    int light_triangle ="},
    ),
    "back faces culled": Fault(
        "bust cut open", "camera/rasterizer", {"int triangle =": "if (!gl_FrontFacing) discard;\n    int triangle ="}
    ),
}

DRAW |= {
    "depth test the wrong way round": Fault(
        "slabs", "camera/rasterizer", {"int triangle =": "gl_FragDepth = 1.0 - gl_FragCoord.z;\n    int triangle ="}
    ),
    "depth test the wrong way round for the light": Fault(
        "slabs",
        "shadow_map/rasterizer",
        {"int light_triangle =": "gl_FragDepth = 1.0 - gl_FragCoord.z;\n    int light_triangle ="},
    ),
}

SURFACE = {
    "normal as it is": Fault("slabs", "camera/surface", {"normalize_(fragment_normal)": "fragment_normal"}),
    "normal of the model": Fault("turned", "camera/surface", {"transform(normal_from_model, normal)": "normal"}),
    "position of the model": Fault("turned", "shadow_map/distance_to_light", {"world.xyz": "position"}, "shadow_map."),
}

SHADOW_MAP = {
    "depth for distance": Fault(
        "slabs",
        "shadow_map/distance_to_light",
        {"out_light_distance = light_distance": "out_light_distance = light_depth"},
    ),
    "distance in half floats": Fault(
        "bust",
        "shadow_map/distance_to_light",
        HALF | {"sqrt(dot_(v, v))": "unpackHalf2x16(packHalf2x16(vec2(sqrt(dot_(v, v))))).x"},
        "shadow_map.",
    ),
    "no half texel": Fault("slabs", "camera/shadow_lookup_bilinear", {"map_size.x) - 0.5": "map_size.x)"}),
    "half a texel too many": Fault(
        "bust", "camera/shadow_lookup_nearest", {"uv.x * float(map_size.x)": "uv.x * float(map_size.x) + 0.5"}
    ),
    "v upside down": Fault(
        "slabs", "camera/shadow_lookup_bilinear", {"return inside ? uv": "return inside ? vec2(uv.x, 1.0 - uv.y)"}
    ),
    "linear for nearest": Fault("bust", "camera/shadow_lookup_nearest", {FETCHED: FILTERED}),
    "nearest for linear": Fault("slabs", "camera/shadow_lookup_bilinear", {"fractional_part(at)": "vec2(0.0, 0.0)"}),
    "not divided by w": Fault(
        "bust", "camera/shadow_lookup_nearest", {"vec2(clip.x / clip.w, clip.y / clip.w)": "clip.xy"}
    ),
    "looked up with the camera's matrix": Fault(
        "slabs", "camera/shadow_lookup_bilinear", {"light_clip_from_world": "camera_clip_from_model"}, "camera_"
    ),
    "thickness from a depth": Fault(
        "slabs", "camera/back_point", {"length_(position_world - entry_point)": "(position_world - entry_point).z"}
    ),
    "no normalize": Fault(
        "slabs",
        "camera/back_point",
        {"normalize_(position_world - light_position)": "(position_world - light_position)"},
    ),
    "facing away": Fault("slabs", "camera/directly_lit_slope", {"facing > 0.0": "facing < 0.0"}),
    "bias of the wrong sign": Fault("bust", "camera/directly_lit_slope", {"behind <= bias": "behind <= -bias"}),
}

LIGHT = {
    "light without colour": Fault(
        "slabs", "camera/light_constant", {"light_color * light_intensity": "vec3(light_intensity)"}
    ),
    "reflected the wrong way": Fault("slabs", "camera/phong_shading", {"reflect_(-to_light": "reflect_(to_light"}),
    "shininess one too high": Fault(
        "bust",
        "camera/phong_shading",
        {"pow(max_(mirrored, 0.0), shininess)": "pow(max_(mirrored, 0.0), shininess + 1.0)"},
    ),
    "no ambient light": Fault("bust", "camera/phong_shading", {"phong = (ambient / light_count + ": "phong = ("}),
    "exponent 0.601": Fault("slabs", "camera/translucency_ratio", {"d_min), exponent)": "d_min), exponent + 0.001)"}),
    "multiply for divide": Fault("slabs", "camera/translucency_ratio", {"pow(x, y) / pow(": "pow(x, y) * pow("}),
    "thickness not held above d_min": Fault(
        "bust", "camera/translucency_ratio_throughout", {"max_(thickness, d_min)": "thickness"}
    ),
    "translucency in half floats": Fault(
        "slabs",
        "camera/translucency_ratio",
        HALF | {"min_(term, TRANSLUCENCY_MAX)": "unpackHalf2x16(packHalf2x16(vec2(min_(term, TRANSLUCENCY_MAX)))).x"},
    ),
    "multiply for add": Fault(
        "bust", "camera/lit_transmit_wrapped", {"lit = reflected + albedo": "lit = reflected * albedo"}
    ),
    "bytes between two passes": Fault(
        "bust", "camera/lit_transmit_wrapped", {"out_lit = lit;": "out_lit = floor(lit * 255.0 + 0.5) / 255.0;"}
    ),
}

BLUR = {
    "taps swapped": Fault(
        "slabs", "blur/scatter", {"tap_offset[tap] * pixel_scale": "tap_offset[tap].yx * pixel_scale"}
    ),
    "taps mirrored": Fault(
        "bust", "blur/scatter_inside", {"tap_offset[tap] * pixel_scale": "-tap_offset[tap] * pixel_scale"}
    ),
    "weights of the channels swapped": Fault(
        "bust",
        "blur/scatter_inside",
        {"offset[tap] * pixel_scale) * tap_weight[tap]": "offset[tap] * pixel_scale) * tap_weight[tap].zyx"},
    ),
    "weights in reverse": Fault("bust", "blur/scatter_inside", {"tap_weight[tap]": "tap_weight[tap_count - 1 - tap]"}),
    "taps half a texel off": Fault("bust", "blur/scatter_inside", {"* pixel_scale": "* pixel_scale + 0.5"}),
    "mask ignored": Fault("bust", "blur/scatter_inside", {"texel_clamped_bool(coverage, at) ? 1.0 : 0.0": "1.0"}),
    "kernel in pixels": Fault("bust in mm", "camera/offset_length", {"min_(mm_per_offset / ": "min_(1.0 / "}),
    "taps mirrored, in mm": Fault(
        "bust in mm",
        "blur/scatter_inside_surface",
        {"tap_offset[tap] * pixel_scale": "-tap_offset[tap] * pixel_scale"},
    ),
    "taps from other surfaces": Fault("bust in mm", "blur/scatter_inside_surface", {"<= 1.0": "<= 1e30"}),
    "border for clamp": Fault("wax from near", "blur/scatter", {CLAMPED: BORDERED}, "blur"),
    "sRGB write": Fault(
        "slabs", "composite/over_background", {"out_image = image;": "out_image = pow(image, vec3(0.4545));"}
    ),
}

PUBLISHED = {  # the shadow map is read at the vertices, and targets hold bytes
    "no half texel at the vertices": Fault("wax", "camera/entry_interpolated", {"map_size.x) - 0.5": "map_size.x)"}),
    "other exponent": Fault(
        "wax", "camera/translucency_unclamped", {"thickness, exponent)": "thickness, exponent + 0.001)"}
    ),
    "bytes cut off": Fault("wax", "camera/stored_rgb8", {"* 255.0 + 0.5": "* 255.0"}, "camera_"),
    "multiply for an addition": Fault("wax", "camera/lit_add", {"lit = phong + albedo": "lit = phong * albedo"}),
    "squared distance": Fault("wax", "shadow_map/distance_to_light", {"sqrt(dot_(v, v))": "dot_(v, v)"}, "shadow_map"),
    "a byte of steps of 1/256": Fault(
        "wax", "shadow_map/stored_r8", {"+ 0.5) / 255.0": "+ 0.5) / 256.0"}, "shadow_map"
    ),
}

FAULTS = DRAW | SURFACE | SHADOW_MAP | LIGHT | BLUR | PUBLISHED


@pytest.mark.parametrize("fault", FAULTS)
def test_the_stage_with_the_fault_is_named(fault, tmp_path):
    found = judged(FAULTS[fault], tmp_path)
    assert not found.passed and blamed(found.culprit) == [FAULTS[fault].at]


@pytest.mark.parametrize("scene", ["slabs", *SHIPPED])
def test_the_scenes_that_show_the_faults_pass_without_them(scene):
    found = validate(rendered(scene), drawn(scene), explain=False)
    assert found.passed, found.summary


@pytest.mark.parametrize("name", scene_names())
def test_our_own_shaders_pass(name):
    small = {f"{t}.{s}": 96 for t in ("camera", "shadow_map", "irradiance_map") for s in ("width", "height")}
    loaded = load_scene(name, **small)
    found = validate(render(loaded, interpreter="arrays"), draw(loaded))
    assert found.passed, found.summary
    assert not found.missing


def test_a_stage_of_ones_own_is_drawn_and_judged_like_ours():
    example = Path(__file__).parents[2] / "examples" / "beer_lambert.py"
    scene = run_path(str(example))["scene"]
    changes = {f"{t}.{s}": 64 for t in ("camera", "shadow_map") for s in ("width", "height")}
    loaded = load_scene("figure3_with", **changes, **{"translucency.combine": "transmit", "shadow_map.test": "slope"})
    small = replace(loaded, own_stages=scene.own_stages, own_uniforms=scene.own_uniforms)
    found = validate(render(small, interpreter="arrays"), draw(small))
    assert found.passed and "transmittance" in {one.buffer for one in found.verdicts}


COMMAND = [
    "--size",
    "64x64",
    "--set",
    "shadow_map.width=64",
    "--set",
    "shadow_map.height=64",
    "--interpreter",
    "arrays",
]


@pytest.mark.parametrize("registers", [["--registers"], []])
def test_shaders_that_write_registers_name_the_stage_for_certain(registers, tmp_path, capsys):
    assert main(["glsl", "--scene", "figure4_wax", "-o", str(tmp_path), *registers, *COMMAND[:-2]]) == 0
    for path in tmp_path.glob("*.frag"):
        path.write_text(path.read_text().replace("lit = phong + albedo", "lit = phong * albedo"))
    assert main(["validate", "figure4_wax", str(tmp_path), "--run-glsl", *COMMAND]) == 1
    certain, doubtful = "stage lit_add of pass camera is", "stage stored_rgb8 of pass camera, or one before it whose "
    assert (certain if registers else f"{doubtful}output was not given (camera/lit_add), is") in capsys.readouterr().out


def test_on_the_command_line(tmp_path, capsys):
    small = COMMAND
    assert main(["validate", "sphere", "--run-glsl", *small]) == 0
    assert "every stage gives what it should" in capsys.readouterr().out
    assert main(["glsl", "--scene", "sphere", "-o", str(tmp_path), *small[:-2]]) == 0
    for path in tmp_path.glob("*.frag"):
        path.write_text(path.read_text().replace("pow(x, y) / pow(", "pow(x, y) * pow("))
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 1
    assert "stage translucency_ratio_throughout of pass camera is the first that is wrong" in capsys.readouterr().out
    (tmp_path / "blurr.frag").write_text("")
    assert main(["validate", "sphere", str(tmp_path), "--run-glsl", *small]) == 2
    assert "expected the name of a pass (shadow_map, camera, blur, composite), got blurr" in capsys.readouterr().err
    assert main(["validate", "sphere", str(tmp_path / "none"), "--run-glsl", *small]) == 2
    assert "expected files NAME.frag or NAME.vert" in capsys.readouterr().err


def test_a_vertex_shader_alone_on_the_command_line(tmp_path, capsys):
    """Normals taken for positions: nothing but the stage of the vertices is in doubt."""
    assert main(["glsl", "--scene", "sphere", "-o", str(tmp_path / "all"), *COMMAND[:-2]]) == 0
    text = (tmp_path / "all" / "camera.vert").read_text()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "camera.vert").write_text(text)
    assert main(["validate", "sphere", str(tmp_path / "mine"), "--run-glsl", *COMMAND]) == 0
    wrong = text.replace("transform(normal_from_model, normal)", "transform(normal_from_model, normal.yxz)")
    (tmp_path / "mine" / "camera.vert").write_text(wrong)
    assert main(["validate", "sphere", str(tmp_path / "mine"), "--run-glsl", *COMMAND]) == 1
    assert "camera/mesh_vertex" in capsys.readouterr().out
