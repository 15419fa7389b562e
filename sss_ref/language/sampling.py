"""Texture sampling, written in the language itself (rule R9). Texel centres lie at ((i + 0.5)/W, (j + 0.5)/H)."""

from typing import TypeVar

from sss_ref.language.builtins import clamp, fract, mix
from sss_ref.language.intrinsics import float32, floor, genType, int32, select, size, texel
from sss_ref.language.stage import function
from sss_ref.language.types import Texture, ivec2, vec2

T = TypeVar("T")


@function
def nearest_texel(map_size: ivec2, uv: vec2) -> ivec2:
    """The texel that holds uv: floor(uv * size), clamped, so u = 1 belongs to the last texel; for NaN any texel.

    Clamped as a number, which may be too large for an int, and as an int, as nobody knows which one NaN becomes.
    """
    last = map_size - ivec2(1, 1)
    column = clamp(floor(uv.x * float32(map_size.x)), 0.0, float32(last.x))
    row = clamp(floor(uv.y * float32(map_size.y)), 0.0, float32(last.y))
    return ivec2(clamp(int32(column), 0, last.x), clamp(int32(row), 0, last.y))


@function
def texel_position(map_size: ivec2, uv: vec2) -> vec2:
    """Where uv lies between texel centres, in texels from the centre of texel (0, 0): uv * size - 0.5."""
    return vec2(uv.x * float32(map_size.x) - 0.5, uv.y * float32(map_size.y) - 0.5)


@function
def whole_part(position: vec2) -> ivec2:
    """The texel to the lower left of a position in texels."""
    return ivec2(int32(floor(position.x)), int32(floor(position.y)))


@function
def fractional_part(position: vec2) -> vec2:
    """How far a position lies from its whole_part: the weights of the right and of the upper neighbour, 0 to 1."""
    return fract(position)


@function
def texel_clamped(texture: Texture[T], at: ivec2) -> T:
    """The stored value at a texel, or at the nearest one on the edge (GL_CLAMP_TO_EDGE)."""
    last = size(texture) - ivec2(1, 1)
    return texel(texture, ivec2(clamp(at.x, 0, last.x), clamp(at.y, 0, last.y)))


@function
def bilinear_blend(
    lower_left: genType, lower_right: genType, upper_left: genType, upper_right: genType, t: vec2
) -> genType:
    """Four neighbours mixed along x first, then along y."""
    return mix(mix(lower_left, lower_right, t.x), mix(upper_left, upper_right, t.x), t.y)


@function
def sample_bilinear(texture: Texture[genType], corner: ivec2, t: vec2) -> genType:
    """GL_LINEAR between the texel `corner` and its right and upper neighbours, clamped to the edge."""
    return bilinear_blend(
        texel_clamped(texture, corner),
        texel_clamped(texture, corner + ivec2(1, 0)),
        texel_clamped(texture, corner + ivec2(0, 1)),
        texel_clamped(texture, corner + ivec2(1, 1)),
        t,
    )


@function
def sample_bilinear_clamped(texture: Texture[genType], uv: vec2) -> genType:
    """GL_LINEAR with GL_CLAMP_TO_EDGE: uv is brought to 0 ... 1 first."""
    at = texel_position(size(texture), vec2(clamp(uv.x, 0.0, 1.0), clamp(uv.y, 0.0, 1.0)))
    return sample_bilinear(texture, whole_part(at), fractional_part(at))


@function
def repeated(index: int, count: int) -> int:
    """An index from -1 to `count`, brought round to the other end where it is outside; what NaN becomes, inside too."""
    around = select(index < 0, index + count, select(index < count, index, index - count))
    return clamp(around, 0, count - 1)


@function
def texel_repeated(texture: Texture[T], at: ivec2) -> T:
    """The stored value at a texel that is at most one beside the texture, which repeats there (GL_REPEAT)."""
    extent = size(texture)
    return texel(texture, ivec2(repeated(at.x, extent.x), repeated(at.y, extent.y)))


@function
def sample_repeated(texture: Texture[genType], at: vec2) -> genType:
    """GL_LINEAR at a position at most one texel beside the texture, which repeats there."""
    corner = whole_part(at)
    return bilinear_blend(
        texel_repeated(texture, corner),
        texel_repeated(texture, corner + ivec2(1, 0)),
        texel_repeated(texture, corner + ivec2(0, 1)),
        texel_repeated(texture, corner + ivec2(1, 1)),
        fractional_part(at),
    )


@function
def sample_bilinear_repeat(texture: Texture[genType], uv: vec2) -> genType:
    """GL_LINEAR with GL_REPEAT: as between the texel centres around u - floor(u), v - floor(v)."""
    return sample_repeated(texture, texel_position(size(texture), fract(uv)))
