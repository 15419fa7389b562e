"""Shaders that say the same in other words, as another author or compiler might: they round otherwise, and pass."""

import re

import pytest
from edited import drawn, drawn_edited, rendered
from opengl import needs_mesa

from sss_ref.validation.stage_by_stage import validate

pytestmark = needs_mesa

RESULT = "precise {} result = {};"
DOT = RESULT.format("float", "a.x * b.x + a.y * b.y + a.z * b.z")
MATRIX_4 = RESULT.format("vec4", "((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3] * v.w")
MATRIX_3 = RESULT.format("vec3", "(m[0] * v.x + m[1] * v.y) + m[2] * v.z")
MIX = "result = a * (1.0 - t) + b * t;"
MIX_3 = RESULT.format("vec3", "a * (1.0 - t) + b * t")
UNIT = "magnitude > 0.0 ? v / magnitude"
SUM = "ambient / light_count + incident_light * lambert + incident_light * mirror"
HIGHLIGHT = "pow(max_(mirrored, 0.0), shininess)"

# Mesa's fma() rounds twice; a product in double is exact, and its sum all but.
FUSED = """#version 400 core
float fused(float a, float b, float c) { return float(double(a) * double(b) + double(c)); }
vec3 fused(vec3 a, vec3 b, vec3 c) { return vec3(dvec3(a) * dvec3(b) + dvec3(c)); }
vec4 fused(vec4 a, vec4 b, vec4 c) { return vec4(dvec4(a) * dvec4(b) + dvec4(c)); }
"""


def fused(fma):
    """Every sum of products by a function that rounds once."""
    return {
        DOT: f"float result = {fma}(a.z, b.z, {fma}(a.y, b.y, a.x * b.x));",
        MATRIX_4: f"vec4 result = {fma}(m[3], vec4(v.w), {fma}(m[2], vec4(v.z), {fma}(m[1], vec4(v.y), m[0] * v.x)));",
        MATRIX_3: f"vec3 result = {fma}(m[2], vec3(v.z), {fma}(m[1], vec3(v.y), m[0] * v.x));",
        MIX_3: f"vec3 result = {fma}(b, vec3(t), a * (1.0 - t));",
        SUM: f"{fma}(incident_light, vec3(mirror), {fma}(incident_light, vec3(lambert), vec3(ambient / light_count)))",
    }


def builtin(*heads):
    """GLSL's own functions where the shader has its own, dot_ for dot: ours are out of the way under another name.

    heads: how their definitions begin.
    """
    names = dict.fromkeys(re.search(r"(\w+)_\(", head)[1] for head in heads)
    defined = "".join(f"#define {name}_ {name}\n" for name in names)
    moved = {head: head.replace(" ", " our_", 1) for head in heads}
    return {"#version 400 core\n": f"#version 400 core\n{defined}", **moved}


REWRITES = {  # these draw other bits than ours
    "dot backwards": {DOT: RESULT.format("float", "a.z * b.z + a.y * b.y + a.x * b.x")},
    "dot in another order": {DOT: RESULT.format("float", "a.x * b.x + (a.y * b.y + a.z * b.z)")},
    "fused in double": {"#version 400 core\n": FUSED, **fused("fused")},
    "unit vector by inversesqrt": {UNIT: "magnitude > 0.0 ? v * inversesqrt(dot_(v, v))"},
    "unit vector by a reciprocal": {UNIT: "magnitude > 0.0 ? v * (1.0 / magnitude)"},
    "divided by w once": {"vec2(clip.x / clip.w, clip.y / clip.w)": "clip.xy * (1.0 / clip.w)"},
    "mix by the difference": {MIX: "result = a + (b - a) * t;"},
    "light factored out": {SUM: "ambient / light_count + incident_light * (lambert + mirror)"},
    "power by squaring": {
        "#version 400 core\n": "#version 400 core\nfloat squared(float x) { return x * x; }\n",
        HIGHLIGHT: "squared(squared(squared(squared(squared(max_(mirrored, 0.0))))))",  # the scenes' shininess is 32
    },
    "distance()": {"length_(fragment_position - light_position)": "distance(fragment_position, light_position)"},
    "GLSL's dot": builtin("float dot_(vec3 a"),
    "GLSL's length": builtin("float length_(vec3 v"),
    "GLSL's normalize": builtin("vec3 normalize_(vec3 v"),
    "GLSL's reflect": builtin("vec3 reflect_(vec3 i"),
}
SAME_BITS = {  # these draw the same on Mesa, and need not elsewhere
    "GLSL's fma": fused("fma"),
    "GLSL's mix": builtin("vec3 mix_(vec3 a, vec3 b, float t)"),
    "GLSL's min, max and clamp": builtin(
        *(f"{kind} {name}_({kind} x" for kind in ("float", "int") for name in ("min", "max", "clamp"))
    ),
    "GLSL's matrix product": {"transform(light_clip_from_world, ": "(light_clip_from_world * "},
    "power by exp2": {
        "pow(x, y) / pow(max_(thickness, d_min), exponent)": (
            "exp2(y * log2(x)) / exp2(exponent * log2(max_(thickness, d_min)))"
        ),
        HIGHLIGHT: "exp2(shininess * log2(max_(mirrored, 0.0)))",
    },
    "not precise": {"precise gl_Position;\n": "", "precise ": ""},
}
SCENES = ["filtered bust", "texture space"]
WORLD_FIRST = {
    "light_clip_from_model": "light_clip_from_world",
    "transform(clip_from_model, model)": "transform(clip_from_model, world)",
}


def judged(scene, edits, folder, files=""):
    """What is said of the drawing, and whether it has other bits than ours."""
    drawing = drawn_edited(scene, edits, folder, files)
    differs = any(drawing[name].tobytes() != buffer.tobytes() for name, buffer in drawn(scene).items())
    return validate(rendered(scene), drawing, profile="vulkan", explain=False), differs


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("rewrite", REWRITES)
def test_a_right_shader_passes_whatever_its_rounding(rewrite, scene, tmp_path):
    found, differs = judged(scene, REWRITES[rewrite], tmp_path)
    assert found.passed, found.summary
    assert differs


@pytest.mark.parametrize("scene", ["slabs", "turned"])
def test_going_through_world_space_first_passes(scene, tmp_path):
    found, differs = judged(scene, WORLD_FIRST, tmp_path, "shadow_map.")
    assert found.passed, found.summary
    assert differs


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("rewrite", SAME_BITS)
def test_a_right_shader_passes(rewrite, scene, tmp_path):
    found, _ = judged(scene, SAME_BITS[rewrite], tmp_path)
    assert found.passed, found.summary


@pytest.mark.parametrize("scene", SCENES)
def test_several_rewrites_at_once_pass(scene, tmp_path):
    names = "fused in double", "unit vector by inversesqrt", "divided by w once"
    together = {old: new for name in names for old, new in REWRITES[name].items()}
    found, _ = judged(scene, together, tmp_path)
    assert found.passed, found.summary
