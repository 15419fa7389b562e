"""Stages that have everything that the language has, for tests of the texts that are written for them."""

from typing import NamedTuple

from sss_ref.language import (
    Array,
    Texture,
    dot,
    exp2,
    float32,
    ivec2,
    mat3,
    max,
    mix,
    nearest_texel,
    pow,
    select,
    size,
    stage,
    texel,
    texel_clamped,
    vec2,
    vec3,
)


class Shown(NamedTuple):
    """What both examples write."""

    sums: vec2
    power: float
    lit: bool
    base: float


@stage(source="a test")
def by_turns(
    picture: Texture[vec2],
    weights: Array[float],
    count: int,
    exponent: float,
    pixel: ivec2,
    value: float,
    flag: bool,
) -> Shown:
    """A loop that has as many turns for all fragments; a power of a fragment, and one of a uniform."""
    sums = vec2(0.0, value)
    for tap in range(0, count):
        sums = sums + texel_clamped(picture, pixel + ivec2(tap, -1)) * weights[tap]
    power = pow(value, exponent) * exp2(exponent)
    return Shown(sums, power, flag & (power < 0.5), value)


@stage(source="a test")
def by_fragments(
    flags: Texture[bool], turned: mat3, always: bool, number: int, place: ivec2, direction: vec3, base: float
) -> Shown:
    """A loop that has as many turns as a fragment says, with a power inside; a matrix, a choice, whole numbers."""
    total = 0.25
    for turn in range(1, number + 2):
        total = total + pow(base, float32(turn))
    found = turned * -direction
    lit = texel_clamped(flags, place) & always
    return Shown(vec2(max(found.x, 0.0), found.z), select(lit, total, found.y), lit, base)


class Painted(NamedTuple):
    """What the last example writes: a colour and a whole number."""

    tinted: vec3
    steps: int


@stage(
    source="a test, and words enough that the line of its source is longer than the 120 characters that a line may have"
)
def painted(
    fragment_normal: vec3,
    fragment_uv: vec2,
    triangle: int,
    coverage: bool,
    picture: Texture[vec3],
    material: Array[vec3],
    number: Array[int],
    normal_from_model: mat3,
    flat: float,
    inside: bool,
) -> Painted:
    """A texel and an entry of a table, mixed by a matrix: what a draw of a mesh gives, a word that languages keep."""
    at = nearest_texel(size(picture), fragment_uv)
    facing = dot(normal_from_model * fragment_normal, vec3(0.0, 0.0, 1.0))
    color = mix(texel(picture, at), material[number[triangle]], max(facing, flat))
    return Painted(select(coverage & inside, color, vec3(0.0, -1.0, 0.5)), at.x - triangle)
