import os
import subprocess
import sys
from typing import NamedTuple

import numpy as np
import pytest
from scenes import settings_with

from sss_ref.interpret.shader import (
    ESSL,
    HLSL,
    array_lengths,
    draws,
    fragment_shader,
    shader_files,
    stage_source,
    vertex_shader,
)
from sss_ref.interpret.shader.expressions import number
from sss_ref.interpret.shader.glsl import GLSL
from sss_ref.interpret.shader.library import Library
from sss_ref.language import (
    Array,
    Texture,
    clamp,
    float32,
    int32,
    ivec2,
    mix,
    select,
    size,
    stage,
    texel,
    vec2,
    vec3,
)
from sss_ref.language import max as larger
from sss_ref.methods.published.byte_targets import stored_r8, stored_rgb8
from sss_ref.passes.camera import albedo_by_material
from sss_ref.passes.shadow_map import back_point
from sss_ref.passes.vertex import layout_vertex
from sss_ref.scene.catalogue import method_of
from sss_ref.validation.cause.mutants import mutants

LENGTHS = {"tap_offset": 13, "tap_weight": 13}

BACK_POINT = """\
// The two ends of the light's way through the body.
struct BackPoint
{
    vec3 entry_point;
    float thickness;
};

// Scalar product (x*x' + y*y') + z*z' (rule A3).
float dot_(vec3 a, vec3 b)
{
    precise float result = a.x * b.x + a.y * b.y + a.z * b.z;
    return result;
}

// Euclidean length sqrt(dot(v, v)) (rule A3).
float length_(vec3 v)
{
    return sqrt(dot_(v, v));
}

// v / length(v); the zero vector stays zero, unlike GLSL, where it is undefined (rule A3).
vec3 normalize_(vec3 v)
{
    precise float magnitude = length_(v);
    precise vec3 result = magnitude > 0.0 ? v / magnitude : vec3(0.0, 0.0, 0.0);
    return result;
}

// Go from the light towards the fragment by the stored distance; the rest of the way lies inside the body.
// Source: paper 3.2.
BackPoint back_point(vec3 position_world, vec3 light_position, float stored_distance, bool shadow_valid)
{
    precise vec3 direction = normalize_(position_world - light_position);
    precise vec3 entry_point = shadow_valid ? light_position + direction * stored_distance : position_world;
    precise float thickness = length_(position_world - entry_point);
    return BackPoint(entry_point, thickness);
}"""


class Value(NamedTuple):
    value: float


class Both(NamedTuple):
    value: float
    other: vec3


def passes(**overrides):
    return {one.name: one for one in method_of(settings_with(overrides)).passes}


def function_lines(defined):
    """The lines inside the braces of the last function of a stage's source."""
    text = stage_source(defined, LENGTHS)
    return [line.strip() for line in text[text.rindex("\n{") :].splitlines()[2:-1]]


def test_a_stage_reads_as_its_python_does():
    assert stage_source(back_point, {}) == BACK_POINT


@pytest.mark.parametrize("value", [0.5, 1.0, -2.0, 65504.0, 0.05, 1e-8, 3.4028235e38, 1e-45, 16777216.0, 0.1, 1 / 3])
def test_a_literal_gives_back_its_float32(value):
    text = number(float, float(np.float32(value)))
    assert np.float32(text) == np.float32(value)
    assert "." in text or "e" in text  # else GLSL would take it for an integer


def test_literals_of_random_bit_patterns_give_back_their_float32():
    values = np.random.default_rng(400).integers(0, 0x7F800000, 2000, np.uint32).view(np.float32)
    assert all(np.float32(number(float, float(value))) == value for value in values)


@stage(source="a test")
def grouped(a: float, b: float, c: float, i: int, p: bool, q: bool) -> Value:
    difference = a - (b - c) - 1.0
    quotient = a / (b * c) * (a + b)
    sign = -(a * b) - -c
    chosen = select(p & (q | (a < b)), select(q, a, b), select(p, b, c))
    product = select(p, a, b) * 2.0
    counted = float32(i - (2 - i)) + float32(int32(a))
    same = (a == b) & ((i != 3) | p)
    return Value(difference + quotient + sign + (chosen + product) + counted + select(same, a, b))


def test_parentheses_keep_the_order():
    assert function_lines(grouped) == [
        "precise float difference = a - (b - c) - 1.0;",
        "precise float quotient = a / (b * c) * (a + b);",
        "precise float sign_ = -(a * b) - -c;",
        "precise float chosen = p && (q || a < b) ? (q ? a : b) : p ? b : c;",
        "precise float product = (p ? a : b) * 2.0;",
        "precise float counted = float(i - (2 - i)) + float(int(a));",
        "bool same = a == b && (i != 3 || p);",
        "precise float value = difference + quotient + sign_ + (chosen + product) + counted + (same ? a : b);",
        "return Value(value);",
    ]


