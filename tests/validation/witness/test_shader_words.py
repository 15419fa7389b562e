"""What a stage reads as words in a shader, and the shaders made of them, on a witness put together by hand."""

from typing import NamedTuple

import numpy as np
import pytest
from example_stages import painted
from painted_witness import READ, F, painted_witness, situation

from sss_ref.interpret.intervals.profile import PROFILES
from sss_ref.interpret.shader import GLSL
from sss_ref.language import Texture, float32, size, stage, vec2
from sss_ref.numerics.interval import Interval
from sss_ref.validation.witness.shader_words import ShaderWords, TexelTable
from sss_ref.validation.witness.situation import Situation
from sss_ref.validation.witness.stand_alone import stand_alone
from sss_ref.validation.witness.stand_alone_wgsl import stand_alone_wgsl
from sss_ref.validation.witness.witness import DrawnValue, Witness

ONE, TWO, FOUR = "3f800000", "40000000", "40800000"
THREE, FIVE, SIX, SEVEN, EIGHT = "40400000", "40a00000", "40c00000", "40e00000", "41000000"
WORDS = [
    *("00000000", "3e800000", ONE),  # fragment_normal
    *("3f000000", "3f400000", "00000001", "00000001"),  # fragment_uv, triangle, coverage
    *("00000000", ONE, TWO, THREE, FOUR, FIVE),  # picture: texels (0, 0) and (1, 0), that is 0 to 5
    *("41700000", "41800000", "41880000"),  # texel (2, 1): 15 to 17
    *(EIGHT, "41800000", "42000000"),  # material[1]: 8, 16, 32
    *("00000000", "00000000"),  # number[0], number[2]
    *("00000000", ONE, TWO, THREE, FOUR, FIVE, SIX, SEVEN, EIGHT),  # normal_from_model, row by row
    *(TWO, "00000001"),  # flat, inside
]


@pytest.fixture(scope="module")
def words():
    return ShaderWords.of(situation(), READ)


def test_each_value_has_its_words_in_the_order_of_the_parameters(words):
    assert list(words.words) == WORDS
    first = {"fragment_normal": 0, "fragment_uv": 3, "triangle": 5, "coverage": 6}
    assert words.first == first | {"normal_from_model": 21, "flat": 30, "inside": 31}


def test_each_texture_and_array_has_a_table_of_the_runs_that_are_read(words):
    assert words.tables == {
        "picture": TexelTable(0, (3, 2), 3, ((0, 0, 2, 7), (2, 1, 1, 13))),
        "material": TexelTable(1, (2, 1), 3, ((1, 0, 1, 16),)),
        "number": TexelTable(2, (3, 1), 1, ((0, 0, 1, 19), (2, 0, 1, 20))),
    }
    assert words.runs == [(0, 0, 0, 2, 7), (0, 2, 1, 1, 13), (1, 1, 0, 1, 16), (2, 0, 0, 1, 19), (2, 2, 0, 1, 20)]


def test_the_tables_as_glsl(words):
    lines = words.lines
    assert lines[0] == "uniform uint witness_nothing;"
    assert lines[1] == f"const uint WITNESS_WORDS[32] = uint[32]({', '.join(f'0x{word}u' for word in WORDS)});"
    tables = [line for line in lines[2:] if line.startswith("const ")]
    assert tables == [
        "const ivec2 WITNESS_SIZES[3] = ivec2[3](ivec2(3, 2), ivec2(2, 1), ivec2(3, 1));",
        "const int WITNESS_CHANNELS[3] = int[3](3, 3, 1);",
        "const ivec4 WITNESS_RUNS[5] = ivec4[5](ivec4(0, 0, 0, 2), ivec4(0, 2, 1, 1), ivec4(1, 1, 0, 1), "
        "ivec4(2, 0, 0, 1), ivec4(2, 2, 0, 1));",
        "const int WITNESS_FIRST[5] = int[5](7, 13, 16, 19, 20);",
        "const int WITNESS_RUN_COUNT = 5;",
    ]
    assert "    return -8;" in lines


