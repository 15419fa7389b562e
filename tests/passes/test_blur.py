"""The blur: worked by hand, and what must hold of it whatever the picture."""

from dataclasses import replace

import numpy as np
import pytest
from fragments import KERNEL, taps
from one_stage import Inputs, assert_same_bits, call, run

from sss_ref.interpret import arrays
from sss_ref.passes.blur import scatter, scatter_inside, single_tap

LONE_TAP = (1.3, -0.6, 0.3, 0.2, 0.1)
REACH = 7  # pixels, at least as far as any tap of KERNEL


def row_of(*values):
    """A picture one pixel high, the same in all channels."""
    return np.repeat(np.float32([values])[..., None], 3, axis=2)


def blur(picture, kernel, coverage=None, pixel_scale=1.0):
    """The blurred picture; where a coverage is given, the blur that stays inside it."""
    height, width = picture.shape[:2]
    inside = {} if coverage is None else {"coverage": coverage}
    inputs = Inputs(width, height, {"lit": picture, **inside}, {**taps(kernel), "pixel_scale": np.float32(pixel_scale)})
    return run(arrays, scatter if coverage is None else scatter_inside, inputs)["scattered"]


def random_picture(seed, width=24, height=16):
    return np.random.default_rng(seed).random((height, width, 3)).astype(np.float32)


def test_scatter():
    # At the middle of 1, 2, 4: half of its own 2, and a quarter (green an eighth, blue none) of (2 + 4)/2 = 3.
    kernel = taps([(0, 0, 0.5, 0.5, 0.5), (0.5, 0, 0.25, 0.125, 0)])
    expected = ((1.75, 1.375, 1),)
    assert call(scatter, lit=row_of(1, 2, 4), pixel=(1, 0), **kernel, pixel_scale=1) == expected
    half = {**kernel, "tap_offset": kernel["tap_offset"] / 2}
    assert call(scatter, lit=row_of(1, 2, 4), pixel=(1, 0), **half, pixel_scale=2) == expected


def test_scatter_up_and_left():
    # A quarter of a pixel to the left of the right column and half a pixel up:
    # below 1*.25 + 2*.75 = 1.75, above 3*.25 + 7*.75 = 6, between them 3.875.
    picture = np.concatenate([row_of(1, 2), row_of(3, 7)])
    kernel = taps([(-0.25, 0.5, 1, 1, 1)])
    assert call(scatter, lit=picture, pixel=(1, 0), **kernel, pixel_scale=1) == ((3.875,) * 3,)


def test_a_sum_of_one_term_has_its_bits():
    """Of black times a weight below 0 that is -0, and -0 as the first term of a sum."""
    ((red, green, _),) = call(scatter, lit=row_of(0), pixel=(0, 0), **taps([(0, 0, -1, 1, 1)]), pixel_scale=1)
    assert (red, green) == (0, 0) and np.signbit(red) and not np.signbit(green)


def test_single_tap():
    # Half way between 2 and 4, times the weights.
    inputs = {"lit": row_of(1, 2, 4), "pixel": (1, 0), "weight": (0.25, 0.125, 0)}
    assert call(single_tap, **inputs, offset=(0.5, 0), pixel_scale=1) == ((0.75, 0.375, 0),)
    assert call(single_tap, **inputs, offset=(0.25, 0), pixel_scale=2) == ((0.75, 0.375, 0),)


def test_single_taps_in_order_sum_to_the_blur():
    picture = random_picture(13)
    inputs = Inputs(24, 16, {"lit": picture}, {"pixel_scale": np.float32(1)})
    rows = [{"offset": np.float32(row[:2]), "weight": np.float32(row[2:])} for row in KERNEL]
    shares = [run(arrays, single_tap, replace(inputs, uniforms={**inputs.uniforms, **row}))["tap"] for row in rows]
    total = shares[0]
    for share in shares[1:]:
        total = total + share
    assert_same_bits({"": blur(picture, KERNEL)}, {"": total})


def test_scatter_inside():
    # The second tap lies half on the model's 2, half beside it: red .5*2 + .5*1 = 1.5, of which .5 + .5*.5 = .75 of
    # the weight 1 is kept: 1.5/.75 = 2. Green (.5*2 + 1*1) * 1.5/(.5 + 1*.5) = 3. Blue has no second tap: 2.
    lit, coverage = row_of(0, 2, 4), np.uint8([[0, 1, 1]])
    kernel = taps([(0, 0, 0.5, 0.5, 1), (-0.5, 0, 0.5, 1, 0)])
    assert call(scatter_inside, lit=lit, coverage=coverage, pixel=(1, 0), **kernel, pixel_scale=1) == ((2, 3, 2),)