@stage(source="a test")
def typed(v: vec3, t: float, mask: Texture[bool], picture: Texture[vec2], at: ivec2) -> Both:
    blended = mix(v, vec3(1.0, 2.0, 3.0), t)
    bounded = clamp(blended, vec3(0.0, 0.0, 0.0), v)
    here = select(texel(mask, at), texel(picture, at).x, mix(t, 0.5, t))
    return Both(here, bounded)


def test_functions_are_written_for_the_types_they_are_called_with():
    source = stage_source(typed, {})
    assert "vec3 mix_(vec3 a, vec3 b, float t)" in source and "float mix_(float a, float b, float t)" in source
    assert "return vec3(min_(x.x, y.x), min_(x.y, y.y), min_(x.z, y.z));" in source
    assert source.index("float min_(float x, float y)") < source.index("vec3 min_(vec3 x, vec3 y)")
    assert source.count("vec3 clamp_(") == 1
    assert "return y < x ? y : x;" in source and "return x < y ? y : x;" in source
    assert "texelFetch(mask, at, 0).x != 0u ? texelFetch(picture, at, 0).xy.x : mix_(t, 0.5, t)" in source
    assert "Both typed(vec3 v, float t, usampler2D mask, sampler2D picture, ivec2 at)" in source


@stage(source="a test")
def summed(weights: Array[float], count: int, start: float) -> Value:
    total = start
    for k in range(0, count):
        doubled = weights[k] * 2.0
        total = total + doubled
    return Value(total)


def test_a_loop_accumulates():
    assert function_lines(summed) == [
        "precise float total = start;",
        "for (int k = 0; k < count; k++)",
        "{",
        "precise float doubled = texelFetch(weights, ivec2(k % 4096, k / 4096), 0).x * 2.0;",
        "total = total + doubled;",
        "}",
        "return Value(total);",
    ]


def test_short_arrays_are_arrays_and_long_ones_textures():
    uniforms = {"material_color": np.zeros((64, 3)), "triangle_material": np.zeros(65, np.int32), "x": np.float32(1)}
    assert array_lengths(uniforms) == {"material_color": 64}
    source = stage_source(albedo_by_material, array_lengths(uniforms))
    assert "(int triangle, isampler2D triangle_material, vec3 material_color[64])" in source
    assert "material_color[texelFetch(triangle_material, ivec2(triangle % 4096, triangle / 4096), 0).x]" in source


def test_a_word_of_glsl_is_no_variable():
    assert "precise vec2 flat_ = uv * 2.0 - 1.0;" in function_lines(layout_vertex)


def test_a_pass_is_split_into_draws_of_eight_outputs():
    one = passes()["camera"]
    split = draws(one, one.outputs)
    assert list(split) == ["camera_1", "camera_2", "camera_3"]
    assert [name for outputs in split.values() for name in outputs] == list(one.outputs)
    assert max(map(len, split.values())) == 8
    assert draws(one, {"lit", "coverage"}) == {"camera": ("coverage", "lit")}


def test_a_draw_computes_only_what_its_outputs_need():
    one, buffers = passes()["camera"], {"light_distance", "light_triangle"}
    shader = fragment_shader(one, buffers, ("thickness", "coverage"), LENGTHS)
    assert "precise layout(location = 0) out float out_thickness;" in shader
    assert "layout(location = 1) out uint out_coverage;" in shader and "out_coverage = uint(coverage);" in shader
    assert "back_point(" in shader and "phong" not in shader and "in vec2 fragment_uv;" in shader
    assert "phong" in fragment_shader(one, buffers, ("lit",), LENGTHS)


def test_buffers_at_the_pixel_and_the_stencil_are_fetched():
    composite = fragment_shader(passes()["composite"], {"scattered", "coverage"}, ("image",), LENGTHS)
    assert "vec3 scattered_here = texelFetch(scattered, pixel, 0).xyz;" in composite
    assert "over_background(scattered_here, coverage_here, background).image;" in composite
    assert "uniform vec3 background;" in composite and "discard" not in composite
    blur = fragment_shader(passes()["blur"], {"lit", "coverage"}, ("scattered",), LENGTHS)
    assert "if (!(texelFetch(coverage, pixel, 0).x != 0u)) discard;" in blur
    assert "uniform vec2 tap_offset[13];" in blur


def test_several_lights_share_the_functions_of_their_stages():
    one = passes(lights=[{"position": [0.0, 0.0, 5.0]}] * 2)["camera"]
    shader = fragment_shader(one, {f"light_{k}_{n}" for k in ("distance", "triangle") for n in (1, 2)}, ("lit",), {})
    assert shader.count("BackPoint back_point(") == 1
    assert shader.count("= back_point(") == 2
    assert "ShadowLookup shadow_lookup_nearest_result_2 = shadow_lookup_nearest(" in shader


