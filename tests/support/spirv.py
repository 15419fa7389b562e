"""SPIR-V with one thing changed in it, as a compiler's mistake leaves it, and the way from GLSL through it and back.

A binary is five words and then instructions, whose first word holds their length (upper half) and their opcode
(SPIR-V 1.0, section 2.3). Glslang compiles, SPIRV-Tools says what is valid, SPIRV-Cross writes GLSL again.
"""

import re
import shutil
import struct
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

TOOLS = ("glslangValidator", "spirv-val", "spirv-cross")  # Debian: glslang-tools, spirv-tools, spirv-cross
HEAD = 5  # words before the first instruction
NAME, EXTENDED, CONSTANT, LABEL, SHUFFLE, COPY = 5, 12, 43, 248, 79, 83
RESULT_LENGTH = 5  # words of an instruction with a type, a result and two operands
OPCODES = {  # opcode -> name, of what two operands are computed from
    129: "FAdd",
    131: "FSub",
    133: "FMul",
    136: "FDiv",
    142: "VectorTimesScalar",
    145: "MatrixTimesVector",
    144: "VectorTimesMatrix",
    148: "Dot",
    167: "LogicalAnd",
    166: "LogicalOr",
    184: "FOrdLessThan",
    186: "FOrdGreaterThan",
    188: "FOrdLessThanEqual",
    190: "FOrdGreaterThanEqual",
}
ANOTHER = {129: 131, 131: 129, 133: 129, 136: 133, 166: 167, 167: 166, 184: 190, 186: 188, 188: 186, 190: 184}
FUNCTIONS = {
    8: 9,
    9: 8,
    37: 40,
    40: 37,
    31: 4,
    13: 14,
    14: 13,
    10: 8,
}  # of GLSL.std.450: floor and ceil, min and max ...
NEGATE, SELECT, EXTRACT = 127, 169, 81
FACTORS = (2.0, 0.5, -1.0)  # of a constant


@dataclass(frozen=True)
class Edit:
    """One instruction with other words. at: the index of its first word."""

    told: str
    at: int
    words: tuple[int, ...]

    def applied(self, binary: bytes) -> bytes:
        """The binary with it."""
        words = list(_words(binary))
        words[self.at : self.at + len(self.words)] = self.words
        return struct.pack(f"<{len(words)}I", *words)


def are_there() -> bool:
    """Whether all tools are installed."""
    return all(shutil.which(each) for each in TOOLS)


def instructions(binary: bytes) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Each instruction: the index of its first word, and its words."""
    words, at = _words(binary), HEAD
    while at < len(words):
        length = words[at] >> 16
        yield at, words[at : at + length]
        at += length


def _words(binary: bytes) -> tuple[int, ...]:
    return struct.unpack(f"<{len(binary) // 4}I", binary)


def edits(binary: bytes) -> list[Edit]:
    """All that are made here: of constants, operations, operands, components and functions of floats and truths."""
    floats = {each[1] for _, each in instructions(binary) if each[0] & 0xFFFF == 22}  # OpTypeFloat
    before: dict[int, list[int]] = {}  # type -> results of the block so far
    found: list[Edit] = []
    for at, each in instructions(binary):
        opcode = each[0] & 0xFFFF
        if opcode == LABEL:
            before = {}
        told = f"word {at}"
        if opcode == CONSTANT and each[1] in floats:
            found += _other_constants(at, each)
        elif opcode in OPCODES and len(each) == RESULT_LENGTH:
            found += _other_operations(at, each, before)
            before.setdefault(each[1], []).append(each[2])
        elif opcode == EXTENDED and each[4] in FUNCTIONS:
            other = FUNCTIONS[each[4]]
            words = (each[0], *each[1:4], other, *each[5:])
            if len(each) - 5 == _operands(other):
                found.append(Edit(f"{told}: function {each[4]} of GLSL.std.450 becomes {other}", at, words))
        elif opcode == SELECT:
            found.append(Edit(f"{told}: Select takes the other", at, (*each[:4], each[5], each[4])))
        elif opcode == NEGATE:
            found.append(Edit(f"{told}: FNegate becomes a copy", at, ((4 << 16) | COPY, *each[1:])))
        elif opcode == SHUFFLE and len(each) > 6:
            found.append(Edit(f"{told}: the components of a shuffle turn round", at, (*each[:5], *each[:4:-1])))
        elif opcode == EXTRACT and len(each) == RESULT_LENGTH and each[1] in floats:
            found.append(Edit(f"{told}: component {each[4]} becomes {each[4] ^ 1}", at, (*each[:4], each[4] ^ 1)))
    return found


def _operands(function: int) -> int:
    """How many a function of GLSL.std.450 has."""
    return 2 if function in (37, 40) else 1


def _other_constants(at: int, each: tuple[int, ...]) -> Iterator[Edit]:
    value = np.uint32(each[3]).view(np.float32)
    for factor in FACTORS:
        other = np.float32(value * np.float32(factor)) if value else np.float32(1)
        if other != value:
            bits = int(other.view(np.uint32))
            yield Edit(f"word {at}: constant {value:g} becomes {other:g}", at, (*each[:3], bits))


def _other_operations(at: int, each: tuple[int, ...], before: dict[int, list[int]]) -> Iterator[Edit]:
    """Another opcode, its operands the other way round where that is valid, and another operand of the same type."""
    opcode = each[0] & 0xFFFF
    name = OPCODES[opcode]
    if opcode in ANOTHER:
        words = ((RESULT_LENGTH << 16) | ANOTHER[opcode], *each[1:])
        yield Edit(f"word {at}: {name} becomes {OPCODES[ANOTHER[opcode]]}", at, words)
    if name in ("FSub", "FDiv", "FOrdLessThan", "FOrdGreaterThan") and each[3] != each[4]:
        yield Edit(f"word {at}: {name} with its operands swapped", at, (*each[:3], each[4], each[3]))
    if name in ("FMul", "FAdd"):
        for other in before.get(each[1], [])[-1:]:
            if other not in each[3:]:
                yield Edit(f"word {at}: {name} reads %{other} for %{each[4]}", at, (*each[:4], other))


def compiled(source: Path, folder: Path) -> bytes:
    """The SPIR-V of a file in GLSL, named .vert or .frag, as OpenGL takes it."""
    target = folder / f"{source.name}.spv"
    _run("glslangValidator", "-G", "--aml", "--amb", "-o", target, source)
    return target.read_bytes()


def glsl(binary: bytes) -> str | None:
    """GLSL again; None for a binary that is not valid."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "edited.spv"
        path.write_bytes(binary)
        if _run("spirv-val", path, check=False).returncode:
            return None
        text = _run("spirv-cross", "--version", "400", "--no-es", "--no-420pack-extension", path).stdout
    return re.sub(r"^layout\(binding = \d+\) ", "", text, flags=re.MULTILINE)  # uniforms have names, and no places


def _run(*words: object, check: bool = True) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*map(str, words)], capture_output=True, text=True, check=check, timeout=60)
