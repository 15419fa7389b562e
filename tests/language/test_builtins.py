"""Every built-in: what the rules fix by hand, and the bits of the naive form, in array code and kernel."""

from typing import NamedTuple

import gmpy2
import naive_language as naive
import numpy as np
import pytest
from naive_language import F
from one_stage import Inputs, assert_same_bits, run, run_naively

from sss_ref.interpret import arrays
from sss_ref.interpret.kernel import strips as kernel
from sss_ref.language import (
    clamp,
    cross,
    dot,
    exp,
    exp2,
    float32,
    floor,
    fract,
    int32,
    length,
    log2,
    max,
    min,
    mix,
    normalize,
    pow,
    reflect,
    select,
    sqrt,
    stage,
    vec3,
)

WIDTH, HEIGHT = 64, 32
SPECIAL = np.float32([0, -0.0, 1, -1, np.inf, -np.inf, np.nan, 2**-149, -(2**-149), 3.4028235e38, 0.5, 2.5, -2.5])


class Scalars(NamedTuple):
    least: float
    greatest: float
    clamped: float
    whole: float
    root: float
    chosen: float
    mixed: float
    beyond_whole: float


@stage(source="test")
def scalar_built_ins(u: float, v: float, flag: bool) -> Scalars:
    """Those that must be right for every float32, NaN and infinity included."""
    chosen = select(flag, u, v)
    return Scalars(min(u, v), max(u, v), clamp(u, -1.0, v), floor(u), sqrt(u), chosen, mix(u, v, 0.25), fract(u))


def naive_scalars(u, v, flag):
    clamped = naive.minimum(naive.maximum(u, F(-1)), v)
    root = naive.correctly_rounded(gmpy2.sqrt, u)
    return (
        naive.minimum(u, v),
        naive.maximum(u, v),
        clamped,
        np.floor(u),
        root,
        u if flag else v,
        *naive.mix([u], [v], F(0.25)),
        u - np.floor(u),
    )


class Transcendentals(NamedTuple):
    power: float
    natural: float
    binary: float
    logarithm: float


@stage(source="test")
def transcendentals(base: float, t: float) -> Transcendentals:
    """Those of rule A2."""
    return Transcendentals(pow(base, t), exp(t), exp2(t), log2(base))


def naive_transcendentals(base, t):
    return naive.power(base, t), *(
        naive.correctly_rounded(function, argument)
        for function, argument in ((gmpy2.exp, t), (gmpy2.exp2, t), (gmpy2.log2, base))
    )


class Integers(NamedTuple):
    as_float: float
    as_int: int
    least: int
    bounded: int


@stage(source="test")
def integers(i: int, t: float) -> Integers:
    """Conversions, and the built-ins that take integers too."""
    return Integers(float32(i), int32(t), min(i, 7), clamp(i, -3, 5))


def naive_integers(i, t):
    return F(i), int(t), naive.minimum(i, 7), naive.minimum(naive.maximum(i, -3), 5)


class Vectors(NamedTuple):
    product: float
    across: vec3
    magnitude: float
    unit: vec3
    mirrored: vec3
    mixed: vec3
    least: vec3
    greatest: vec3
    chosen: vec3
    whole: vec3
    root: vec3


@stage(source="test")
def vector_built_ins(a: vec3, b: vec3, t: float, flag: bool) -> Vectors:
    """Those of vectors; a scalar beside a vector serves every component."""
    return Vectors(
        dot(a, b),
        cross(a, b),
        length(a),
        normalize(a),
        reflect(a, b),
        mix(a, b, t),
        min(a, b),
        max(a, t),
        select(flag, a, b),
        floor(a),
        sqrt(max(a, 0.0)),
    )


def naive_vectors(a, b, t, flag):
    return (
        naive.dot(a, b),
        naive.cross(a, b),
        naive.length(a),
        naive.normalize(a),
        naive.reflect(a, b),
        naive.mix(a, b, t),
        [naive.minimum(p, q) for p, q in zip(a, b, strict=True)],
        [naive.maximum(p, t) for p in a],
        a if flag else b,
        [np.floor(p) for p in a],
        [naive.correctly_rounded(gmpy2.sqrt, naive.maximum(p, F(0))) for p in a],
    )


