"""Shaders with one fault each, as texts of our GLSL and what stands there instead."""

from edited import BORDERED, CLAMPED, SIZE, Fault

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

SCREEN_SPACE = DRAW | SURFACE | SHADOW_MAP | LIGHT | BLUR | PUBLISHED

T, PRINTED = "texture space", "texture space as published"
V_FLIPPED = {
    "fragment_uv = vertex.fragment_uv;": "fragment_uv = vec2(vertex.fragment_uv.x, 1.0 - vertex.fragment_uv.y);"
}

TEXTURE_SPACE = {
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
        PRINTED, "camera/image_sqrt_add", {"sqrt(max_(phong * irradiance_used,": "(max_(phong * irradiance_used,"}
    ),
    "root of the sum": Fault(
        PRINTED, "camera/image_sqrt_add", {"phong * irradiance_used,": "phong + irradiance_used,"}
    ),
    "twice the distance": Fault(
        PRINTED,
        "irradiance_map/irradiance_distance",
        {"incident_light * length_(": "incident_light * 2.0 * length_("},
        "irradiance_map",
    ),
}
