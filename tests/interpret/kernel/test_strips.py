"""Everything that the language has, on strips: the bits of the array interpreter at any size, on any part of it."""

from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
import pytest
from one_stage import Inputs, assert_same_bits, run

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips
from sss_ref.interpret.kernel.program import STRIP
from sss_ref.interpret.work import Fragments, Work
from sss_ref.language import (
    Array,
    Texture,
    clamp,
    constant,
    exp,
    exp2,
    float32,
    floor,
    function,
    ivec2,
    log2,
    mat4,
    max,
    min,
    pow,
    select,
    size,
    stage,
    texel,
    texel_clamped,
    vec2,
    vec3,
    vec4,
)
from sss_ref.language.layout import CHANNELS, dtype_of, shape_of
from sss_ref.language.pipeline import Pass, ScreenDraw
from sss_ref.passes import blur

F = np.float32
SIZES = [(1, 1), (1, 7), (7, 5), (STRIP, 1), (STRIP + 1, 2), (33, 31), (97, 61)]
THIRD = constant(1 / 3)


class Everything(NamedTuple):
    turned: vec4
    sums: vec3
    turns: int
    any_odd: bool
    nested: float
    alternating: float
    powers: vec3
    same: float
    handed_on: float
    twice: float
    place: ivec2
    material: float


@function
def harmonic(count: int) -> float:
    """1 + 1/2 + ... + 1/count."""
    total = 0.0 * THIRD
    for n in range(1, count + 1):
        total = total + 1.0 / float32(n)
    return total


@stage(source="test")
def everything(
    picture: Texture[vec3],
    flags: Texture[bool],
    weights: Array[float],
    numbers: Array[int],
    pixel: ivec2,
    value: float,
    number: int,
    flag: bool,
    shift: vec2,
    matrix: mat4,
    count: int,
    exponent: float,
) -> Everything:
    """Loops, one in the other, with powers inside; powers of fragments, of uniforms and of powers; whole numbers."""
    turned = matrix * vec4(value, shift, 1.0)
    sums = vec3(0.0, 0.0, 0.0)
    turns = 0
    odd = flag
    for tap in range(0, count):
        at = pixel + ivec2(numbers[tap], -tap)
        sums = sums + texel_clamped(picture, at) * (weights[tap] * pow(value, exponent))
        turns = turns + select(texel_clamped(flags, at), numbers[tap], tap)
        odd = odd | (turns < 0)
    nested = 0.0 * value
    for n in range(0, count):
        nested = nested + harmonic(n) * value
    alternating = -value
    for k in range(0, count):
        alternating = alternating + exp2(-float32(k)) * harmonic(k)
    powers = vec3(pow(value, exponent), exp(-value), log2(max(value, THIRD)))
    last = size(picture) - ivec2(1, 1)
    place = ivec2(clamp(pixel.x + number, 0, last.x), clamp(pixel.y - number, 0, last.y))
    return Everything(
        turned,
        sums,
        turns,
        odd & (value > THIRD),
        nested,
        alternating,
        powers * pow(powers.y, 2.0),
        pow(exponent, exponent),
        value,
        value,
        place,
        weights[numbers[min(number, 3)]] * floor(value * 8.0) + texel(picture, place).y,
    )


def inputs(width, height, seed=0):
    rng = np.random.default_rng(seed)
    shape = height, width
    return Inputs(
        width,
        height,
        {
            "picture": rng.random((5, 6, 3)).astype(F),
            "flags": rng.integers(0, 2, (4, 9)).astype(np.uint8),
            "value": np.where(rng.random(shape) < 0.1, 0, rng.exponential(size=shape)).astype(F),
            "number": rng.integers(0, 5, shape).astype(np.int32),
            "flag": rng.integers(0, 2, shape).astype(np.uint8),
        },
        {
            "weights": rng.random(4).astype(F),
            "numbers": np.array([1, 0, 3, -2], np.int32) % 4,
            "shift": rng.random(2).astype(F),
            "matrix": rng.normal(size=(4, 4)).astype(F),
            "count": 4,
            "exponent": F(0.6),
        },
    )


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_every_form_has_the_bits_of_array_code(width, height):
    given = inputs(width, height)
    assert_same_bits(run(strips, everything, given), run(arrays, everything, given))


