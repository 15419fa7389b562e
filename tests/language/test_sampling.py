"""Texture sampling: which texel, what mixture, what at the edge (rule R9)."""

from typing import NamedTuple

import naive_language as naive
import numpy as np
import pytest
from naive_language import F
from one_stage import Inputs, assert_same_bits, run, run_naively

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language import (
    Texture,
    bilinear_blend,
    fract,
    fractional_part,
    ivec2,
    nearest_texel,
    sample_bilinear,
    sample_bilinear_clamped,
    sample_bilinear_repeat,
    size,
    stage,
    texel,
    texel_clamped,
    texel_position,
    vec2,
    vec3,
    vec4,
    whole_part,
)

WIDTH, HEIGHT = 32, 16
BELOW_ONE = np.nextafter(F(1), F(0))


class Samples(NamedTuple):
    place: ivec2
    nearest: vec3
    blended: vec3
    number: float
    pair: vec2
    clamped: vec3
    edge: vec4
    index: int
    flag: bool
    extent: ivec2


@stage(source="test")
def samples(
    colors: Texture[vec3],
    numbers: Texture[float],
    pairs: Texture[vec2],
    fours: Texture[vec4],
    indices: Texture[int],
    flags: Texture[bool],
    uv: vec2,
    pixel: ivec2,
) -> Samples:
    """Textures of every type, read in every way."""
    place = nearest_texel(size(colors), uv)
    at = texel_position(size(colors), uv)
    corner = whole_part(at)
    t = fractional_part(at)
    return Samples(
        place,
        texel(colors, place),
        sample_bilinear(colors, corner, t),
        sample_bilinear(numbers, corner, t),
        sample_bilinear(pairs, corner, t),
        sample_bilinear_clamped(colors, uv),
        texel_clamped(fours, pixel - ivec2(10, 6)),
        texel_clamped(indices, corner),
        texel_clamped(flags, corner),
        size(colors),
    )


def naive_samples(colors, numbers, pairs, fours, indices, flags, uv, pixel):
    height, width = colors.shape[:2]
    place = [min(max(int(np.floor(v * F(n))), 0), n - 1) for v, n in zip(uv, (width, height), strict=True)]
    corner, t = naive.between_centres(colors, uv)
    return (
        place,
        colors[place[1], place[0]],
        naive.bilinear(colors, corner, t),
        naive.bilinear(numbers, corner, t)[0],
        naive.bilinear(pairs, corner, t),
        naive.bilinear(colors, *naive.between_centres(colors, [min(max(v, F(0)), F(1)) for v in uv])),
        naive.fetch(fours, pixel[0] - 10, pixel[1] - 6),
        naive.fetch(indices, *corner)[0],
        naive.fetch(flags, *corner)[0],
        [width, height],
    )


@pytest.mark.parametrize("interpreter", [arrays, kernel], ids=["arrays", "kernel"])
@pytest.mark.parametrize(("width", "height"), [(7, 5), (8, 4), (1, 1)])
def test_samples_have_the_bits_of_the_naive_form(width, height, interpreter):
    rng = np.random.default_rng(9)
    uv = rng.uniform(-0.5, 1.5, (HEIGHT, WIDTH, 2)).astype(np.float32)
    uv[0] = rng.choice(F([0, -0.0, 0.5, 1, BELOW_ONE, np.nextafter(F(0.5), F(0))]), (WIDTH, 2))
    buffers = {
        "colors": rng.normal(size=(height, width, 3)).astype(np.float32),
        "numbers": rng.normal(size=(height, width)).astype(np.float32),
        "pairs": rng.normal(size=(height, width, 2)).astype(np.float32),
        "fours": rng.normal(size=(height, width, 4)).astype(np.float32),
        "indices": rng.integers(-1, 100, (height, width)).astype(np.int32),
        "flags": rng.integers(0, 2, (height, width)).astype(np.uint8),
        "uv": uv,
    }
    inputs = Inputs(WIDTH, HEIGHT, buffers, {})
    assert_same_bits(run(interpreter, samples, inputs), run_naively(naive_samples, samples, inputs))


def nearest(u, v, width, height):
    return tuple(nearest_texel(ivec2(np.int32(width), np.int32(height)), vec2(F(u), F(v))))


@pytest.mark.parametrize(
    ("u", "column"),
    [
        (0, 0),
        (-0.0, 0),
        (0.25, 1),  # exactly between texels 0 and 1 of four: the right one
        (np.nextafter(F(0.25), F(0)), 0),
        (np.nextafter(F(0.25), F(1)), 1),
        (BELOW_ONE, 3),
        (1, 3),
        (1.5, 3),
        (-0.25, 0),
    ],
)
def test_nearest_texel(u, column):
    assert nearest(u, 0, 4, 9) == (column, 0)
    assert nearest(0, u, 9, 4) == (0, column)


