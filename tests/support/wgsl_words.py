"""The edits of the faults, which are texts of our GLSL, as our WGSL has them."""

import re

RULES = (  # a regular expression, and what stands in its place
    (r"^\(tap\) ", "tap "),
    (r"\bivec2\(", "vec2<i32>("),
    (r"\bvec([234])\(", r"vec\1<f32>("),
    (r"\bfloat\(", "f32("),
    (r"texelFetch\(", "textureLoad("),
    (r"textureSize\((\w+), 0\)", r"vec2<i32>(textureDimensions(\1))"),
    (r"max_\(phong", "max_vec3(phong"),
    (r"\b(min|max)_\(", r"\1_float("),
    (r"clamp_\(", "clamp_int("),
    (r"\btexture_\b", "texture"),
    (r"transform\((?=normal)", "transform_mat3("),
    (r"tap_offset\[(.*?)\]", r"textureLoad(tap_offset, vec2<i32>(\1 % 4096, \1 / 4096), 0).xy"),
    (r"tap_weight\[tap\]", "textureLoad(tap_weight, vec2<i32>(tap % 4096, tap / 4096), 0).xyz"),
    (r"tap_weight\[(.+?)\]", r"textureLoad(tap_weight, vec2<i32>(\1, 0), 0).xyz"),
    (r"\bout_(lit|image|irradiance) = (.*);", r"let out_\1 = vec4<f32>(\2, 1.0);"),
    (r"(?<!let )\bout_(\w+) = ", r"let out_\1 = "),
    (r"unpackHalf2x16\(packHalf2x16\(vec2<f32>\((.*)\)\)\)", r"unpack2x16float(pack2x16float(vec2<f32>(\1)))"),
    (r"^lit = ", "Lit("),
    (r"^phong = ", "Phong("),
    (r"^irradiance_used = ", "IrradianceUsed("),
)
SIZE = "vec2<i32>(textureDimensions(light_distance))"
FETCHED = f"let stored: f32 = textureLoad(light_distance, nearest_texel({SIZE}, uv), 0).x;"
FILTERED = """let at = uv * vec2<f32>(textureDimensions(light_distance)) - 0.5;
    let corner = vec2<i32>(floor(at));
    let t = at - floor(at);
    let lower_left = textureLoad(light_distance, corner, 0).x;
    let lower_right = textureLoad(light_distance, corner + vec2<i32>(1, 0), 0).x;
    let upper_left = textureLoad(light_distance, corner + vec2<i32>(0, 1), 0).x;
    let upper_right = textureLoad(light_distance, corner + vec2<i32>(1, 1), 0).x;
    let stored = mix(mix(lower_left, lower_right, t.x), mix(upper_left, upper_right, t.x), t.y);"""
TURNED, CLIP = "let turned = vertex.clip_position * vec4<f32>(", "let turned = (vertex.clip_position + {}) * vec4<f32>("
DEPTH, GIVEN = "(turned.z + turned.w) * 0.5", "@builtin(position) window: vec4<f32>,"
SIDE = {GIVEN: f"{GIVEN} @builtin(front_facing) back: bool,"}  # the picture stands on its head: fronts are backs there
NUMBERED = "let {}triangle: i32 ="
CLAMPED = "textureLoad(texture, vec2<i32>(clamp_int(at.x, 0, last.x), clamp_int(at.y, 0, last.y)), 0).xyz"
BORDERED = (
    "select(vec3<f32>(0.0, 0.0, 0.0), textureLoad(texture, at, 0).xyz, "
    "at.x >= 0 && at.y >= 0 && at.x <= last.x && at.y <= last.y)"
)
WEIGHT = "textureLoad(tap_weight, vec2<i32>(tap % 4096, tap / 4096), 0).xyz"
CHOSEN = "select(vec2<f32>(-1.0, -1.0), {}, inside)"


def culled(condition, which=""):
    """The edits that leave out what faces one way, in the draw that numbers triangles."""
    number = NUMBERED.format(which)
    return {**SIDE, number: f"if ({condition}) {{ discard; }} {number}"}


def moved(by):
    """The edit that moves the clip position."""
    return {TURNED: CLIP.format(by)}


NEARER = {DEPTH: f"turned.w - {DEPTH}"}
OTHERWISE = {  # fault -> its edits, of which the rules above do not make WGSL
    "half a pixel to the side": moved("vec4<f32>(vec2<f32>(vertex.clip_position.w / 96.0), 0.0, 0.0)"),
    "half a texel to the side": moved("vec4<f32>(vec2<f32>(vertex.clip_position.w / 96.0), 0.0, 0.0)"),
    "rows from the top": {TURNED + "1.0, -1.0": TURNED + "1.0, 1.0"},
    "front faces culled": culled("!back"),
    "front faces culled for the light": culled("!back", "light_"),
    "back faces culled": culled("back"),
    "depth test the wrong way round": NEARER,
    "depth test the wrong way round for the light": NEARER,
    "v upside down": {CHOSEN.format("uv"): CHOSEN.format("vec2<f32>(uv.x, 1.0 - uv.y)")},
    "linear for nearest": {FETCHED: FILTERED},
    "taps swapped": {"4096), 0).xy *": "4096), 0).yx *"},  # of texts that are folded, what stands in one line
    "taps mirrored, in mm": {"0).xy * pixel_scale": "0).xy * -pixel_scale"},
    "weights of the channels swapped": {f"pixel_scale) * {WEIGHT}": f"pixel_scale) * {WEIGHT}.zyx"},
    "mask ignored": {"select(0.0, 1.0, texel_clamped_bool(coverage, at))": "1.0"},
    "border for clamp": {CLAMPED: BORDERED},
    "cosine squared": {"facing, directly_lit)": "facing * facing, directly_lit)"},
    "shadow ignored": {"select(select(facing, 0.0, shadow_valid), facing, directly_lit)": "facing"},
    "gutter without the left neighbour": {"select(from_right, left, inside(mask, left))": "from_right"},
    "gutter of the lengths": {"select(from_right, left, inside(mask, left))": "from_right"},
    "light_uv ignored": {"select(uv, entered, shadow_valid)": "uv"},
}
ONLY_OF = {  # files that edits are for where GLSL's texts stand in one alone
    "depth test the wrong way round": "camera.",
    "depth test the wrong way round for the light": "shadow_map.",
    "rows from the top": "camera.",
}


def edits_in_wgsl(name, edits):
    """The edits of a fault: old text -> new text."""
    if name in OTHERWISE:
        return OTHERWISE[name]
    return {spoken(old): spoken(new) for old, new in edits.items() if "#version" not in old}


def spoken(text):
    """A text of our GLSL as our WGSL has it."""
    for pattern, instead in RULES:
        text = re.sub(pattern, instead, text)
    return text