@pytest.mark.parametrize("varying", ["exponent", "shift"])
def test_what_is_a_uniform_may_be_a_buffer(varying):
    given = inputs(19, 3)
    wide = np.broadcast_to(np.asarray(given.uniforms[varying]), (3, 19, *np.shape(given.uniforms[varying])))
    buffers = {**given.buffers, varying: np.ascontiguousarray(wide, F)}
    uniforms = {name: value for name, value in given.uniforms.items() if name != varying}
    moved = Inputs(19, 3, buffers, uniforms)
    assert_same_bits(run(strips, everything, moved), run(arrays, everything, given))


@pytest.mark.parametrize("share", [0.0, 0.03, 0.5, 1.0])
def test_beside_the_stencil_stands_the_background(share):
    given = inputs(97, 61)
    stencil = (np.random.default_rng(1).random((61, 97)) < share).astype(np.uint8)
    one = Pass("one", "", ScreenDraw("stencil"), (everything,))
    found = []
    kinds = one.outputs.items()
    backgrounds = {name: np.arange(1, CHANNELS[kind] + 1).astype(dtype_of(kind)) for name, kind in kinds}
    for interpreter in (strips, arrays):
        outputs = {name: np.full(shape_of(kind, 97, 61), 9, dtype_of(kind)) for name, kind in kinds}
        fragments = Fragments(97, 61, stencil=stencil)
        interpreter.run_fragments(Work(one, fragments, given.uniforms, given.buffers, outputs, backgrounds), None)
        found.append(outputs)
    assert_same_bits(*found)


class Halved(NamedTuple):
    """What is handed on."""

    halved: vec3
    is_bright: bool


class Seen(NamedTuple):
    """What is made of it."""

    seen: vec3


@stage(source="test")
def halve(value: vec3) -> Halved:
    """A number and a truth value."""
    return Halved(value * 0.5, value.x > 1.0)


@stage(source="test")
def see(halved: vec3, is_bright: bool) -> Seen:
    """Both are read, and one read again by the stage that follows."""
    return Seen(select(is_bright, halved, vec3(1.0, 1.0, 1.0) - halved))


@pytest.mark.parametrize("handed_on", [(), ("halved",), ("is_bright",), ("halved", "is_bright")])
def test_stages_read_what_is_handed_on_in_place_of_what_was_given(handed_on):
    """Beside the fragments, where no background is told, the outputs keep what they hold."""
    rng = np.random.default_rng(4)
    value, other = rng.random((2, 9, 700, 3)).astype(F) * F(2)
    bright, where = rng.integers(0, 2, (9, 700)).astype(np.uint8) * np.uint8(7), rng.random((9, 700)) < 0.6
    again = see.renamed(lambda name: {"seen": "seen_again"}.get(name, name))
    one = Pass("one", "", ScreenDraw(), (halve, see, again))
    in_place = {name: {"halved": other, "is_bright": bright}[name] for name in handed_on}
    halved, is_bright = in_place.get("halved", value * F(0.5)), in_place.get("is_bright", value[..., 0] > 1) != 0
    seen = np.where(is_bright[..., None], halved, F(1) - halved)
    expected = {"halved": value * F(0.5), "is_bright": (value[..., 0] > 1).astype(np.uint8)}
    for interpreter in (strips, arrays):
        outputs = {name: np.full(shape_of(kind, 700, 9), 9, dtype_of(kind)) for name, kind in one.outputs.items()}
        fragments = Fragments(700, 9).among(where)
        interpreter.run_fragments(Work(one, fragments, {}, {"value": value}, outputs, {}, in_place), None)
        for name, buffer in outputs.items():
            assert (buffer[~where] == 9).all()
            assert (buffer[where] == expected.get(name, seen)[where]).all(), (interpreter, name)


