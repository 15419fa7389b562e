"""The shader language: GLSL's types and built-ins as Python, and `@stage`, which checks a contract."""

from sss_ref.language.builtins import clamp, dot, fract, length, mix, normalize, reflect
from sss_ref.language.intrinsics import (
    exp,
    exp2,
    float32,
    floor,
    genType,
    int32,
    log2,
    max,
    min,
    pow,
    select,
    size,
    sqrt,
    texel,
)
from sss_ref.language.sampling import (
    bilinear_blend,
    fractional_part,
    nearest_texel,
    sample_bilinear,
    sample_bilinear_clamped,
    sample_bilinear_repeat,
    texel_clamped,
    texel_position,
    whole_part,
)
from sss_ref.language.stage import Function, Stage, function, stage
from sss_ref.language.types import Array, Texture, constant, ivec2, mat3, mat4, vec2, vec3, vec4