def test_a_function_that_says_something_else_gets_a_number():
    library = Library(GLSL)
    wrong = next(mutant for mutant in mutants(stored_r8) if mutant.inside == "unorm8")
    for each in (stored_rgb8, stored_r8.with_body(wrong.body)):
        library.stage(each, {})
    lines = library.text.splitlines()
    assert lines.count("float unorm8(float value)") == lines.count("float unorm8_2(float value)") == 1
    assert "    return StoredColor(vec3(unorm8(color.x), unorm8(color.y), unorm8(color.z)));" in lines
    assert "    return StoredValue(unorm8_2(value));" in lines and "unorm8_3" not in library.text


def test_no_line_is_longer_than_120_characters():
    for source in shader_files(method_of(settings_with({"preset": "robust"})), LENGTHS).values():
        assert max(map(len, source.splitlines())) <= 120


def test_vertex_shaders_draw_the_mesh_or_a_rectangle():
    camera, blur = (vertex_shader(passes()[name], {}) for name in ("camera", "blur"))
    assert "in vec3 position;" in camera and "precise gl_Position;" in camera
    assert "gl_Position = vertex.clip_position;" in camera and "fragment_uv = vertex.fragment_uv;" in camera
    assert "gl_VertexID" in blur and "in vec3" not in blur


def test_gles_defines_no_built_in_anew_and_numbers_its_triangles():
    one = passes()["camera"]
    vertex, fragment = vertex_shader(one, {}, ESSL), fragment_shader(one, set(), ("triangle", "normal_world"), {}, ESSL)
    assert vertex.startswith("#version 300 es\nprecision highp float;\n")
    assert "flat out int triangle_number;" in vertex and "triangle_number = gl_VertexID / 3;" in vertex
    assert "flat in int triangle_number;" in fragment and "int triangle = triangle_number;" in fragment
    assert "float length_(vec3 v)" in fragment and "sqrt(dot_(v, v))" in fragment
    assert "precise" not in vertex + fragment
    assert max(map(len, draws(one, one.outputs, ESSL).values())) == 4
    assert "triangle_number" not in vertex_shader(passes()["blur"], {}, ESSL)


@stage(source="a test")
def widened(v: vec3, picture: Texture[vec3], mask: Texture[bool], line: float) -> Both:
    bounded = larger(v, line)
    extent = size(picture)
    at = ivec2(extent.x - 1, 0)
    return Both(select(texel(mask, at), line, 0.5), texel(picture, at) * bounded)


def test_hlsl_writes_its_own_types_and_what_it_lacks():
    source = stage_source(widened, {}, HLSL)
    assert "Both widened(float3 v, Texture2D<float3> picture, Texture2D<uint> mask, float line_)" in source
    assert "float3 bounded = max_(v, (float3)line_);" in source
    assert "int2 texture_size(Texture2D<float3> map)" in source and "int2 extent = texture_size(picture);" in source
    assert "Both returned = {mask.Load(int3(at, 0)) != 0u ? line_ : 0.5, other};" in source


def test_hlsl_turns_the_picture_over_and_halves_the_depth_range():
    one = passes()["camera"]
    vertex, fragment = vertex_shader(one, {}, HLSL), fragment_shader(one, set(), ("triangle", "uv"), {}, HLSL)
    assert "clip_position = vertex.clip_position * float4(1.0, -1.0, 1.0, 1.0);" in vertex
    assert "clip_position.z = (clip_position.z + clip_position.w) * 0.5;" in vertex
    assert "    row_major float4x4 world_from_model : packoffset(c7);" in vertex and "transpose(m)[0] * v.x" in vertex
    assert "float3 position : POSITION," in vertex and "out precise float2 fragment_uv : TEXCOORD2" in vertex
    assert "float3 fragment_normal : TEXCOORD1," in fragment  # as the vertex shader hands it on, though it is not read
    assert "int triangle_ = int(primitive);" in fragment and "out int out_triangle : SV_Target0," in fragment
    assert "int2 pixel = int2(window.xy);" in fragment_shader(passes()["blur"], {"lit"}, ("scattered",), LENGTHS, HLSL)


PRINT_HASH = """
import hashlib
from scenes import settings_with
from sss_ref.interpret.shader import shader_files
from sss_ref.language import max as larger
from sss_ref.scene.catalogue import method_of
files = shader_files(method_of(settings_with({"method": "texture_space", "preset": "robust"})), {"tap_offset": 13})
print(hashlib.sha256(repr(files).encode()).hexdigest())
"""


def test_the_source_does_not_depend_on_the_order_of_sets():
    printed = set()
    for seed in ("1", "2", "3"):
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)}
        command = [sys.executable, "-c", PRINT_HASH]
        printed.add(subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout)
    assert len(printed) == 1 and len(printed.pop()) == 65