MATRIX = (21, 24, 27, 22, 25, 28, 23, 26, 29)  # column by column, as shaders take them


@pytest.mark.parametrize(
    ("own", "text"),
    [
        ("fragment_normal", "vec3(witness_float(0), witness_float(1), witness_float(2))"),
        ("fragment_uv", "vec2(witness_float(3), witness_float(4))"),
        ("triangle", "int(witness_word(5))"),
        ("coverage", "witness_word(6) != 0u"),
        ("normal_from_model", f"mat3({', '.join(f'witness_float({k})' for k in MATRIX)})"),
        ("flat", "witness_float(30)"),
    ],
)
def test_what_the_stage_is_handed(words, own, text):
    assert words.argument(own, painted.parameters[own], GLSL) == text


DRAWN = DrawnValue("camera", "shade", (0, 0))


class Shade(NamedTuple):
    """A number."""

    shade: float


class Flagged(NamedTuple):
    """A pair and a truth value."""

    pair: vec2
    flag: bool


@stage(source="a test")
def indifferent(picture: Texture[float], flags: Texture[bool]) -> Shade:
    """Reads no texel of either: how large they are is enough."""
    return Shade(float32(size(picture).x - size(flags).y))


@stage(source="a test")
def halved(value: float) -> Shade:
    """Reads no texture."""
    return Shade(value * 0.5)


def test_where_no_texel_is_read_there_is_a_run_of_none_in_no_table():
    given = {"picture": Texture(np.zeros((2, 3), F)), "flags": Texture(np.zeros((1, 2), np.uint8))}
    words = ShaderWords.of(Situation(indifferent, given, given), {"picture": (), "flags": ()})
    assert words.words == () and words.runs == [(-8, 0, 0, 0, 0)]
    assert "const uint WITNESS_WORDS[1] = uint[1](0x0u);" in words.lines
    assert "const ivec4 WITNESS_RUNS[1] = ivec4[1](ivec4(-8, 0, 0, 0));" in words.lines
    witness = Witness(Situation(indifferent, given, given), "shade", F([2]), DRAWN, PROFILES["ieee"])
    shader = " ".join(stand_alone_wgsl(witness).split())
    assert "WITNESS_WORDS: array<u32, 1> = array<u32, 1>(0x0u);" in shader
    assert "WITNESS_RUNS: array<vec4<i32>, 1> = array<vec4<i32>, 1>(vec4<i32>(-8, 0, 0, 0));" in shader


def test_without_textures_there_are_no_tables():
    given = {"value": F(3)}
    witness = Witness(Situation(halved, given, given), "shade", F([1]), DRAWN, PROFILES["ieee"])
    for shader in (stand_alone(witness), stand_alone_wgsl(witness)):
        assert "0x40400000u" in shader and "WITNESS_SIZES" not in shader and "witness_texel" not in shader


def after(shader, start):
    """The rest of the statement that starts so, in one line."""
    line = " ".join(shader.split())
    return line[line.index(start) + len(start) : line.index(";", line.index(start))].strip()


def test_a_colour_is_judged_channel_by_channel():
    """Texel (1, 1) and entry 1, mixed by 9.75."""
    witness = painted_witness("tinted", F([0, 0, 0]))
    assert witness.expected.tolist() == [-27, 42.25, 189.5]
    shader = stand_alone(witness)
    ends = {
        "x": "uintBitsToFloat(0xc1d80000u)",
        "y": "uintBitsToFloat(0x42290000u)",
        "z": "uintBitsToFloat(0x433d8000u)",
    }
    parts = (f"result.tinted.{each} >= {end} && result.tinted.{each} <= {end}" for each, end in ends.items())
    assert after(shader, "bool right =") == " && ".join(parts)
    bits = ", ".join(f"floatBitsToUint(result.tinted.{each})" for each in "xyz")
    assert after(shader, "witness_bits =") == f"uvec4({bits}, 0u)"
    assert after(shader, "witness_verdict =") == "right ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0)"
    assert "// Stage painted of sss_ref at pixel 7,4 of tinted_2: draw anything over a pixel" in shader


