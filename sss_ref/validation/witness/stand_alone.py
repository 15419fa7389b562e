"""A witness as a shader that reads nothing: it runs the stage on the bits and judges what that gives.

Anyone who has a driver can run it: whatever covers a pixel, that pixel is green if the stage gives what it may and red
if not, and a second target gets the bits. No compiler can work out the answer beforehand: all bits are combined with a
uniform that nobody sets and that is therefore 0.
"""

from dataclasses import replace
from pathlib import Path

from sss_ref.errors import DumpError
from sss_ref.errors.text_file import write_text
from sss_ref.interpret.shader import GLSL, Dialect, Library
from sss_ref.interpret.shader.text import braced, comment, joined
from sss_ref.language.layout import CHANNELS
from sss_ref.language.types import vec2, vec3, vec4
from sss_ref.numerics.inward import no_farther
from sss_ref.validation.witness.bits_text import WHOLE, bits_of
from sss_ref.validation.witness.shader_words import BOOLS, FLOATS, INTS, ShaderWords
from sss_ref.validation.witness.witness import Witness, as_value

VERDICT, BITS = "witness_verdict", "witness_bits"  # the outputs
GREEN, RED = "vec4(0.0, 1.0, 0.0, 1.0)", "vec4(1.0, 0.0, 0.0, 1.0)"
OUTPUTS = [f"layout(location = 0) out vec4 {VERDICT};", f"layout(location = 1) out uvec4 {BITS};"]
RUNNERS = ".shader_test"  # the suffix of such tests
RUNNER = """[require]
GL >= 4.0
GLSL >= 4.00

[vertex shader passthrough]

[fragment shader]
{shader}
[test]
clear color 0.0 0.0 1.0 1.0
clear
draw rect -1 -1 2 2
probe all rgba 0.0 1.0 0.0 1.0
"""


def stand_alone(witness: Witness, dialect: Dialect = GLSL) -> str:
    """The fragment shader, in GLSL or ESSL.

    The stage gets the reference's value of what the witness knows no better than by an interval. What a result may be
    is told for float32: no storage rounds it.
    """
    reading, situation = _from_words(dialect), witness.situation
    library, words = Library(reading), ShaderWords.of(situation, situation.reads(witness.profile))
    library.stage(situation.stage, {})
    arguments = ", ".join(words.argument(own, kind, reading) for own, kind in situation.stage.parameters.items())
    call = f"{reading.name(situation.stage.name)}({arguments})"
    lines = [f"{situation.stage.result_struct.__name__} result = {call};", *_judging(witness, reading)]
    head = [*reading.head, *comment(_about(witness))]
    return joined([head, OUTPUTS, words.lines, library.text.splitlines(), braced("void main()", lines)])


def write_stand_alone(witness: Witness, path: Path) -> Path:
    """Write the shader, or a test for Piglit's shader_runner if the file is called so; returns its path.

    Raises DumpError where it cannot be written.
    """
    shader = stand_alone(witness)
    return write_text(path, RUNNER.format(shader=shader) if path.suffix == RUNNERS else shader, DumpError)


def _from_words(dialect: Dialect) -> Dialect:
    """The dialect where textures and arrays are numbers of tables of words."""
    tables = {int: INTS, bool: BOOLS, **dict.fromkeys((float, vec2, vec3, vec4), FLOATS)}
    calls = {**dialect.calls, "size": "witness_size({0})"}
    texel, element = "witness_texel({0}, {1})", "witness_texel({0}, ivec2({1}, 0))"
    return replace(dialect, textures=tables, calls=calls, texel=texel, element=element)


def _about(witness: Witness) -> str:
    drawn, stage = witness.drawn, witness.situation.stage
    return (
        f"Stage {stage.name} of sss_ref at pixel {drawn.at[0]},{drawn.at[1]} of {drawn.buffer}: draw anything over a "
        f"pixel and leave the uniform as it is, 0. Green: {witness.output} lies where it may. Red: it does not.\n"
        f"{BITS} has its bits, whether or not anybody keeps them."
    )


def _judging(witness: Witness, dialect: Dialect) -> list[str]:
    """Whether each component of the output lies in its interval, and its bits."""
    kind = witness.kind
    ends = [bits_of(kind, as_value(kind, end)).split() for end in no_farther(witness.expected, witness.known.reach[0])]
    output = f"result.{dialect.name(witness.output)}"
    parts = [output] if CHANNELS[kind] == 1 else [f"{output}.{letter}" for letter in "xyzw"[: CHANNELS[kind]]]
    holds = [_within(kind, part, low, high) for part, low, high in zip(parts, *ends, strict=True)]
    shown = [_bits(kind, part) for part in parts] + ["0u"] * (4 - len(parts))
    return [
        f"bool right = {' && '.join(holds)};",
        f"{VERDICT} = right ? {GREEN} : {RED};",
        f"{BITS} = uvec4({', '.join(shown)});",
    ]


def _within(kind: object, part: str, low: str, high: str) -> str:
    ends = (f"uintBitsToFloat(0x{end}u)" if kind not in WHOLE else f"int(0x{end}u)" for end in (low, high))
    least, most = ends
    value = f"int({part})" if kind in WHOLE else part
    return f"{value} >= {least} && {value} <= {most}"


def _bits(kind: object, part: str) -> str:
    return f"uint({part})" if kind in WHOLE else f"floatBitsToUint({part})"
