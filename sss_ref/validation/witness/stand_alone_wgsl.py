"""A witness as WGSL that reads nothing: a vertex and a fragment shader in one file, as `stand_alone` is GLSL.

WGSL has no overloads, so there is a function for each type of texel. A compiler may take it that there are no NaNs
(section 15.7.2), so the verdict compares bits. What no compiler can work out beforehand is the number of the instance,
which is 0.
"""

from dataclasses import replace
from pathlib import Path

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text
from sss_ref.interpret.shader import WGSL, Library
from sss_ref.interpret.shader.text import comment, joined
from sss_ref.language.layout import CHANNELS
from sss_ref.numerics.inward import no_farther
from sss_ref.validation.witness.bits_text import WHOLE, bits_of
from sss_ref.validation.witness.shader_words import ABSENT, ShaderWords
from sss_ref.validation.witness.witness import Witness, as_value

VERTEX, FRAGMENT = "witness_vertex", "witness_fragment"  # the entry points
TABLES = replace(
    WGSL,
    textures=dict.fromkeys(WGSL.textures, "i32"),  # a texture or array is the number of its table
    calls={**WGSL.calls, "size": "WITNESS_SIZES[{0}]"},
    texel="witness_texel_{2}({0}, {1})",
    element="witness_texel_{2}({0}, vec2<i32>({1}, 0))",
    four_channels=False,
)
WORD = """
var<private> witness_nothing: u32;

fn witness_word(k: i32) -> u32
{
    return select(WITNESS_WORDS[max(k, 0)] ^ witness_nothing, 0x7fc00000u, k < 0);
}

fn witness_float(k: i32) -> f32
{
    return bitcast<f32>(witness_word(k));
}

// Bits of floats as numbers in the same order, both zeros alike; NaNs lie beyond the infinities.
fn witness_order(bits: u32) -> u32
{
    let magnitude: u32 = bits & 0x7fffffffu;
    return select(0x80000000u + magnitude, 0x80000000u - magnitude, bits > 0x7fffffffu);
}

fn witness_within(bits: u32, low: u32, high: u32) -> bool
{
    return witness_order(bits) >= witness_order(low) && witness_order(bits) <= witness_order(high);
}
"""
TEXELS = f"""
fn witness_place(map: i32, at: vec2<i32>) -> i32
{{
    for (var k: i32 = 0; k < WITNESS_RUN_COUNT; k++)
    {{
        let run: vec4<i32> = WITNESS_RUNS[k];
        let further: i32 = at.x - run.y;
        if (run.x == map && run.z == at.y && further >= 0 && further < run.w)
        {{
            return WITNESS_FIRST[k] + further * WITNESS_CHANNELS[map];
        }}
    }}
    return {ABSENT};
}}

fn witness_texel_bool(map: i32, at: vec2<i32>) -> u32
{{
    return witness_word(witness_place(map, at));
}}

fn witness_texel_int(map: i32, at: vec2<i32>) -> i32
{{
    return i32(witness_word(witness_place(map, at)));
}}

fn witness_texel_float(map: i32, at: vec2<i32>) -> f32
{{
    return witness_float(witness_place(map, at));
}}

fn witness_texel_vec2(map: i32, at: vec2<i32>) -> vec2<f32>
{{
    let k: i32 = witness_place(map, at);
    return vec2<f32>(witness_float(k), witness_float(k + 1));
}}

fn witness_texel_vec3(map: i32, at: vec2<i32>) -> vec3<f32>
{{
    let k: i32 = witness_place(map, at);
    return vec3<f32>(witness_float(k), witness_float(k + 1), witness_float(k + 2));
}}

fn witness_texel_vec4(map: i32, at: vec2<i32>) -> vec4<f32>
{{
    let k: i32 = witness_place(map, at);
    return vec4<f32>(witness_float(k), witness_float(k + 1), witness_float(k + 2), witness_float(k + 3));
}}
"""
SHADERS = """
struct WitnessCorner
{{
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) nothing: u32,
}}

struct WitnessTargets
{{
    @location(0) verdict: vec4<f32>,
    @location(1) bits: vec4<u32>,
}}

@vertex
fn {vertex}(@builtin(vertex_index) k: u32, @builtin(instance_index) instance: u32) -> WitnessCorner
{{
    let corner: vec2<f32> = vec2<f32>(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0;
    return WitnessCorner(vec4<f32>(corner, 0.0, 1.0), instance);
}}

@fragment
fn {fragment}(corner: WitnessCorner) -> WitnessTargets
{{
    witness_nothing = corner.nothing;
    let result = {call};
    let bits: vec4<u32> = vec4<u32>({bits});
    let right: bool = {right};
    let verdict: vec4<f32> = select(vec4<f32>(1.0, 0.0, 0.0, 1.0), vec4<f32>(0.0, 1.0, 0.0, 1.0), right);
    return WitnessTargets(verdict, bits);
}}
"""
ABOUT = """\
Stage {stage} of sss_ref at pixel {column},{row} of {buffer}. Draw three vertices, with nothing bound, into a target:
device.createRenderPipeline({{layout: "auto", vertex: {{module, entryPoint: "{vertex}"}}, fragment: {{module,
    entryPoint: "{fragment}", targets: [{{format: "rgba8unorm"}}]}}}})
Green: {output} lies where it may. Red: it does not. A second target, of rgba32uint, gets its bits."""