def test_a_whole_number_is_judged_as_one():
    """The triangle is 1 and may be 0, so 0 steps may be 1, and a reach has two sides."""
    witness = painted_witness("steps", np.int32([9]), triangle=Interval(np.int32([0]), np.int32([1])))
    shader = stand_alone(witness)
    assert (
        after(shader, "bool right =")
        == "int(result.steps) >= int(0xffffffffu) && int(result.steps) <= int(0x00000001u)"
    )
    assert after(shader, "witness_bits =") == "uvec4(uint(result.steps), 0u, 0u, 0u)"


def test_the_same_in_wgsl():
    shader = stand_alone_wgsl(painted_witness("tinted", F([0, 0, 0])))
    ends = {"x": "0xc1d80000u", "y": "0x42290000u", "z": "0x433d8000u"}
    parts = (f"witness_within(bits.{each}, {end}, {end})" for each, end in ends.items())
    assert after(shader, "let right: bool =") == " && ".join(parts)
    bits = ", ".join(f"bitcast<u32>(result.tinted.{each})" for each in "xyz")
    assert after(shader, "let bits: vec4<u32> =") == f"vec4<u32>({bits}, 0u)"
    tables = "vec4<i32>(0, 1, 1, 1), vec4<i32>(1, 1, 0, 1), vec4<i32>(2, 1, 0, 1)"
    assert after(shader, "WITNESS_RUNS: array<vec4<i32>, 3> =") == f"array<vec4<i32>, 3>({tables})"
    assert after(shader, "WITNESS_FIRST: array<i32, 3> =") == "array<i32, 3>(7, 10, 13)"
    assert after(shader, "WITNESS_CHANNELS: array<i32, 3> =") == "array<i32, 3>(3, 3, 1)"
    sizes = "vec2<i32>(3, 2), vec2<i32>(2, 1), vec2<i32>(3, 1)"
    assert after(shader, "WITNESS_SIZES: array<vec2<i32>, 3> =") == f"array<vec2<i32>, 3>({sizes})"
    whole = stand_alone_wgsl(painted_witness("steps", np.int32([9])))
    assert after(whole, "let bits: vec4<u32> =") == "vec4<u32>(u32(result.steps), 0u, 0u, 0u)"
    assert after(whole, "let right: bool =") == "i32(bits.x) >= i32(0x00000000u) && i32(bits.x) <= i32(0x00000000u)"


@stage(source="a test")
def shaded(values: vec2) -> Flagged:
    """A pair, and whether its first is larger."""
    return Flagged(values, values.x > values.y)


def test_pairs_and_truth_values():
    given = {"values": vec2(F(2), F(1))}
    judged = {}
    for output, got in (("pair", F([0, 0])), ("flag", np.uint8([0]))):
        witness = Witness(Situation(shaded, given, given), output, got, DRAWN, PROFILES["ieee"])
        glsl, wgsl = stand_alone(witness), stand_alone_wgsl(witness)
        judged[output] = after(glsl, "witness_bits ="), after(wgsl, "let bits: vec4<u32> =")
        if output == "flag":
            assert after(glsl, "bool right =").startswith("int(result.flag) >= int(0x00000001u)")
    pair = (
        ", ".join(f"floatBitsToUint(result.pair.{each})" for each in "xy"),
        ", ".join(f"bitcast<u32>(result.pair.{each})" for each in "xy"),
    )
    assert judged["pair"] == (f"uvec4({pair[0]}, 0u, 0u)", f"vec4<u32>({pair[1]}, 0u, 0u)")
    assert judged["flag"] == ("uvec4(uint(result.flag), 0u, 0u, 0u)", "vec4<u32>(u32(result.flag), 0u, 0u, 0u)")