def test_nearest_texel_rounds_before_the_floor():
    """The float32 nearest to 1/25 is less than that, but 25 times it rounds to 1: texel 1, not 0."""
    assert float(F(0.04)) * 25 < 1
    assert nearest(0.04, 0, 25, 1) == (1, 0)


@pytest.mark.parametrize("u", ["nan", "inf", "-inf", "1e30", "-1e30"])
def test_every_number_leads_inside(u):
    """Also NaN, of which processors make various integers, and what `fract` makes of infinity."""
    texture = Texture(F([[1, 2], [3, 7]]))
    with np.errstate(invalid="ignore", over="ignore"):
        at = nearest_texel(ivec2(np.int32(2), np.int32(3)), vec2(F(u), F(u)))
        sample_bilinear_repeat(texture, vec2(F(u), F(0.5))), sample_bilinear_clamped(texture, vec2(F(u), F(0.5)))
    assert (at.x, at.y) == ((1, 2) if u in ("inf", "1e30") else (0, 0))


def sample(picture, uv):
    texture = Texture(picture)
    at = texel_position(size(texture), vec2(*map(F, uv)))
    return sample_bilinear(texture, whole_part(at), fractional_part(at))


def test_bilinear_at_texel_centres_is_the_texel():
    picture = np.random.default_rng(10).normal(size=(4, 8, 3)).astype(np.float32)
    for row in range(4):
        for column in range(8):
            got = np.array(list(sample(picture, ((column + 0.5) / 8, (row + 0.5) / 4))))
            assert_same_bits({"": got.reshape(1, 1, 3)}, {"": picture[row, column].reshape(1, 1, 3)})


def test_bilinear_by_hand():
    picture = F([[1, 2], [3, 7]])
    assert sample(picture, (0.5, 0.5)) == 3.25
    assert sample(picture, (0.375, 0.25)) == 1.25  # a quarter of the way from 1 to 2
    assert sample(picture, (0.25, 0.375)) == 1.5  # a quarter of the way from 1 to 3


@pytest.mark.parametrize(("u", "v", "corner"), [(-3, -3, 1), (4, -0.5, 2), (0, 1, 3), (0.25, 9, 3), (1, 1, 7)])
def test_bilinear_is_clamped_to_the_edge(u, v, corner):
    assert sample(F([[1, 2], [3, 7]]), (u, v)) == corner


@pytest.mark.parametrize(("width", "height"), [(5, 3), (2, 4), (1, 1)])
def test_a_repeated_texture_is_the_middle_of_nine(width, height):
    """Around the texture lie eight more: blending never leaves them, so clamping at their edge changes nothing."""
    generator = np.random.default_rng(11)
    picture = generator.normal(size=(height, width)).astype(np.float32)
    nine = Texture(np.tile(picture, (3, 3)))
    for u, v in [(0, 0), (1, 1), (BELOW_ONE, 0), (0, BELOW_ONE), *generator.random((40, 2))]:
        at = texel_position(ivec2(np.int32(width), np.int32(height)), vec2(*(fract(F(x)) for x in (u, v))))
        corner = whole_part(at) + ivec2(np.int32(width), np.int32(height))
        expected = sample_bilinear(nine, corner, fractional_part(at))
        assert sample_bilinear_repeat(Texture(picture), vec2(F(u), F(v))) == expected
    assert sample_bilinear_repeat(nine, vec2(F(-7.25), F(9.5))) == sample_bilinear_repeat(nine, vec2(F(0.75), F(0.5)))


def test_beyond_the_edge_a_clamped_sample_is_that_of_the_edge():
    texture = Texture(F([[1, 2], [3, 7]]))
    for u, v, expected in ((-3, -3, 1), (4, 0.5, 4.5), (1e30, -1e30, 2), (0.5, 0.5, 3.25)):
        assert sample_bilinear_clamped(texture, vec2(F(u), F(v))) == expected


def test_x_is_mixed_before_y():
    """In the other order the last bit of this one differs."""
    texels = [F(v) for v in (0.1, 0.2, 0.3, 0.4)]
    t = vec2(F(0.5), F(0.6))
    lower, upper = (naive.mix([texels[k]], [texels[k + 1]], t.x) for k in (0, 2))
    assert bilinear_blend(*texels, t) == naive.mix(lower, upper, t.y)[0]
    left, right = (naive.mix([texels[k]], [texels[k + 2]], t.y) for k in (0, 1))
    assert bilinear_blend(*texels, t) != naive.mix(left, right, t.x)[0]