def random_inputs(seed):
    """Any bit patterns in u and v, the special ones in every combination; ordinary sizes elsewhere."""
    rng = np.random.default_rng(seed)
    shape = HEIGHT, WIDTH
    u, v = (rng.integers(0, 2**32, shape, np.uint32).view(np.float32) for _ in range(2))
    pairs = np.array(np.meshgrid(SPECIAL, SPECIAL)).reshape(2, -1)
    u.flat[: pairs.shape[1]], v.flat[: pairs.shape[1]] = pairs
    a, b = (rng.normal(size=(*shape, 3)).astype(np.float32) for _ in range(2))
    a[0], b[0] = rng.choice(np.float32([0, -0.0, 1, 1e-30, -1e-30, 1e-20]), (2, WIDTH, 3))
    t = (rng.normal(size=shape) * 40).astype(np.float32)
    t.flat[:4] = 0, -0.0, 1, 149
    base = np.exp2(rng.uniform(-149, 127, shape)).astype(np.float32)
    base.flat[:4] = 0, 1, 2, 2**-149
    i = rng.integers(-(2**31), 2**31, shape).astype(np.int32)
    i.flat[:12] = range(-5, 7)
    i.flat[12:15] = 2**24 + 1, 2**24 + 3, -(2**24) - 1  # halfway between two floats
    flag = rng.integers(0, 2, shape).astype(np.uint8)
    buffers = {"u": u, "v": v, "a": a, "b": b, "t": t, "base": base, "i": i, "flag": flag}
    return Inputs(WIDTH, HEIGHT, buffers, {})


@pytest.mark.parametrize("interpreter", [arrays, kernel], ids=["arrays", "kernel"])
@pytest.mark.parametrize(
    ("stage_under_test", "plain"),
    [
        (scalar_built_ins, naive_scalars),
        (transcendentals, naive_transcendentals),
        (integers, naive_integers),
        (vector_built_ins, naive_vectors),
    ],
)
def test_built_ins_give_the_bits_of_the_naive_form(stage_under_test, plain, interpreter):
    inputs = random_inputs(seed=7)
    assert_same_bits(run(interpreter, stage_under_test, inputs), run_naively(plain, stage_under_test, inputs))


@pytest.mark.parametrize("function", [min, max])
def test_equal_zeros_give_the_first_and_nan_decides_nothing(function):
    """Rule A1: `y < x ? y : x` is x whenever the comparison says no."""
    negative, positive, nan = F(-0.0), F(0), F(np.nan)
    assert np.signbit(function(negative, positive)) and not np.signbit(function(positive, negative))
    assert function(F(2), nan) == 2
    assert np.isnan(function(nan, F(2)))


def test_mix_at_its_ends_gives_the_ends():
    values = np.random.default_rng(8).normal(size=(2, 1000)).astype(np.float32)
    a, b = values
    assert_same_bits({"": mix(a, b, F(0))}, {"": a})
    assert_same_bits({"": mix(a, b, F(1))}, {"": b})


def test_normalize_of_a_vector_without_length():
    with np.errstate(all="ignore"):
        assert list(normalize(vec3(F(0), F(-0.0), F(0)))) == [0, 0, 0]
        assert list(normalize(vec3(F(1e-30), F(0), F(0)))) == [0, 0, 0]  # its square underflows


def test_vector_built_ins_by_hand():
    a, b = vec3(F(1), F(2), F(2)), vec3(F(0), F(1), F(0))
    assert dot(a, b) == 2
    assert length(a) == 3
    assert list(cross(a, b)) == [-2, 0, 1]  # (2*0 - 2*1, 2*0 - 1*0, 1*1 - 2*0)
    assert list(normalize(a)) == [F(1 / 3), F(2 / 3), F(2 / 3)]
    assert list(reflect(a, b)) == [1, -2, 2]  # the component along b turns round
    assert list(mix(a, b, F(0.5))) == [0.5, 1.5, 1]


def test_dot_adds_from_the_left():
    """(2^24 + 1) + -2^24 loses the 1, which any other order of the three products keeps."""
    ones = vec3(F(1), F(1), F(1))
    assert dot(vec3(F(2**24), F(1), F(-(2**24))), ones) == 0
    assert dot(vec3(F(2**24), F(-(2**24)), F(1)), ones) == 1