TEXELS_BESIDE = {  # stencil of a row of 700 pixels
    "whole rows": np.ones(700, bool),
    "a run in the middle": (np.arange(700) > 100) & (np.arange(700) < 600),
    "one hole": np.arange(700) != 350,
    "every other": np.arange(700) % 2 == 0,
    "fewer than end a strip": np.arange(700) < 127,
}


@pytest.mark.parametrize("holes", TEXELS_BESIDE)
@pytest.mark.parametrize("shift", [(0.0, 0.0), (0.25, -1.5), (-40.5, 2.0), (900.0, 0.5), (0.0, 3.0e8)])
@pytest.mark.parametrize("name", ["scatter", "scatter_inside"])
def test_texels_that_lie_side_by_side_are_the_same_texels(name, shift, holes):
    """Whether a strip is one run of a row, and whether its texels are, clamped at the edges or not."""
    rng = np.random.default_rng(2)
    lit, coverage = rng.random((5, 700, 3)).astype(F), rng.integers(0, 2, (5, 700)).astype(np.uint8)
    taps = {"tap_offset": np.array([shift, (0.0, 0.0), (1.5, 1.0)], F), "tap_weight": rng.random((3, 3)).astype(F)}
    uniforms = {**taps, "tap_count": 3, "pixel_scale": F(1)}
    one = Pass("one", "", ScreenDraw("stencil"), (getattr(blur, name),))
    stencil = np.tile(TEXELS_BESIDE[holes], (5, 1)).astype(np.uint8)
    found = []
    for interpreter in (strips, arrays):
        outputs = {"scattered": np.zeros((5, 700, 3), F)}
        buffers = {"lit": lit, "coverage": coverage}
        backgrounds = {"scattered": np.zeros(3, F)}
        work = Work(one, Fragments(700, 5, stencil=stencil), uniforms, buffers, outputs, backgrounds)
        interpreter.run_fragments(work, None)
        found.append(outputs)
    assert_same_bits(*found)


class Doubled(NamedTuple):
    doubled: float


@stage(source="a test")
def double(value: float) -> Doubled:
    return Doubled(value + value)


@pytest.mark.parametrize("interpreter", [strips, arrays])
@pytest.mark.parametrize("row", [None, 0, 31, 32, 69])
def test_every_band_says_whether_it_is_finite(interpreter, row):
    value, one = np.ones((70, 3), F), Pass("one", "", ScreenDraw(), (double,))
    value[row if row is not None else slice(0, 0), 2] = np.finfo(F).max
    outputs, backgrounds = {"doubled": np.empty((70, 3), F)}, {"doubled": np.zeros(1, F)}
    work = Work(one, Fragments(3, 70), {}, {"value": value}, outputs, backgrounds)
    with ThreadPoolExecutor(2) as threads:
        found = [interpreter.run_fragments(work, pool) for pool in (None, threads)]
    assert found == [row is None] * 2


class Sum(NamedTuple):
    """What two stages of one name and signature write."""

    total: float


def test_a_stage_with_the_body_of_another_is_compiled_anew():
    @stage(source="a test")
    def added(a: float, b: float) -> Sum:
        return Sum(a + b)

    @stage(source="a test")
    def wrong(a: float, b: float) -> Sum:
        return Sum(a - b)

    inputs = Inputs(3, 2, {"a": np.full((2, 3), F(5)), "b": np.full((2, 3), F(3))}, {})
    for own, total in ((added, 8), (added.with_body(wrong.body), 2), (added, 8)):
        np.testing.assert_array_equal(run(strips, own, inputs)["total"], np.full((2, 3), F(total)))