def stand_alone_wgsl(witness: Witness) -> str:
    """The shaders; what the stage is given, and what it may give, is as `stand_alone` has it."""
    stage, situation = witness.situation.stage, witness.situation
    library, words = Library(TABLES), ShaderWords.of(situation, situation.reads(witness.profile))
    library.stage(stage, {})
    arguments = ", ".join(words.argument(own, kind, TABLES) for own, kind in stage.parameters.items())
    call = f"{TABLES.name(stage.name)}({arguments})"
    shaders = SHADERS.format(vertex=VERTEX, fragment=FRAGMENT, call=call, bits=_bits(witness), right=_right(witness))
    tables = [*_tables(words), *TEXELS.splitlines()] if words.tables else []
    listed = _array("u32", "WORDS", [f"0x{word}u" for word in words.words or ["0"]])
    code = [[listed, *WORD.splitlines(), *tables], library.text.splitlines(), shaders.strip().splitlines()]
    return joined([comment(_about(witness)), *code])


def write_stand_alone_wgsl(witness: Witness, path: Path) -> Path:
    """Write the shaders; returns the path. Raises DumpError where they cannot be written."""
    return write_text(path, stand_alone_wgsl(witness), DumpError)


def _about(witness: Witness) -> str:
    drawn, (column, row) = witness.drawn, witness.drawn.at
    names = {"stage": witness.situation.stage.name, "buffer": drawn.buffer, "output": witness.output}
    return ABOUT.format(column=column, row=row, vertex=VERTEX, fragment=FRAGMENT, **names)


def _tables(words: ShaderWords) -> list[str]:
    """Where the words of textures and arrays are."""
    tables = list(words.tables.values())
    return [
        _array("vec2<i32>", "SIZES", [f"vec2<i32>{each.size}" for each in tables]),
        _array("i32", "CHANNELS", [str(each.channels) for each in tables]),
        _array("vec4<i32>", "RUNS", [f"vec4<i32>{run[:4]}" for run in words.runs]),
        _array("i32", "FIRST", [str(run[4]) for run in words.runs]),
        f"const WITNESS_RUN_COUNT: i32 = {len(words.runs)};",
    ]


def _bits(witness: Witness) -> str:
    """The bits of the output, in four words."""
    kind, output = witness.kind, f"result.{TABLES.name(witness.output)}"
    parts = [output] if CHANNELS[kind] == 1 else [f"{output}.{letter}" for letter in "xyzw"[: CHANNELS[kind]]]
    form = "u32({})" if kind in WHOLE else "bitcast<u32>({})"
    return ", ".join([form.format(part) for part in parts] + ["0u"] * (4 - len(parts)))


def _right(witness: Witness) -> str:
    """Whether the bits lie in their intervals, one a component."""
    kind = witness.kind
    ends = [bits_of(kind, as_value(kind, end)).split() for end in no_farther(witness.expected, witness.known.reach[0])]
    form = "i32(bits.{0}) >= i32(0x{1}u) && i32(bits.{0}) <= i32(0x{2}u)"
    form = form if kind in WHOLE else "witness_within(bits.{0}, 0x{1}u, 0x{2}u)"
    return " && ".join(form.format(*each) for each in zip("xyzw", *ends, strict=False))


def _array(kind: str, name: str, values: list[str]) -> str:
    """A table that may be indexed by what is only known later: a variable, which nobody changes."""
    whole = f"array<{kind}, {len(values)}>"
    return f"var<private> WITNESS_{name}: {whole} = {whole}({', '.join(values)});"