def test_scatter_inside_with_no_tap_on_the_model():
    # The one tap lands beside the model: the pixel keeps its value.
    lit, coverage, kernel = row_of(0, 2, 0), np.uint8([[0, 1, 0]]), taps([(1, 0, 0.5, 0.5, 0.5)])
    assert call(scatter_inside, lit=lit, coverage=coverage, pixel=(1, 0), **kernel, pixel_scale=1) == ((2, 2, 2),)


def test_scatter_inside_of_an_island():
    """A covered pixel with nothing covered around it keeps its value, whether or not a tap lies on it."""
    lit, coverage = np.zeros((32, 32, 3), np.float32), np.zeros((32, 32), np.uint8)
    lit[16, 16], coverage[16, 16] = (0.25, 0.5, 2), 1
    # The weights sum to 1, and those of the tap on the island are powers of two, so that nothing rounds.
    kernel = [(0, 0, 0.5, 0.25, 0.125), (5, 0, 0.25, 0.5, 0.375), (-3, -6.5, 0.25, 0.25, 0.5)]
    for rows in (kernel, kernel[1:]):
        assert tuple(blur(lit, rows, coverage)[16, 16]) == (0.25, 0.5, 2)


def test_scatter_inside_counts_no_light_beside_the_model():
    """Rule 4.3 multiplies lit with coverage: a dump that was cleared to another colour changes nothing."""
    coverage = (np.random.default_rng(11).random((16, 24)) < 0.6).astype(np.uint8)
    lit = random_picture(12)
    black = np.where(coverage[..., None] != 0, lit, np.float32(0))
    covered = coverage != 0
    assert np.array_equal(blur(lit, KERNEL, coverage)[covered], blur(black, KERNEL, coverage)[covered])


@pytest.mark.parametrize("covered", [False, True])
def test_integer_offset_picks_the_texel(covered):
    picture = random_picture(4)
    coverage = np.ones(picture.shape[:2], np.uint8) if covered else None
    moved = np.pad(picture, ((1, 0), (0, 2), (0, 0)), mode="edge")[:-1, 2:]  # clamped to the edge
    assert_same_bits({"": blur(picture, [(2, -1, 1, 1, 1)], coverage)}, {"": moved})
    assert_same_bits({"": blur(picture, [(1, -0.5, 1, 1, 1)], coverage, pixel_scale=2)}, {"": moved})


@pytest.mark.parametrize("seed", range(5))
def test_constant_picture_is_weighted_with_the_sum(seed):
    rng = np.random.default_rng(seed)
    kernel = [(*rng.uniform(-6, 6, 2), *rng.random(3) / 13) for _ in range(13)]
    got = blur(np.ones((16, 24, 3), np.float32), kernel).astype(np.float64)
    exact = np.float32(kernel)[:, 2:].astype(np.float64).sum(axis=0)
    # Each tap rounds its product and its sum, and half an ulp of the bilinear 1: together at most 13 ulp.
    assert (np.abs(got - exact) <= 13 * np.spacing(exact.astype(np.float32))).all()


@pytest.mark.parametrize("kernel", [[LONE_TAP], KERNEL], ids=["N=1", "N=5"])
@pytest.mark.parametrize("inside", [False, True])
def test_moved_picture_blurs_to_the_moved_bits(kernel, inside):
    columns, rows, width, height = 3, 2, 40, 32
    picture = random_picture(5, width, height)
    coverage = (np.random.default_rng(6).random((height, width)) < 0.7).astype(np.uint8) if inside else None
    if inside:
        picture *= coverage[..., None]

    def moved(buffer):
        return None if buffer is None else np.roll(buffer, (rows, columns), (0, 1))

    got, expected = blur(moved(picture), kernel, moved(coverage)), moved(blur(picture, kernel, coverage))
    away = slice(REACH + rows, height - REACH), slice(REACH + columns, width - REACH)  # from what the edge decides
    assert_same_bits({"": got[away].copy()}, {"": expected[away].copy()})
